// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "framework/realtime/mailbox.hpp"
#include "framework/run_control.hpp"
#include "framework/stream/client_message.hpp"
#include "plugins/foxglove/call_desk.hpp"

namespace trocar::foxglove {

/// Carries what clients ask from the server's thread to the one that may control a run, and the
/// answers back.
class Desk {
 public:
  explicit Desk(CallDesk& calls) : calls_(calls) {}

  struct Call {
    stream::CallService what;
    std::string name;  // of the service
  };
  struct Request {
    std::uint64_t client = 0;
    std::variant<stream::GetParameters, stream::SetParameters, Call> what;
    std::int64_t asked_ns = 0;  // monotonic
  };
  struct Answer {
    std::uint64_t client = 0;
    std::string text;                         // "" when there is none
    std::vector<std::byte> bytes;             // or these
    std::vector<stream::NamedValue> changed;  // for all who watch parameters
  };

  // By the server:
  /// @return false when too many wait already
  bool ask(Request request) { return requests_.put(std::move(request)); }
  std::deque<Answer> take_answers() { return answers_.take_all(); }
  /// Where nobody controls a run for a second, what was asked is refused.
  void refuse_overdue(std::int64_t now_ns);

  // By the thread that controls a run:
  bool operate(RunControl& control);

 private:
  void answer(const Request& request, RunControl& control);
  Answer answer_get(const stream::GetParameters& get, RunControl& control) const;
  /// What could be set is; `wrong` says what could not.
  Answer answer_set(const stream::SetParameters& set, RunControl& control,
                    std::string& wrong) const;

  CallDesk& calls_;
  Mailbox<Request> requests_{1024};
  Mailbox<Answer> answers_{65536};
};

/// As parameters of the protocol: numbers in SI, all else as a script would write it.
stream::ParameterValue value_of(const ParameterState& parameter);

}  // namespace trocar::foxglove
