// SPDX-License-Identifier: Apache-2.0
#include "cli/output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "cli/commands.hpp"

namespace trocar::cli {
namespace {

int write_error = 0;  // errno of the first write that failed

void note_error(bool written) {
  if (!written && write_error == 0) write_error = errno;
}

}  // namespace

void ignore_broken_pipes() {
  std::signal(SIGPIPE, SIG_IGN);
}

void print(std::string_view text) {
  if (write_error != 0) return;
  note_error(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void print_json(const nlohmann::ordered_json& json) {
  print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
}

void write_output(const std::string& path, std::string_view text) {
  if (path == "-") return print(text);
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.flush();
  if (!file) throw std::runtime_error("cannot write " + in_quotes(path));
}

bool output_open() {
  return write_error == 0;
}

void complain(std::string_view text) {
  note_error(std::fflush(stdout) == 0);
  const std::string line = fmt::format("trocar: {}\n", text);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

int finish_output(int status) {
  note_error(std::fflush(stdout) == 0);
  if (write_error == 0 || write_error == EPIPE) return status;
  complain("cannot write the output: " + std::generic_category().message(write_error));
  return status == success ? static_cast<int>(failed) : status;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;  // [B]
  std::string result = "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool starts_character = (c & 0xc0) != 0x80;
    if (i >= longest && starts_character) return result + "…\"";
    if (c < 0x20 || c == 0x7f)
      result += fmt::format("\\x{:02x}", c);
    else
      result += text[i];
  }
  return result + '"';
}

}  // namespace trocar::cli
