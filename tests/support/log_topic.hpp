// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "framework/recording/mcap_reader.hpp"
#include "framework/recording/ros2_decode.hpp"

namespace trocar::test {

/// All messages of a topic: leaf → value, strings as text.
struct Topic {
  std::vector<std::map<std::string, double>> numbers;
  std::vector<std::map<std::string, std::string>> texts;
  std::vector<std::uint64_t> times;  // [ns]

  Topic(const McapReader& log, std::string_view name) {
    const McapChannel* channel = log.channel(name);
    if (channel == nullptr) return;
    const McapSchema& schema = log.schemas().at(channel->schema_id);
    const Ros2Decoder decoder(schema.name, schema.data);
    log.messages([&](const McapMessage& message) {
      if (message.channel != channel->id) return;
      times.push_back(message.log_time_ns);
      numbers.emplace_back();
      texts.emplace_back();
      decoder.visit(message.payload, [&](const Ros2Leaf& leaf, const Ros2Value& value) {
        if (const auto* text = std::get_if<std::string_view>(&value))
          texts.back()[leaf.path] = *text;
        else
          numbers.back()[leaf.path] = as_double(value);
      });
    });
  }
};

}  // namespace trocar::test
