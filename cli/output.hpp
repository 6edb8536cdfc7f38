// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace trocar::cli {

/// Makes a reader that closed its end (`trocar list | head -1`) an error of write() instead of the
/// program's death, so that a run can still close its log.
void ignore_broken_pipes();

/// Writes to standard output. Once somebody closed it, the rest is dropped.
void print(std::string_view text);
/// Indented, with a line's end. Text that is no UTF-8 is mended.
void print_json(const nlohmann::ordered_json& json);
/// To a file, or to standard output for "-".
/// @throw std::runtime_error when the file cannot be written
void write_output(const std::string& path, std::string_view text);
/// Whether whoever reads standard output is still there.
bool output_open();

/// "trocar: text" on standard error, behind what was printed.
void complain(std::string_view text);

/// Flushes. @return `status`, or 1, with a complaint, when what was printed did not arrive for
/// another reason than that the reader had enough
int finish_output(int status);

/// `text` in quotes for a message: control characters escaped, cut when long.
std::string in_quotes(std::string_view text);

}  // namespace trocar::cli
