// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "framework/recording/cdr.hpp"
#include "framework/recording/ros2_decode.hpp"
#include "framework/text.hpp"

namespace trocar::gui {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_text = std::size_t{256} << 20;  // of a report or a table [B]

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error(path + " cannot be read");
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(0, file.tellg()));
  if (size > most_text) throw FigureError(path + " is larger than the 256 MiB that are read");
  std::string text(size, '\0');
  file.seekg(0);
  file.read(text.data(), static_cast<std::streamsize>(size));
  return text;
}

/// A row that was published, as JSON; what is none is left out.
void add_row(std::vector<std::pair<std::string, Json>>& published, const std::string& name,
             Json row) {
  if (!row.is_object()) return;
  for (auto& [known, rows] : published)
    if (known == name) return rows.push_back(std::move(row));
  published.emplace_back(name, Json::array({std::move(row)}));
}

std::string topic_of(int run, const std::string& thread) {
  return (run > 1 ? "/run" + std::to_string(run) + "/" : "/") + thread;
}

}  // namespace

ResultFile::ResultFile(const std::string& path) : path_(path) {
  if (path.ends_with(".mcap")) {
    log_.emplace(path);
    read_log();
  } else if (path.ends_with(".csv")) {
    table_ = read_csv(text_of(path));
  } else if (path.ends_with(".json")) {
    read_report(text_of(path));
  } else {
    throw FigureError(path + " is neither a log (.mcap) nor a report (.json) nor a table (.csv)");
  }
}

void ResultFile::read_report(const std::string& text) {
  const Json report = Json::parse(text, nullptr, false);
  if (!report.is_object())
    throw FigureError(path_ + " is not a report: trocar run SCRIPT --json FILE writes one");
  if (const auto found = report.find("published"); found != report.end() && found->is_object())
    for (const auto& [name, rows] : found->items())
      for (const Json& row : rows) add_row(published_, name, row);
}

void ResultFile::read_log() {
  for (const McapAttachment& attachment : log_->attachments()) {
    if (attachment.name != "graph.json") continue;
    const std::vector<std::byte> bytes = log_->read(attachment);
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    graph_ = Json::parse(text, text + bytes.size(), nullptr, false);
  }
  const McapChannel* channel = log_->channel("/published");
  if (channel == nullptr) return;
  log_->messages([&](const McapMessage& message) {
    if (message.channel != channel->id) return;
    CdrReader cdr(message.payload);
    const std::string name(cdr.string());
    add_row(published_, name, Json::parse(cdr.string(), nullptr, false));
  });
}

std::vector<std::string> ResultFile::row_topics() const {
  std::vector<std::string> topics;
  if (!log_) return topics;
  for (const auto& [id, channel] : log_->channels())
    if (channel.metadata.find("period_ns") != channel.metadata.end())
      topics.push_back(channel.topic);
  return topics;
}

const McapChannel& ResultFile::rows_of(int run, const std::string& thread) const {
  if (!log_) throw FigureError("rows of a log (.mcap) are needed, and this is " + contents());
  for (const std::string& topic : row_topics()) {
    const std::string its_thread = topic.substr(topic.rfind('/') + 1);
    if (topic == topic_of(run, thread.empty() ? its_thread : thread)) return *log_->channel(topic);
  }
  throw FigureError(fmt::format("there are no rows of {}{}: the log has {}",
                                thread.empty() ? "" : "thread " + thread + " in ",
                                "run " + std::to_string(run), join(row_topics(), ", ")));
}

std::map<std::string, std::vector<double>> ResultFile::signals_of(
    const std::vector<std::string>& names, int run, const std::string& thread) const {
  const McapChannel& channel = rows_of(run, thread);
  const McapSchema& schema = log_->schemas().at(channel.schema_id);
  const Ros2Decoder decoder(schema.name, schema.data);
  std::vector<std::string> missing, all;
  for (const Ros2Leaf& leaf : decoder.leaves()) all.push_back(leaf.path);
  std::vector<std::pair<const Ros2Leaf*, std::vector<double>*>> wanted;
  std::map<std::string, std::vector<double>> columns;
  for (const std::string& name : names) {
    const Ros2Leaf* leaf = decoder.find(name);
    if (leaf == nullptr) {
      missing.push_back(name + suggestion(name, all).substr(0, 200));
      continue;
    }
    columns[name].reserve(log_->message_count(channel.id));
    wanted.emplace_back(leaf, &columns[name]);
  }
  if (!missing.empty())
    throw FigureError(fmt::format("{} has no signal {}", channel.topic, join(missing, "; nor ")));
  log_->messages([&](const McapMessage& message) {
    if (message.channel != channel.id) return;
    for (const auto& [leaf, into] : wanted)
      into->push_back(as_double(decoder.value(message.payload, *leaf)));
  });
  if (const auto time = columns.find("time"); time != columns.end())
    for (double& value : time->second) value *= 1e-9;
  return columns;
}

std::string ResultFile::contents() const {
  if (table_) return "a table with the columns " + join(table_->names, ", ");
  std::vector<std::string> names;
  for (const auto& [name, rows] : published_)
    names.push_back(fmt::format("{} ({} row{})", name, rows.size(), rows.size() == 1 ? "" : "s"));
  const std::string published =
      names.empty() ? "nothing is published in it" : "published in it: " + join(names, ", ");
  if (!log_) return "a report; " + published;
  return "a log with rows of " + join(row_topics(), ", ") + "; " + published;
}

}  // namespace trocar::gui
