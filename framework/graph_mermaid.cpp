// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_mermaid.hpp"

#include <fmt/format.h>

#include <cctype>

namespace trocar {
namespace {

using Picture = GraphPicture;

/// A text inside of quotes. Mermaid reads #NUMBER; as a character; what it, HTML or Markdown could
/// take for their own is written so.
std::string in_mermaid(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte >= 0x80 || std::isalnum(byte) != 0 ||
                       std::string_view(" .,()[]{}=+-/^!?'_").find(c) != std::string_view::npos;
    if (byte < 0x20 || byte == 0x7f)
      result += ' ';
    else if (plain)
      result += c;
    else
      result += fmt::format("#{};", static_cast<unsigned>(byte));
  }
  return result;
}

/// A name with a word before it, so that a component called "end" is no keyword. Names have no
/// hyphens, so that no two become alike.
std::string mermaid_id(const char* kind, const std::string& name) {
  std::string id = std::string(kind) + "-" + name;
  for (char& c : id)
    if (c == '.' || c == ' ') c = '-';
  return id;
}

std::string mermaid_id(const Picture::Box& box) {
  return mermaid_id(box.shape == Picture::Shape::gate ? "gate" : "node", box.name);
}

std::string mermaid_label(const Picture::Box& box) {
  std::string label = "<b>" + in_mermaid(box.title) + "</b>";
  if (!box.type.empty()) label += "<br>" + in_mermaid(box.type);
  for (const std::string& note : box.notes) label += "<br>" + in_mermaid(note);
  return label;
}

std::string mermaid_label(const Picture::Arrow& arrow) {
  std::string label;
  for (const Picture::Label& each : arrow.labels) {
    if (!label.empty()) label += "<br>";
    label += in_mermaid(each.ports);
    if (!each.type.empty()) label += ": " + in_mermaid(each.type);
  }
  return label;
}

std::string box_of(const Picture::Box& box) {
  const std::string id = mermaid_id(box), label = mermaid_label(box);
  switch (box.shape) {
    case Picture::Shape::component:
      return fmt::format("{}[\"{}\"]", id, label);
    case Picture::Shape::device:
      return fmt::format("{}[[\"{}\"]]", id, label);
    case Picture::Shape::gate:
      return fmt::format("{}{{{{\"{}\"}}}}", id, label);
  }
  return id;
}

const char* arrow_of(Picture::Line line) {
  switch (line) {
    case Picture::Line::same_tick:
      return "-->";
    case Picture::Line::later_tick:
      return "-.->";
    case Picture::Line::other_thread:
      return "==>";
  }
  return "-->";
}

/// What lies in a cluster, or, without one, at the top.
std::string mermaid_lines(const Picture& picture, std::optional<std::size_t> cluster, int depth) {
  const std::string indent(static_cast<std::size_t>(2 * depth), ' ');
  std::string text;
  for (const Picture::Part& part : picture.parts_of(cluster)) {
    if (part.is_cluster) {
      const Picture::Cluster& inner = picture.clusters[part.index];
      const std::string type =
          inner.type.empty() ? "" : fmt::format(" ({})", in_mermaid(inner.type));
      text += fmt::format("{0}subgraph {1}[\"{2}{3}\"]\n{4}{0}end\n", indent,
                          mermaid_id("group", inner.name), in_mermaid(inner.title), type,
                          mermaid_lines(picture, part.index, depth + 1));
    } else {
      text += fmt::format("{}{}\n", indent, box_of(picture.boxes[part.index]));
    }
  }
  return text;
}

}  // namespace

std::string graph_mermaid(const GraphPicture& picture) {
  std::string text = "flowchart LR\n" + mermaid_lines(picture, std::nullopt, 1);
  for (const Picture::Arrow& arrow : picture.arrows)
    text += fmt::format("  {} {}|\"{}\"| {}\n", mermaid_id(picture.boxes[arrow.from]),
                        arrow_of(arrow.line), mermaid_label(arrow),
                        mermaid_id(picture.boxes[arrow.to]));
  return text;
}

}  // namespace trocar
