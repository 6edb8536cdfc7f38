// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/command.hpp"
#include "framework/replaceable.hpp"
#include "framework/wired_graph.hpp"

namespace trocar {

class Reloads;

/// A reload on its way, and what came of it.
class ReloadTicket {
 public:
  ReloadTicket(Reloads& all, Reload reload, Replaceable& part, const char* owner);

  /// Makes the version ready, after what the loop has released was freed.
  /// @param time [s] of the run
  void prepare(double time);
  /// In the loop: from the next step on. For a version that is ready.
  void replace() RT_SAFE { part_.replace(*version_); }
  bool ready() const RT_SAFE { return version_ != nullptr; }
  const char* owner() const RT_SAFE { return owner_; }
  /// Why it was refused; lives as long as the ticket.
  const char* trouble() const RT_SAFE { return verdict_.trouble.c_str(); }

  /// Frees a version that the loop has released. @return whether it did
  bool collect();
  const ReloadVerdict& verdict() const { return verdict_; }

 private:
  Reloads& all_;
  Reload reload_;
  Replaceable& part_;
  const char* owner_;  // the component's name
  std::unique_ptr<Replacement> version_;
  ReloadVerdict verdict_{};
};

/// The reloads of a run: which components have parts that can be replaced, and what came of each.
class Reloads {
 public:
  explicit Reloads(const WiredGraph& wired);

  struct Part {
    std::string component;
    std::string file;
  };
  std::vector<Part> parts() const;

  struct Issued {
    ReloadTicket* ticket = nullptr;
    std::size_t group = 0;  // whose thread it belongs to
  };
  /// @throw std::invalid_argument for a component without such a part, with the nearest one
  Issued issue(Reload reload);
  /// Frees what the loop has released.
  void collect();
  /// Of reloads that the loop has given up since the last call.
  std::vector<ReloadVerdict> take_troubles();
  /// In the order in which they were issued, when the loop has ended.
  std::vector<ReloadVerdict> verdicts();

 private:
  struct Place {
    Replaceable* part = nullptr;
    const char* owner = "";
    std::size_t group = 0;
  };
  std::map<std::string, Place, std::less<>> places_;
  std::deque<ReloadTicket> tickets_;
  std::vector<ReloadVerdict> troubles_;
};

}  // namespace trocar
