// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/page_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace trocar::hid {
namespace {

constexpr int most_requests = 5;
constexpr std::int64_t answer_ns = 100'000'000;
constexpr double rounding = 1e-6;  // relative: pages hold float, and texts a few digits

/// True when the page came within the time.
template <typename Page>
bool await(Link& in, TimeSource& time, std::uint16_t sequence, Page& page) {
  std::array<std::uint8_t, report_size + 1> bytes{};
  const std::int64_t end = time.now() + answer_ns;
  for (std::int64_t now = time.now(); now < end; now = time.now()) {
    const int size = in.read(bytes, static_cast<int>((end - now) / 1'000'000) + 1);
    if (size == Link::gone) throw std::runtime_error("the device went away while it was asked");
    const ReportBytes report(bytes.data(), static_cast<std::size_t>(size));
    PageRequest answered;
    if (decode_header(report, answered) != ReportDefect::none || answered.sequence != sequence ||
        answered.page != Page::number)
      continue;
    if (decode(report, page) == ReportDefect::none) return true;
    throw std::runtime_error(fmt::format(
        "page {} of the device holds what no device can mean: its firmware is to be corrected",
        static_cast<int>(Page::number)));
  }
  return false;
}

template <typename Page>
Page read_page(Link& in, Link& out, TimeSource& time) {
  Page page;
  for (int i = 0; i < most_requests; ++i) {
    const auto sequence = static_cast<std::uint16_t>(16 * static_cast<int>(Page::number) + i + 1);
    Report request;
    encode({Page::number, sequence}, request);
    if (!out.write(request)) throw std::runtime_error("the device went away while it was asked");
    if (await(in, time, sequence, page)) return page;
  }
  throw std::runtime_error(
      fmt::format("the device does not tell its page {}: it was asked {} times. Is it one that "
                  "speaks the protocol of docs/device-protocol.md?",
                  static_cast<int>(Page::number), most_requests));
}

class Differences {
 public:
  void add(bool differs, const std::string& text) {
    if (differs) text_ += "\n  " + text;
  }
  void equal(const char* name, double told, double expected) {
    add(std::abs(told - expected) > rounding * std::max(1.0, std::abs(expected)),
        fmt::format("{}: the device says {:.6g}, the script {:.6g}", name, told, expected));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void compare_axis(std::size_t i, const LaparoscopePages& pages, const ExpectedLaparoscope& expected,
                  Differences& differ) {
  const auto value = [](float number) { return static_cast<double>(number); };
  const double peak = value(pages.limits.peak[i]), effort = expected.limits.effort.axis[i];
  differ.add(peak < effort * (1.0 - rounding),
             fmt::format("peak effort of axis {} is {:.6g} and {:.6g} may be sent: set {}", i + 1,
                         peak, effort, i < 3 ? "slider_effort" : "ring_effort"));
  const double low = value(pages.range.lowest[i]), high = value(pages.range.highest[i]);
  differ.add(
      expected.limits.lowest.axis[i] < low - rounding * std::abs(low) ||
          expected.limits.highest.axis[i] > high + rounding * std::abs(high),
      fmt::format("range of axis {}: the device has {:.6g} to {:.6g}, the script {:.6g} to "
                  "{:.6g}: set {}",
                  i + 1, low, high, expected.limits.lowest.axis[i], expected.limits.highest.axis[i],
                  i < 3 ? "slider_lowest and slider_highest" : "ring_travel"));
  const double count = std::abs(value(pages.calibration.unit[i]));
  differ.add(count > expected.resolution[i] * (1.0 + rounding),
             fmt::format(
                 "one count of axis {} is {:.6g} and damping was checked for {:.6g}: set {}", i + 1,
                 count, expected.resolution[i], i < 3 ? "slider_resolution" : "ring_resolution"));
}

}  // namespace

LaparoscopePages read_pages(Link& in, Link& out, TimeSource& time) {
  return {read_page<IdentityPage>(in, out, time), read_page<GeometryPage>(in, out, time),
          read_page<RangePage>(in, out, time), read_page<LimitsPage>(in, out, time),
          read_page<CalibrationPage>(in, out, time)};
}

void require_agreement(const LaparoscopePages& pages, const ExpectedLaparoscope& expected) {
  constexpr std::uint16_t watchdog_us = 8000;  // rule 3
  Differences differ;
  const LaparoscopeGeometry told = geometry_of(pages.geometry);
  differ.equal("tool_length", told.tool_length, expected.geometry.tool_length);
  differ.equal("ring_plane", told.ring_plane, expected.geometry.ring_plane);
  differ.equal("ring_radius", told.ring_radius, expected.geometry.ring_radius);
  differ.equal("base_radius", told.base_radius, expected.geometry.base_radius);
  differ.equal("platform_radius", told.platform_radius, expected.geometry.platform_radius);
  differ.equal("link_length", told.link_length, expected.geometry.link_length);
  differ.add(told.roll != expected.geometry.roll, "roll: the device has another gimbal");
  for (std::size_t i = 0; i < axes; ++i) compare_axis(i, pages, expected, differ);
  differ.add(pages.identity.watchdog_us > watchdog_us,
             fmt::format("its watchdog waits {} us: at most {} are allowed",
                         pages.identity.watchdog_us, watchdog_us));
  differ.add(2 * std::int64_t{pages.identity.period_us} * 1000 > expected.oldest_report_ns,
             fmt::format("it reports every {} us, and a report of {} us is stale already",
                         pages.identity.period_us, expected.oldest_report_ns / 1000));
  if (!differ.text().empty())
    throw std::invalid_argument("the device is not the one that the script is made for:" +
                                differ.text());
}

}  // namespace trocar::hid
