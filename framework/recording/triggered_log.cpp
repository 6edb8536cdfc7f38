// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/triggered_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace trocar {
namespace {

constexpr std::size_t events_kept = 4096;  // beside the rows

Event event_in(std::span<const std::byte> record) {
  Event event;
  std::memcpy(&event, record.data(), sizeof event);
  return event;
}

std::int64_t time_of(std::uint32_t tag, std::span<const std::byte> record) {
  return record_kind(tag) == RecordKind::row ? header_of(record).time : event_in(record).time_ns;
}

std::uint32_t tag_of(RecordKind kind, std::size_t group) {
  return record_tag(kind, static_cast<std::uint32_t>(group));
}

std::int64_t nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

}  // namespace

TriggeredLog::TriggeredLog(Trigger& trigger, Options options)
    : trigger_(trigger), options_(std::move(options)) {}

void TriggeredLog::begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) {
  layouts_ = &layouts;
  graph_ = &graph;
  const Trigger::Window window = trigger_.begin(layouts, graph);
  before_ns_ = nanoseconds(window.before);
  after_ns_ = nanoseconds(window.after);
  auto memory = static_cast<double>(events_kept * RecordHistory::taken_by(sizeof(Event)));
  for (const RowLayout& layout : layouts) {
    const double period = 1e-9 * static_cast<double>(layout.period_ns());
    const double rows = std::ceil(window.before / period) + 2.0;
    memory += rows * static_cast<double>(RecordHistory::taken_by(layout.size()));
  }
  if (memory > static_cast<double>(options_.most_memory))
    throw std::runtime_error(fmt::format(
        "{}: {:g} s before a trigger take {:.0f} MiB, {} MiB are possible: ask for less, or lower "
        "the rate",
        options_.name, window.before, memory / (1 << 20), options_.most_memory >> 20));
  history_.emplace(static_cast<std::size_t>(memory));
}

/// A disk that refuses costs the file.
void TriggeredLog::attempt(const auto& what) {
  try {
    what();
  } catch (const std::runtime_error& error) {
    troubles_.push_back(fmt::format("{}: {}", options_.name, error.what()));
    recorder_.reset();
    log_.reset();
  }
}

void TriggeredLog::row(std::size_t group, std::span<const std::byte> row) {
  const RowHeader header = header_of(row);
  take_missed(group, header.tick, header.time);
  take(tag_of(RecordKind::row, group), row, header.time, trigger_.row(group, row));
}

void TriggeredLog::event(std::size_t group, const Event& event) {
  take_missed(group, event.tick, event.time_ns);
  take(tag_of(RecordKind::event, group), std::as_bytes(std::span(&event, 1)), event.time_ns,
       trigger_.event(group, event));
}

void TriggeredLog::take_missed(std::size_t group, std::int64_t tick, std::int64_t time_ns) {
  if (missed_ == 0) return;
  const Event event = missed_event(options_.name.c_str(), missed_, tick, time_ns);
  missed_ = 0;
  take(tag_of(RecordKind::event, group), std::as_bytes(std::span(&event, 1)), time_ns, false);
}

void TriggeredLog::take(std::uint32_t tag, std::span<const std::byte> record, std::int64_t time_ns,
                        bool triggered) {
  // A file stays open while a trigger could still overlap with it.
  if (log_ && time_ns > until_ns_ + before_ns_) close();
  if (triggered) {
    if (!log_) open(time_ns);
    if (log_) attempt([&] { catch_up(time_ns - before_ns_); });
    until_ns_ = time_ns + after_ns_;
    resting_ = false;
  }
  if (log_ && time_ns <= until_ns_) {
    attempt([&] { write(tag, record); });
    written_up_to_ = history_->pushed() + 1;
  } else if (log_ && !resting_) {
    resting_ = true;
    attempt([&] { log_->writer().flush(); });
  }
  history_->push(tag, record);
}

void TriggeredLog::open(std::int64_t time_ns) {
  if (opened_ == options_.most_files) {
    if (time_ns - before_ns_ > until_ns_) ++refused_;
    return;
  }
  ++opened_;
  attempt([&] {
    TriggeredFile file;
    file.writer = options_.name;
    file.path = options_.next_path();
    file.cause = trigger_.cause();
    log_ = std::make_unique<LogFile>(file.path, options_.epoch_ns);
    files_.push_back(file);
    for (const Attachment& one : options_.attachments)
      log_->attach(one.name, one.media_type, one.text);
    log_->attach("cause.txt", "text/plain", file.cause + "\n");
    recorder_.emplace(*log_, RowLayout::Selection{});
    recorder_->begin(*layouts_, *graph_);
    written_up_to_ = 0;
  });
}

void TriggeredLog::catch_up(std::int64_t since_ns) {
  history_->for_each(written_up_to_, [&](std::uint32_t tag, std::span<const std::byte> record) {
    if (time_of(tag, record) >= since_ns) write(tag, record);
  });
}

void TriggeredLog::write(std::uint32_t tag, std::span<const std::byte> record) {
  const std::size_t group = record_group(tag);
  if (record_kind(tag) == RecordKind::event) return recorder_->event(group, event_in(record));
  recorder_->row(group, record);
  TriggeredFile& file = files_.back();
  file.to = static_cast<double>(header_of(record).time) * 1e-9;
  if (file.rows++ == 0) file.from = file.to;
}

void TriggeredLog::close() {
  if (!log_) return;
  attempt([&] {
    recorder_->end();
    log_->close();
  });
  recorder_.reset();
  log_.reset();
}

}  // namespace trocar
