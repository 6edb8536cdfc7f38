// SPDX-License-Identifier: Apache-2.0
#include "gui/data/stream_state.hpp"

#include <nlohmann/json.hpp>

namespace trocar::gui {
namespace {

template <typename T>
void read_member(const nlohmann::json& json, const char* name, T& into) {
  if (const auto found = json.find(name); found != json.end()) found->get_to(into);
}

StreamState state_of(const nlohmann::json& json) {
  StreamState state;
  read_member(json, "run", state.run);
  read_member(json, "running", state.running);
  read_member(json, "simulated", state.virtual_time);
  read_member(json, "time", state.time);
  read_member(json, "script", state.script);
  read_member(json, "sha256", state.sha256);
  read_member(json, "log", state.log);
  read_member(json, "log_trouble", state.log_trouble);
  read_member(json, "trouble", state.trouble);
  read_member(json, "stream_missed", state.stream_missed);
  read_member(json, "clients", state.clients);
  if (const auto recording = json.find("recording"); recording != json.end()) {
    read_member(*recording, "file", state.recording.file);
    read_member(*recording, "rows", state.recording.rows);
    read_member(*recording, "missed", state.recording.missed);
  }
  return state;
}

}  // namespace

std::optional<StreamState> read_state(std::span<const std::byte> message) {
  const auto* text = reinterpret_cast<const char*>(message.data());
  const nlohmann::json json = nlohmann::json::parse(text, text + message.size(), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    return state_of(json);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace trocar::gui
