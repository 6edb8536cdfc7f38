// SPDX-License-Identifier: Apache-2.0
#include "gui/playback/log_runs.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "framework/recording/ros2_schema.hpp"
#include "framework/recording/schema_signals.hpp"

namespace trocar::gui {
namespace {

constexpr double bytes_of_value = 9.1;  // in a track, with its share of extremes

struct Topic {
  int run = 1;
  std::string name;
};

/// "/run2/main" is of run 2 and thread "main"; none for a topic of another form.
std::optional<Topic> topic_of(std::string_view text) {
  if (!text.starts_with('/')) return std::nullopt;
  text.remove_prefix(1);
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return Topic{1, std::string(text)};
  std::string_view run = text.substr(0, slash);
  if (!run.starts_with("run")) return std::nullopt;
  run.remove_prefix(3);
  Topic topic{0, std::string(text.substr(slash + 1))};
  const auto [end, error] = std::from_chars(run.data(), run.data() + run.size(), topic.run);
  if (error != std::errc() || end != run.data() + run.size() || topic.run < 2) return std::nullopt;
  return topic;
}

double period_of(const McapChannel& channel) {
  const auto found = channel.metadata.find("period_ns");
  if (found == channel.metadata.end()) return 0.0;
  std::int64_t period = 0;
  std::from_chars(found->second.data(), found->second.data() + found->second.size(), period);
  return period > 0 ? 1e-9 * static_cast<double>(period) : 0.0;
}

LogRun& run_in(std::vector<LogRun>& runs, int number) {
  const auto found = std::find_if(runs.begin(), runs.end(),
                                  [&](const LogRun& run) { return run.number == number; });
  if (found != runs.end()) return *found;
  runs.push_back({.number = number, .threads = {}, .events = {}});
  return runs.back();
}

}  // namespace

std::uint64_t LogRun::Thread::memory() const {
  return static_cast<std::uint64_t>(bytes_of_value * static_cast<double>(columns + 1) *
                                    static_cast<double>(rows));
}

std::uint64_t LogRun::memory() const {
  std::uint64_t sum = 0;
  for (const Thread& thread : threads) sum += thread.memory();
  return sum;
}

double LogRun::duration() const {
  double longest = 0.0;
  for (const Thread& thread : threads)
    longest = std::max(longest, thread.period * static_cast<double>(thread.rows));
  return longest;
}

std::vector<LogRun> runs_of(const McapReader& log) {
  std::vector<LogRun> runs;
  for (const auto& [id, channel] : log.channels()) {
    const std::optional<Topic> topic = topic_of(channel.topic);
    const auto schema = log.schemas().find(channel.schema_id);
    if (!topic || schema == log.schemas().end()) continue;
    const std::string name = ros2_short_name(schema->second.name);
    if (name == "trocar/Event") run_in(runs, topic->run).events = id;
    if (name != "trocar/Row") continue;
    const std::size_t columns =
        signals_of(parse_ros2_schema(schema->second.name, schema->second.data)).size();
    run_in(runs, topic->run)
        .threads.push_back({.name = topic->name,
                            .channel = id,
                            .period = period_of(channel),
                            .rows = log.message_count(id),
                            .columns = columns});
  }
  std::erase_if(runs, [](const LogRun& run) { return run.threads.empty(); });
  std::sort(runs.begin(), runs.end(),
            [](const LogRun& a, const LogRun& b) { return a.number < b.number; });
  return runs;
}

}  // namespace trocar::gui
