// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "framework/recording/mcap_reader.hpp"

namespace trocar::gui {

/// Why a figure cannot be drawn: what is needed, and what there is.
class FigureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A table of numbers whose first line names the columns; an empty cell is NaN.
struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;

  const std::vector<double>* column(const std::string& name) const;  // null when there is none
};

/// @throw FigureError with the line that is wrong
NumberTable read_csv(const std::string& text);

/// What a figure is drawn from: a log, what `trocar run --json` wrote, or a table as CSV.
class ResultFile {
 public:
  /// @throw FigureError when it is none of them, std::runtime_error when it cannot be read
  explicit ResultFile(const std::string& path);

  const std::string& path() const { return path_; }
  const McapReader* log() const { return log_ ? &*log_ : nullptr; }
  const NumberTable* table() const { return table_ ? &*table_ : nullptr; }
  /// By name, in the order in which the names came; each with its rows.
  const std::vector<std::pair<std::string, nlohmann::json>>& published() const {
    return published_;
  }
  /// The log's graph.json (docs/log-format.md); null where there is none.
  const nlohmann::json& graph() const { return graph_; }

  /// Signals of a log's thread as columns; "time" is in s.
  /// @param run of the session, from 1 on
  /// @param thread "" for the first
  /// @throw FigureError naming the signals that are missing, and those that are like them
  std::map<std::string, std::vector<double>> signals_of(const std::vector<std::string>& names,
                                                        int run, const std::string& thread) const;
  /// What is in the file, for messages: "a log with rows of /main; published: chirp (1 row)".
  std::string contents() const;

 private:
  void read_log();
  void read_report(const std::string& text);
  const McapChannel& rows_of(int run, const std::string& thread) const;
  std::vector<std::string> row_topics() const;

  std::string path_;
  std::optional<McapReader> log_;
  std::optional<NumberTable> table_;
  std::vector<std::pair<std::string, nlohmann::json>> published_;
  nlohmann::json graph_;
};

}  // namespace trocar::gui
