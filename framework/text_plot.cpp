// SPDX-License-Identifier: Apache-2.0
#include "framework/text_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace trocar {
namespace {

constexpr std::size_t least_width = 12;                // room for a time and its unit
constexpr std::size_t dots_across = 2, dots_down = 4;  // of a character

/// The range of the plot's values, never empty.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void widen_when_flat() {
    if (low > high) low = high = 0.0;
    if (high > low) return;
    const double room = high == 0.0 ? 1.0 : 0.5 * std::abs(high);
    low -= room;
    high += room;
  }
};

/// Dots, from the top left.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height) : width_(width), cells_(width * height, 0) {}

  void set(std::size_t x, std::size_t y) {
    // Unicode numbers the dots of a Braille character down its columns, the lowest two last.
    static constexpr unsigned bits[dots_down][dots_across] = {
        {0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    cells_[y / dots_down * width_ + x / dots_across] |= bits[y % dots_down][x % dots_across];
  }
  std::string cell(std::size_t x, std::size_t y, const char* where_empty) const {
    const unsigned dots = cells_[y * width_ + x];
    if (dots == 0) return where_empty;
    // U+2800 and the dots, in UTF-8.
    return {'\xE2', static_cast<char>(0xA0 | dots >> 6), static_cast<char>(0x80 | (dots & 0x3F))};
  }

 private:
  std::size_t width_;
  std::vector<unsigned> cells_;
};

class Painter {
 public:
  Painter(std::span<const double> time, std::span<const double> values, const TextPlot& plot)
      : time_(time), values_(values), plot_(plot), canvas_(plot.width, plot.height) {
    for (const double value : values) range_.take(value);
    if (plot.level) range_.take(*plot.level);
    range_.widen_when_flat();
    draw();
  }

  std::string text() const {
    const std::string high = label(range_.high), low = label(range_.low);
    const std::string level = plot_.level ? label(*plot_.level) : "";
    const std::size_t margin = std::max({high.size(), low.size(), level.size()});
    std::string result;
    for (std::size_t y = 0; y < plot_.height; ++y) {
      const bool at_level = plot_.level && dot_row(*plot_.level) / dots_down == y;
      const std::string& left = at_level                ? level
                                : y == 0                ? high
                                : y + 1 == plot_.height ? low
                                                        : empty_;
      result += fmt::format("{:>{}} │", left, margin);
      for (std::size_t x = 0; x < plot_.width; ++x)
        result += canvas_.cell(x, y, at_level ? "╌" : " ");
      result.erase(result.find_last_not_of(' ') + 1);
      result += '\n';
    }
    return result + axis(margin);
  }

 private:
  std::string label(double value) const { return format_quantity(rounded(value), plot_.unit); }
  /// To four digits: a label is read, not computed with.
  static double rounded(double value) {
    return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr);
  }
  std::size_t dot_row(double value) const {
    const double last = static_cast<double>(plot_.height * dots_down - 1);
    const double part = (range_.high - value) / (range_.high - range_.low);
    return static_cast<std::size_t>(std::lround(std::clamp(part, 0.0, 1.0) * last));
  }
  double end() const { return time_.back() > time_.front() ? time_.back() : time_.front() + 1.0; }
  std::size_t dot_column(double time, std::size_t columns) const {
    const double part = (time - time_.front()) / (end() - time_.front());
    return static_cast<std::size_t>(
        std::lround(std::clamp(part, 0.0, 1.0) * static_cast<double>(columns - 1)));
  }

  /// Each value is joined to the one before, as a pen would.
  void draw() {
    std::size_t x_before = 0, y_before = 0;
    bool joined = false;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (!std::isfinite(values_[i])) {
        joined = false;
        continue;
      }
      const std::size_t x = dot_column(time_[i], plot_.width * dots_across);
      const std::size_t y = dot_row(values_[i]);
      if (joined)
        draw_line(x_before, y_before, x, y);
      else
        canvas_.set(x, y);
      x_before = x;
      y_before = y;
      joined = true;
    }
  }

  /// From left to right, without gaps.
  void draw_line(std::size_t x0, std::size_t y0, std::size_t x1, std::size_t y1) {
    std::size_t y_last = y0;
    for (std::size_t x = x0; x <= x1; ++x) {
      const double part =
          x1 == x0 ? 1.0 : static_cast<double>(x - x0) / static_cast<double>(x1 - x0);
      const auto y = static_cast<std::size_t>(
          std::lround(static_cast<double>(y0) * (1.0 - part) + static_cast<double>(y1) * part));
      const auto [from, to] = std::minmax(y_last, y);
      for (std::size_t dot = from; dot <= to; ++dot) canvas_.set(x, dot);
      y_last = y;
    }
  }

  std::string axis(std::size_t margin) const {
    const std::size_t mark = plot_.marked ? dot_column(*plot_.marked, plot_.width) : plot_.width;
    std::string line = fmt::format("{:{}} └", "", margin);
    for (std::size_t x = 0; x < plot_.width; ++x) line += x == mark ? "▲" : "─";
    const std::string first = fmt::format("{:.4g} s", time_.front());
    const std::string last = fmt::format("{:.4g} s", time_.back());
    std::string below(plot_.width, ' ');
    below.replace(0, first.size(), first);
    below.replace(plot_.width - last.size(), last.size(), last);
    if (plot_.marked) {
      const std::string at = fmt::format("{:.6g} s", *plot_.marked);
      const std::size_t room = plot_.width - at.size();
      const std::size_t begin = std::min(mark > at.size() / 2 ? mark - at.size() / 2 : 0, room);
      // Where it would touch its neighbours it takes their place.
      if (begin < first.size() + 1) below.replace(0, first.size(), first.size(), ' ');
      if (begin + at.size() + last.size() + 1 > plot_.width)
        below.replace(plot_.width - last.size(), last.size(), last.size(), ' ');
      below.replace(begin, at.size(), at);
    }
    below.erase(below.find_last_not_of(' ') + 1);
    return fmt::format("{}\n{:{}}{}\n", line, "", margin + 2, below);
  }

  std::span<const double> time_;
  std::span<const double> values_;
  const TextPlot& plot_;
  const std::string empty_;
  Range range_;
  Canvas canvas_;
};

}  // namespace

std::string text_plot(std::span<const double> time, std::span<const double> values, TextPlot plot) {
  if (values.empty() || time.size() != values.size()) return "";
  plot.width = std::max(plot.width, least_width);
  plot.height = std::max<std::size_t>(plot.height, 1);
  return Painter(time, values, plot).text();
}

}  // namespace trocar
