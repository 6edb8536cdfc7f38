// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_pump.hpp"

#include <algorithm>
#include <cstring>
#include <deque>
#include <exception>
#include <optional>

#include "framework/realtime/background_poller.hpp"

namespace trocar {
namespace {

constexpr double kept = 5.0;  // [s] that a reader may be behind
constexpr double least_capacity = 8.0 * 1024 * 1024;
constexpr double most_capacity = 256.0 * 1024 * 1024;
constexpr std::chrono::microseconds pause{1500};  // of a reader that found nothing

}  // namespace

std::size_t ring_capacity(const RowLayout& layout, double period, bool lossless) {
  const auto row = static_cast<double>(layout.size() + BroadcastRing::head_size + 8);
  const double rows = lossless ? 0.0 : kept / period;
  return static_cast<std::size_t>(
      std::max(std::clamp(rows * row, least_capacity, most_capacity), 64.0 * row));
}

/// One sink and its way to it.
class RowPump::Feed {
 public:
  Feed(std::deque<BroadcastRing>& rings, RowSink& sink, const std::vector<RowLayout>& layouts,
       const WiredGraph& graph, bool lossless, Mailbox<ReaderFailure>& failures)
      : sink_(sink), failures_(failures) {
    for (BroadcastRing& ring : rings)
      cursors_.emplace_back(
          ring, BroadcastRing::Cursor::Start::now,
          lossless ? BroadcastRing::Cursor::Loss::never : BroadcastRing::Cursor::Loss::told);
    attempt([&] { sink_.begin(layouts, graph); });
    if (failure_.empty()) poller_.emplace([this] { return drain(); }, pause);
  }

  void finish(PumpResult& result) {
    if (poller_) poller_->finish();
    if (failure_.empty()) attempt([&] { sink_.end(); });
    if (!failure_.empty()) result.failures.push_back(failure_);
    if (loss_.records == 0) return;
    loss_.reader = sink_.reader_name();
    loss_.matters = sink_.needs_every_row();
    result.losses.push_back(loss_);
  }

 private:
  /// A record of each ring in turn, so that threads stay side by side.
  bool drain() {
    bool found = false;
    for (bool more = true; more;) {
      more = false;
      for (BroadcastRing::Cursor& cursor : cursors_) {
        if (!failure_.empty()) return found;
        const auto record = cursor.next();
        if (!record) continue;
        found = more = true;
        attempt([&] { deliver(*record); });
      }
    }
    return found;
  }

  void deliver(const BroadcastRing::Record& record) {
    const std::size_t group = record_group(record.tag);
    if (record_kind(record.tag) == RecordKind::row) {
      if (record.missed > 0) tell(record.missed, header_of(record.bytes).time);
      return sink_.row(group, record.bytes);
    }
    Event event;
    std::memcpy(&event, record.bytes.data(), sizeof event);
    if (record.missed > 0) tell(record.missed, event.time_ns);
    sink_.event(group, event);
  }

  void tell(std::uint64_t missed, std::int64_t time_ns) {
    if (loss_.records == 0) loss_.time = static_cast<double>(time_ns) * 1e-9;
    loss_.records += missed;
    ++loss_.gaps;
    sink_.missed(missed);
  }

  /// A sink that throws is left out, and holds nobody up.
  void attempt(const auto& what) {
    try {
      return what();
    } catch (const std::exception& error) {
      failure_ = error.what();
      if (failure_.empty()) failure_ = "a reader of rows failed without a word";
    } catch (...) {
      failure_ = "a reader of rows failed and did not say why";
    }
    for (BroadcastRing::Cursor& cursor : cursors_) cursor.abandon();
    failures_.put({std::string(sink_.reader_name()), failure_});
  }

  RowSink& sink_;
  Mailbox<ReaderFailure>& failures_;
  std::deque<BroadcastRing::Cursor> cursors_;  // one for each ring
  std::string failure_;
  ReaderLoss loss_;
  std::optional<BackgroundPoller> poller_;  // last: it uses all of the above
};

RowPump::RowPump(std::deque<BroadcastRing>& rings, const std::vector<RowSink*>& sinks,
                 const std::vector<RowLayout>& layouts, const WiredGraph& graph, bool lossless) {
  for (RowSink* sink : sinks)
    feeds_.push_back(std::make_unique<Feed>(rings, *sink, layouts, graph, lossless, failures_));
}

RowPump::~RowPump() = default;

PumpResult RowPump::finish() {
  PumpResult result;
  for (const auto& feed : feeds_) feed->finish(result);
  return result;
}

}  // namespace trocar
