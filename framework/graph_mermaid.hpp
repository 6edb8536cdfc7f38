// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/graph_picture.hpp"

namespace trocar {

/// The picture as a Mermaid flowchart, which GitHub and GitLab draw in Markdown between ```mermaid
/// and ```: left to right, a later tick dotted. Source:
/// https://mermaid.js.org/syntax/flowchart.html.
std::string graph_mermaid(const GraphPicture& picture);

}  // namespace trocar
