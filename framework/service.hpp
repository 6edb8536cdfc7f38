// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace trocar {

class RowSink;
class RunControl;
class StopFlag;

/// What a service is told of a run that is about to begin.
struct ServiceRun {
  bool virtual_time = false;
  std::string graph{};             // as `trocar graph --format json` gives it
  std::string recording{};         // the session's log, or ""
  const StopFlag* stop = nullptr;  // somebody wants an end
};

/// Somebody beside a session for people or programs elsewhere, who look at its runs and intervene:
/// a live stream. It lives from before the first run until after the last, has whatever threads it
/// needs, and is never waited for by a loop.
class Service {
 public:
  Service() = default;
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;
  virtual ~Service() = default;

  /// One line for whoever started it: where it is to be found.
  virtual std::string greeting() const = 0;
  /// A text that the session has read: its script and what that requires.
  virtual void add_script(const std::string& /*name*/, const std::string& /*text*/) {}
  /// Before each run; may wait until somebody wants it to begin.
  virtual void prepare(const ServiceRun& /*run*/) {}
  /// Who takes the rows and events of every run, one after the other.
  virtual RowSink& rows() = 0;
  /// In real time, some hundred times a second while a run lasts, always from one thread:
  /// what was asked from elsewhere. @return whether there was something to do
  virtual bool operate(RunControl& control) = 0;
  /// In real time, from the same thread: the session's log takes no more rows, and the run goes on.
  virtual void recording_failed(const std::string& /*why*/) {}
};

/// What is known of a service without starting one.
struct ServiceType {
  /// As a user wrote them: "address" is "127.0.0.1:8765".
  using Settings = std::map<std::string, std::string>;

  std::string name;  // as --serve calls it: "foxglove"
  std::string doc;   // one line
  /// Starts one.
  /// @throw std::invalid_argument for a setting that does not exist or does not fit
  /// @throw std::runtime_error when it cannot do its work: the address is in use
  std::function<std::unique_ptr<Service>(const Settings&)> start;
  std::string plugin{};  // that brought it; "" for one of Trocar's own
};

}  // namespace trocar
