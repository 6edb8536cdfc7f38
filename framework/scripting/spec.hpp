// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "framework/finding.hpp"
#include "framework/realtime/stop_flag.hpp"
#include "framework/registry.hpp"

/// @file
/// Specs: Lua files that describe what scripts and fixtures should do, in virtual time. Each test
/// runs in a Lua state of its own, for which the whole file is read again: no test can leave
/// anything behind for another one.

namespace trocar {

/// An `it` of a spec file, with the names of the `describe`s around it: "membrane: tears once".
struct SpecTest {
  std::string name;
  Where where;
};

/// What was expected of a value or a signal, and what was found.
struct SpecFailure {
  Where where{};
  std::string message{};   // in words where there is no value to compare
  std::string expected{};  // "membrane.force.z <= 0 N, always"
  std::string got{};       // "0.35 N at 0.412 s"
  std::int64_t tick = -1;  // of the signal's thread, -1 where there is none
  std::string plot{};      // of the signal around that row

  std::string text() const;
};

struct SpecOptions {
  std::optional<std::uint64_t> seed{};  // of everything random; wins over the script's
  const StopFlag* stop = nullptr;
};

/// The tests of a file, in its order.
/// @throw BrokenGraph when the file cannot be read or ends with an error
std::vector<SpecTest> list_spec(const Registry& registry, const std::string& path);

/// Runs one of them. Besides what it expects, these are failures: an error, a mistake in a graph, a
/// fault of a run that the test never looked at, and a test that expects nothing.
/// @param index in list_spec()
/// @throw BrokenGraph as list_spec()
std::vector<SpecFailure> run_spec(const Registry& registry, const std::string& path,
                                  std::size_t index, const SpecOptions& options = {});

}  // namespace trocar
