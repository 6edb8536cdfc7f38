// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/graph_picture.hpp"

namespace trocar {

/// The picture in Graphviz's language, for `dot -Tsvg`: left to right, a later tick dotted. Source:
/// https://graphviz.org/doc/info/lang.html and shapes.html#html.
std::string graph_dot(const GraphPicture& picture);

}  // namespace trocar
