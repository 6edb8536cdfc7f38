// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_dot.hpp"

#include <fmt/format.h>

namespace trocar {
namespace {

using Picture = GraphPicture;

/// A text inside of an HTML-like label.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result;
}

std::string small(std::string_view text) {
  return fmt::format("<font point-size=\"10\" color=\"#5f6368\">{}</font>", escaped(text));
}

std::string id_of(const Picture::Box& box) {
  return box.shape == Picture::Shape::gate ? fmt::format("\"gate of {}\"", box.name)
                                           : fmt::format("\"{}\"", box.name);
}

const char* look_of(Picture::Shape shape) {
  switch (shape) {
    case Picture::Shape::component:
      return "";
    case Picture::Shape::device:
      return ", fillcolor=\"#dbe9f9\", color=\"#3b6ea5\"";
    case Picture::Shape::gate:
      return ", shape=hexagon, style=filled, fillcolor=\"#fde3d3\", color=\"#b5541c\"";
  }
  return "";
}

const char* look_of(Picture::Line line) {
  switch (line) {
    case Picture::Line::same_tick:
      return "";
    case Picture::Line::later_tick:
      return ", style=dotted";
    case Picture::Line::other_thread:
      return ", style=dashed, penwidth=1.5, color=\"#7a3fa0\"";
  }
  return "";
}

std::string label_of(const Picture::Box& box) {
  std::string label = fmt::format("<b>{}</b>", escaped(box.title));
  if (!box.type.empty()) label += "<br/>" + small(box.type);
  for (const std::string& note : box.notes) label += "<br/>" + small(note);
  return label;
}

/// A type stands below its port, which keeps the picture narrow, or behind it where there are more.
std::string label_of(const Picture::Arrow& arrow) {
  const char* between = arrow.labels.size() == 1 ? "<br align=\"left\"/>" : "  ";
  std::string label;
  for (const Picture::Label& each : arrow.labels) {
    label += escaped(each.ports);
    if (!each.type.empty()) label += between + small(each.type);
    label += "<br align=\"left\"/>";
  }
  return label;
}

std::string title_of(const Picture::Cluster& cluster) {
  const std::string title = fmt::format("<b>{}</b>", escaped(cluster.title));
  return cluster.type.empty() ? title : title + "  " + small(cluster.type);
}

/// What lies in a cluster, or, without one, at the top.
std::string contents(const Picture& picture, std::optional<std::size_t> cluster, int depth) {
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  std::string text;
  for (const Picture::Part& part : picture.parts_of(cluster)) {
    if (part.is_cluster) {
      const Picture::Cluster& inner = picture.clusters[part.index];
      text += fmt::format("{0}subgraph \"cluster {1}\" {{\n{0}  label=<{2}>;\n{3}{0}}}\n", indent,
                          inner.name, title_of(inner), contents(picture, part.index, depth + 1));
    } else {
      const Picture::Box& box = picture.boxes[part.index];
      text += fmt::format("{}{} [label=<{}>{}];\n", indent, id_of(box), label_of(box),
                          look_of(box.shape));
    }
  }
  return text;
}

}  // namespace

std::string graph_dot(const GraphPicture& picture) {
  std::string text =
      "digraph trocar {\n"
      "  rankdir=LR; newrank=true; nodesep=0.35; ranksep=0.4; fontname=\"Helvetica\"; "
      "fontsize=13;\n"
      "  labeljust=l; style=\"rounded,filled\"; fillcolor=\"#f6f7f9\"; color=\"#c4c9d0\";\n"
      "  node [fontname=\"Helvetica\", fontsize=13, shape=box, style=\"rounded,filled\",\n"
      "        fillcolor=white, color=\"#5f6368\"];\n"
      "  edge [fontname=\"Helvetica\", fontsize=11, color=\"#5f6368\", arrowsize=0.7];\n";
  text += contents(picture, std::nullopt, 1);
  for (const Picture::Arrow& arrow : picture.arrows)
    text += fmt::format("  {} -> {} [label=<{}>{}{}];\n", id_of(picture.boxes[arrow.from]),
                        id_of(picture.boxes[arrow.to]), label_of(arrow), look_of(arrow.line),
                        arrow.back ? ", constraint=false" : "");
  return text + "}\n";
}

}  // namespace trocar
