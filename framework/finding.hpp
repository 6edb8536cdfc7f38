// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace trocar {

/// A line of a script, or an option of the command line ("--set", line 0).
struct Where {
  std::string file;
  int line = 0;

  std::string text() const;
  bool operator==(const Where&) const = default;
};

/// One thing that is wrong with a graph: where, and what to do about it.
struct Finding {
  Where where;
  std::string message;

  std::string text() const;  // "wall.lua:3: wall.stiffness = …"
};

/// All that is wrong with a graph, gathered so that one report tells everything.
class Findings {
 public:
  /// The same finding twice is kept once.
  void add(const Where& where, std::string message);
  bool empty() const { return all_.empty(); }
  const std::vector<Finding>& all() const { return all_; }
  /// Each file's in the order of its lines, files in the order in which they appear.
  Findings by_line() const;
  std::string text() const;

 private:
  std::vector<Finding> all_;
};

/// Thrown by those who need a sound graph.
struct BrokenGraph : std::runtime_error {
  explicit BrokenGraph(const Findings& all)
      : std::runtime_error(all.by_line().text()), findings(all.by_line()) {}
  Findings findings;
};

}  // namespace trocar
