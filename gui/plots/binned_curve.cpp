// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/binned_curve.hpp"

#include <algorithm>
#include <cmath>

#include "gui/plots/round_step.hpp"

namespace trocar::gui {

void BinnedCurve::clear() {
  track_ = nullptr;
  bins_.clear();
}

void BinnedCurve::show(const SignalRef& signal, double end, double span, int bins) {
  // A picture that is drawn a pixel wider keeps its bins.
  const double width = round_step(span / std::max(bins, 1));
  const auto first = static_cast<std::int64_t>(std::floor((end - span) / width));
  const auto last = static_cast<std::int64_t>(std::floor(end / width));
  const Track& track = *signal.track;
  const bool anew = track_ != signal.track || index_ != signal.index || width != width_ ||
                    (!bins_.empty() && first < bins_.front().number) || next_ > last + 1 ||
                    next_ < first;
  if (anew) {
    track_ = signal.track;
    index_ = signal.index;
    width_ = width;
    bins_.clear();
    next_ = first;
    next_row_ = track.at(static_cast<double>(first) * width);
  }
  while (!bins_.empty() && bins_.front().number < first) bins_.pop_front();
  // The last bin may not be full yet: it is found again the next time.
  if (!bins_.empty() && bins_.back().number >= next_) bins_.pop_back();
  next_row_ = std::max(next_row_, track.first());
  for (std::int64_t number = next_; number <= last; ++number) {
    const std::uint64_t row_end =
        number < last ? track.at(static_cast<double>(number + 1) * width)
                      : track.at(std::nextafter(end, std::numeric_limits<double>::infinity()));
    add(track, signal.column(), number, row_end);
    if (number == last) break;
    next_ = number + 1;
    next_row_ = row_end;
  }
}

void BinnedCurve::add(const Track& track, const Column& column, std::int64_t number,
                      std::uint64_t row_end) {
  if (row_end <= next_row_) return;
  Bin bin{.number = number,
          .extremes = column.extremes(next_row_, row_end),
          .after_gap =
              next_row_ > track.first() && track.tick(next_row_) > track.tick(next_row_ - 1) + 1};
  bins_.push_back(bin);
}

Extremes BinnedCurve::extremes() const {
  Extremes extremes;
  for (const Bin& bin : bins_) extremes.add(bin.extremes);
  return extremes;
}

}  // namespace trocar::gui
