// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "framework/scripting/spec.hpp"

namespace trocar::cli {

/// A test of a file, and after it has run what came of it.
struct SpecResult {
  std::string file;
  SpecTest test;
  std::size_t index = 0;  // in its file
  std::vector<SpecFailure> failures{};
  std::string output{};  // what it printed
  double seconds = 0.0;  // of real time

  bool passed() const { return failures.empty(); }
};

struct SpecRunOptions {
  SpecOptions spec{};
  std::size_t at_once = 0;  // 0: as many as there are processors
  double timeout = 60.0;    // [s] of real time for each test
};

/// Files that are given, and those named *_spec.lua in folders that are given, by name.
/// @throw std::invalid_argument where there is none
std::vector<std::string> find_specs(const std::vector<std::string>& paths);

/// The tests of all files, each read in a process of its own.
/// @param broken gets what is wrong with files
std::vector<SpecResult> list_specs(const std::vector<std::string>& files,
                                   const SpecRunOptions& options, Findings& broken);

/// Runs each test in a process of its own.
/// @param told each, in the order of the list, as soon as it and those before it have ended
void run_specs(std::vector<SpecResult>& tests, const SpecRunOptions& options,
               const std::function<void(const SpecResult&)>& told);

/// As continuous integration reads it: JUnit's XML, a suite for each file.
std::string junit_xml(const std::vector<SpecResult>& results);

}  // namespace trocar::cli
