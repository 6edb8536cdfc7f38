// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_pump.hpp"

#include <cstring>
#include <exception>

namespace trocar {

RowHeader header_of(std::span<const std::byte> row) {
  RowHeader header;
  std::memcpy(&header, row.data(), sizeof header);
  return header;
}

double number_at(std::span<const std::byte> row, std::size_t offset) {
  double number = 0.0;
  std::memcpy(&number, row.data() + offset, sizeof number);
  return number;
}

RowPump::RowPump(RecordRing& ring, std::vector<RowSink*> sinks, const RowLayout& layout,
                 const WiredGraph& graph)
    : ring_(ring), sinks_(std::move(sinks)), poller_([this] { return drain(); }) {
  // The poller leaves the sinks alone until the ring has something.
  for_each_sink([&](RowSink& sink) { sink.begin(layout, graph); });
}

template <typename Deliver>
void RowPump::for_each_sink(const Deliver& deliver) {
  for (std::size_t i = 0; i < sinks_.size();) {
    try {
      deliver(*sinks_[i++]);
      continue;
    } catch (const std::exception& error) {
      failures_.emplace_back(error.what());
    } catch (...) {  // or nobody would empty the ring any more
      failures_.emplace_back("a reader of rows failed and did not say why");
    }
    sinks_.erase(sinks_.begin() + static_cast<std::ptrdiff_t>(--i));
  }
}

bool RowPump::drain() {
  bool found = false;
  for (RecordRing::Record record = ring_.front(); !record.bytes.empty(); record = ring_.front()) {
    found = true;
    if (record.kind == static_cast<std::uint32_t>(RecordKind::row)) {
      for_each_sink([&](RowSink& sink) { sink.row(record.bytes); });
    } else {
      Event event;
      std::memcpy(&event, record.bytes.data(), sizeof event);
      for_each_sink([&](RowSink& sink) { sink.event(event); });
    }
    ring_.pop();
  }
  return found;
}

std::vector<std::string> RowPump::finish() {
  poller_.finish();
  for_each_sink([](RowSink& sink) { sink.end(); });
  return failures_;
}

}  // namespace trocar
