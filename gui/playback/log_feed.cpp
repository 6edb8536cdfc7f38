// SPDX-License-Identifier: Apache-2.0
#include "gui/playback/log_feed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr double all_of_it = 1e12;          // [s], longer than any run
constexpr std::size_t cost_of_record = 16;  // beside its rows, as rows

}  // namespace

LogFeed::LogFeed(DataStore& store, Limits limits, QObject* parent)
    : QObject(parent), store_(store), limits_(limits) {
  // At once, but behind what else there is to do.
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &LogFeed::load_slice);
}

void LogFeed::open(const std::string& path) {
  auto log = std::make_unique<McapReader>(path);
  std::vector<LogRun> runs = runs_of(*log);
  if (runs.empty())
    throw std::runtime_error(path + " has no rows of a run" +
                             (log->complete() ? "" : ": " + log->problem()));
  timer_.stop();
  log_ = std::move(log);
  path_ = path;
  runs_ = std::move(runs);
  read_graph();
  choose(runs_.front().number);
}

void LogFeed::read_graph() {
  graph_ = nullptr;
  for (const McapAttachment& attachment : log_->attachments()) try {
      if (attachment.name != "graph.json") continue;
      const std::vector<std::byte> bytes = log_->read(attachment);
      const auto* text = reinterpret_cast<const char*>(bytes.data());
      graph_ = nlohmann::json::parse(text, text + bytes.size(), nullptr, false);
      if (!graph_.is_object()) graph_ = nullptr;
    } catch (const McapError&) {
      graph_ = nullptr;  // the rows may be whole
    }
}

LogFeed::Script LogFeed::script() const {
  for (const McapAttachment& attachment : log_->attachments()) try {
      if (attachment.media_type != "text/x-lua") continue;
      const std::vector<std::byte> bytes = log_->read(attachment);
      return {attachment.name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}};
    } catch (const McapError&) {
      break;  // the rows may be whole
    }
  return {};
}

const LogRun& LogFeed::current() const {
  return *std::find_if(runs_.begin(), runs_.end(),
                       [&](const LogRun& run) { return run.number == run_; });
}

void LogFeed::choose(int run) {
  if (std::none_of(runs_.begin(), runs_.end(),
                   [&](const LogRun& one) { return one.number == run; }))
    throw std::invalid_argument("the log has no run " + std::to_string(run));
  run_ = run;
  epoch_.reset();
  events_.clear();
  knows_events_ = false;
  whole_ = {0.0, current().duration()};
  begin(0.0);
  Q_EMIT opened();
}

void LogFeed::load_around(double time) {
  if (log_ == nullptr || !is_part_ || wanted_.holds(time)) return;
  begin(time);
}

void LogFeed::begin(double around) {
  const double share =
      std::min(1.0, 0.95 * static_cast<double>(limits_.memory) /
                        static_cast<double>(std::max<std::uint64_t>(current().memory(), 1)));
  is_part_ = share < 1.0;
  wanted_ = {-all_of_it, all_of_it};
  if (is_part_) {
    const double length = share * whole_.to;
    wanted_.from = std::clamp(around - 0.5 * length, 0.0, whole_.to - length);
    wanted_.to = wanted_.from + length;
  }
  problem_ = log_->problem();
  store_.begin_run(make_tracks(share));
  for (const RunEvent& event : events_) store_.add_event(event);
  place_ = McapReader::data_begin();
  state_ = State::loading;
  timer_.start();
  Q_EMIT advanced();
}

std::vector<std::unique_ptr<Track>> LogFeed::make_tracks(double share) const {
  std::vector<std::unique_ptr<Track>> tracks;
  for (const LogRun::Thread& thread : current().threads) {
    const McapChannel& channel = log_->channels().at(thread.channel);
    const McapSchema& schema = log_->schemas().at(channel.schema_id);
    const auto memory = static_cast<std::size_t>(share * static_cast<double>(thread.memory()));
    tracks.push_back(std::make_unique<Track>(thread.name, schema.name, schema.data, thread.period,
                                             all_of_it, memory));
  }
  return tracks;
}

