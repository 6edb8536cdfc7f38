// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/recording.hpp"

#include <fmt/format.h>

#include <QCryptographicHash>
#include <filesystem>
#include <stdexcept>

namespace trocar::foxglove {
namespace {

/// Clients name files, not places.
void check_recording_name(const std::string& name) {
  if (name.find('/') != std::string::npos || name.starts_with('.') || !name.ends_with(".mcap"))
    throw std::runtime_error(fmt::format(
        "\"{}\": needs the name of a file without a folder, e.g. \"trial_7.mcap\"", name));
  if (std::filesystem::exists(name))
    throw std::runtime_error(fmt::format("\"{}\" exists already, and is kept", name));
}

std::string free_recording_name() {
  for (int i = 1;; ++i)
    if (std::string name = fmt::format("recording_{}.mcap", i); !std::filesystem::exists(name))
      return name;
}

}  // namespace

void Recording::add_script(const std::string& name, const std::string& text) {
  const QByteArray hash =
      QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256);
  exclusive_.run([&] {
    if (scripts_.empty()) mark_ = {name, hash.toHex().toStdString()};
    scripts_.emplace_back(name, text);
  });
}

Recording::Mark Recording::mark() {
  return exclusive_.run([&] { return mark_; });
}

void Recording::begin_run(const std::vector<RowLayout>& layouts, const WiredGraph& graph,
                          std::uint64_t epoch_ns, std::string graph_json) {
  exclusive_.run([&] {
    layouts_ = &layouts;
    graph_ = &graph;
    epoch_ns_ = epoch_ns;
    graph_json_ = std::move(graph_json);
    log_trouble_.clear();
  });
}

/// Whatever a full disk does, the run goes on, and somebody is told.
void Recording::attempt(const auto& write) {
  if (!open_) return;
  try {
    write(*open_);
  } catch (const std::exception& error) {
    trouble_ = error.what();
    open_.reset();
  }
}

void Recording::end_run() {
  exclusive_.run([&] {
    layouts_ = nullptr;
    graph_ = nullptr;
    attempt([](Open& open) {
      open.recorder.end();
      open.log.close();
    });
    open_.reset();
  });
}

std::string Recording::start(const std::string& name) {
  return exclusive_.run([&] {
    if (layouts_ == nullptr) throw std::runtime_error("no run is going on");
    if (open_)
      throw std::runtime_error(
          fmt::format("{} is being recorded already: stop that first", open_->state.file));
    if (!name.empty()) check_recording_name(name);
    const std::string file = name.empty() ? free_recording_name() : name;
    auto open = std::make_unique<Open>(file, epoch_ns_);
    for (const auto& [script, text] : scripts_) open->log.attach(script, "text/x-lua", text);
    open->log.attach("graph.json", "application/json", graph_json_);
    open->recorder.begin(*layouts_, *graph_);
    open_ = std::move(open);
    return file;
  });
}

Recording::State Recording::stop() {
  return exclusive_.run([&] {
    if (!open_) throw std::runtime_error(trouble_.empty() ? "nothing is being recorded" : trouble_);
    const State state = open_->state;
    attempt([](Open& open) {
      open.recorder.end();
      open.log.close();
    });
    if (!open_) throw std::runtime_error(trouble_);
    open_.reset();
    return state;
  });
}

Recording::State Recording::state() {
  return exclusive_.run([&] { return open_ ? open_->state : State{}; });
}

void Recording::row(std::size_t group, std::span<const std::byte> row) {
  exclusive_.run([&] {
    attempt([&](Open& open) {
      open.recorder.row(group, row);
      ++open.state.rows;
    });
  });
}

void Recording::event(std::size_t group, const Event& event) {
  exclusive_.run([&] { attempt([&](Open& open) { open.recorder.event(group, event); }); });
}

void Recording::missed(std::uint64_t records) {
  exclusive_.run([&] {
    attempt([&](Open& open) {
      open.recorder.missed(records);
      open.state.missed += records;
    });
  });
}

void Recording::fail_log(const std::string& why) {
  exclusive_.run([&] { trouble_ = log_trouble_ = why; });
}

std::string Recording::log_trouble() {
  return exclusive_.run([&] { return log_trouble_; });
}

std::string Recording::take_trouble() {
  return exclusive_.run([&] { return std::exchange(trouble_, {}); });
}

}  // namespace trocar::foxglove
