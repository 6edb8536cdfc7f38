// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/graph_picture.hpp"

namespace trocar::test {

/// Whatever a notation could take for its own.
constexpr const char* odd_text =
    "\"#quot;\" &amp; <i>a</i> `b` *c* [d] {e} (f) |g| %%{h}%% \\n $$i$$ end; style x:#1; µ → é";

/// One box of that text.
inline GraphPicture odd_picture() {
  GraphPicture picture;
  picture.boxes.push_back({.name = "end", .title = odd_text, .type = ""});
  return picture;
}

/// A device in a group, its gate, a fixture: names that are keywords somewhere.
inline GraphPicture small_picture() {
  using Picture = GraphPicture;
  Picture picture;
  picture.clusters.push_back({.name = "graph", .title = "graph", .type = "Rig", .inside = {}});
  picture.boxes = {
      {.name = "graph.end",
       .title = "end",
       .type = "Motor",
       .shape = Picture::Shape::device,
       .inside = 0},
      {.name = "node", .title = "node", .type = "Wall", .notes = {"100 Hz, phase 3"}},
      {.name = "graph.end", .title = "gate", .type = "", .shape = Picture::Shape::gate}};
  picture.arrows = {
      {.from = 0, .to = 1, .labels = {{"tip → at", "Vector3 [m]"}, {"speed", "double [m/s]"}}},
      {.from = 1, .to = 2, .line = Picture::Line::later_tick, .labels = {{"effort", "Joints [N]"}}},
      {.from = 2, .to = 0, .line = Picture::Line::later_tick, .labels = {{"GatedEffort", ""}}}};
  return picture;
}

}  // namespace trocar::test
