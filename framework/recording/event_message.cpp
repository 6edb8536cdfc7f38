// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/event_message.hpp"

#include <fmt/format.h>

#include "framework/recording/cdr.hpp"
#include "framework/recording/ros2_schema.hpp"

namespace trocar {

std::string event_schema() {
  return ros2_schema_text({{"trocar/Event",
                            {{"tick", "int64", 0, {}},
                             {"time", "int64", 0, "[ns] since the start"},
                             {"thread", "string", 0, "whose tick it is"},
                             {"kind", "string", 0, {}},
                             {"source", "string", 0, "component"},
                             {"detail", "string", 0, {}},
                             {"value", "float64", 0, "that caused it"},
                             {"limit", "float64", 0, "that it broke"}},
                            {}}});
}

void write_event(const Event& event, std::string_view thread, std::vector<std::byte>& into) {
  CdrWriter cdr(into);
  cdr.number(event.tick);
  cdr.number(event.time_ns);
  cdr.string(thread);
  cdr.string(to_string(event.kind));
  cdr.string(event.source);
  const std::string_view what = event.what;
  const std::string_view detail = event.detail;
  cdr.string(fmt::format("{}{}{}", what, what.empty() || detail.empty() ? "" : ": ", detail));
  cdr.number(event.value);
  cdr.number(event.limit);
}

}  // namespace trocar