void LogFeed::load_slice() {
  constexpr std::int64_t margin_ns = 1'000'000;
  McapReader::TimeRange range;
  if (knows_events_ && epoch_ && is_part_) {
    const auto date = [&](double time) {
      return static_cast<std::uint64_t>(
          std::max<std::int64_t>(0, *epoch_ + static_cast<std::int64_t>(1e9 * time)));
    };
    range = {date(wanted_.from) - std::min(date(wanted_.from), std::uint64_t{margin_ns}),
             date(wanted_.to) + margin_ns};
  }
  try {
    for (in_slice_ = 0; in_slice_ < limits_.slice; in_slice_ += cost_of_record) {
      if (place_ >= log_->data_end()) return finish(State::loaded);
      place_ = log_->messages_at(
          place_, [&](const McapMessage& message) { take(message); }, range);
    }
  } catch (const std::exception& error) {
    problem_ += (problem_.empty() ? "" : "; ") + std::string(error.what());
    return finish(State::loaded);
  }
  Q_EMIT advanced();
}

void LogFeed::take(const McapMessage& message) {
  ++in_slice_;
  const LogRun& run = current();
  if (run.events == message.channel && !knows_events_) {
    events_.push_back(read_event(message.payload));
    if (events_.size() > DataStore::most_events) events_.erase(events_.begin());
    store_.add_event(events_.back());
  }
  for (const LogRun::Thread& thread : run.threads)
    if (thread.channel == message.channel) take_row(thread, message);
}

void LogFeed::take_row(const LogRun::Thread& thread, const McapMessage& message) {
  Track& track = *store_.track(thread.name);
  const auto row = message.payload.subspan(std::min(cdr_head, message.payload.size()));
  if (row.size() != track.row_size())
    throw std::runtime_error(fmt::format("a row of {} has {} bytes instead of {}", thread.name,
                                         row.size(), track.row_size()));
  const double time = track.time_of(row);
  if (!epoch_) epoch_ = static_cast<std::int64_t>(message.log_time_ns) - std::llround(1e9 * time);
  whole_.to = std::max(whole_.to, time);
  if (wanted_.holds(time) && !track.is_before_end(row)) track.add(row);
}

void LogFeed::cancel() {
  if (state_ == State::loading) finish(State::cancelled);
}

void LogFeed::finish(State state) {
  timer_.stop();
  state_ = state;
  knows_events_ = knows_events_ || state == State::loaded;
  // Times of a run that waited for its start, or lost rows, are not those of its rows' number.
  if (!is_part_ && state == State::loaded) whole_ = loaded();
  Q_EMIT advanced();
}

double LogFeed::progress() const {
  if (state_ == State::empty) return 0.0;
  if (state_ == State::loaded) return 1.0;
  return static_cast<double>(place_) /
         static_cast<double>(std::max<std::uint64_t>(log_->data_end(), 1));
}

LogFeed::Span LogFeed::loaded() const {
  Span span{all_of_it, 0.0};
  for (const auto& track : store_.tracks()) {
    if (track->empty()) continue;
    span.from = std::min(span.from, track->time(track->first()));
    span.to = std::max(span.to, track->time(track->end() - 1));
  }
  return span.from > span.to ? Span{} : span;
}

std::string LogFeed::summary() const {
  if (state_ == State::empty) return "no log";
  std::string text;
  if (runs_.size() > 1) text = fmt::format("run {} of {}: ", run_, runs_.size());
  const Span there = loaded();
  if (is_part_ || state_ != State::loaded)
    text += fmt::format("{:.1f} to {:.1f} s of {:.1f} s", there.from, there.to, whole_.to);
  else
    text += fmt::format("{:.1f} s", whole_.to - whole_.from);
  if (state_ == State::loading) text += fmt::format(", loading: {:.0f} %", 100.0 * progress());
  if (state_ == State::cancelled) text += ", loading was cancelled";
  if (is_part_ && state_ == State::loaded)
    text += fmt::format("; no more than {} MiB of rows are held", limits_.memory >> 20);
  return text;
}

}  // namespace trocar::gui
