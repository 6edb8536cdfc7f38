// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace trocar::bench {

/// A kind of graph that grows: what grows in it, and a script of as many components as asked for.
struct ScaleShape {
  const char* name;
  const char* what;
  std::string (*script)(int components);
};

const std::vector<ScaleShape>& scale_shapes();

}  // namespace trocar::bench
