// SPDX-License-Identifier: Apache-2.0
#include "framework/reloads.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "framework/text.hpp"

namespace trocar {

std::string ReloadVerdict::text() const {
  return trouble.empty() ? fmt::format("{} took over in {} at {:.3f} s", file, component, time)
                         : fmt::format("{} did not take over in {} at {:.3f} s:\n    {}", file,
                                       component, time, trouble);
}

ReloadTicket::ReloadTicket(Reloads& all, Reload reload, Replaceable& part, const char* owner)
    : all_(all), reload_(std::move(reload)), part_(part), owner_(owner) {
  verdict_ = {.component = owner_,
              .file = reload_.file,
              .code = reload_.text,
              .time = reload_.at,
              .trouble = "the run ended before"};
}

void ReloadTicket::prepare(double time) {
  all_.collect();
  verdict_.time = time;
  verdict_.trouble.clear();
  try {
    version_ = part_.prepare(reload_);
  } catch (const std::exception& error) {
    verdict_.trouble = error.what();
  }
}

bool ReloadTicket::collect() {
  if (!version_ || !version_->released()) return false;
  verdict_.trouble = version_->trouble();
  version_.reset();
  return true;
}

Reloads::Reloads(const WiredGraph& wired) {
  for (std::size_t group = 0; group < wired.groups().size(); ++group)
    for (const ScheduleItem& item : wired.groups()[group].schedule())
      if (auto* part = dynamic_cast<Replaceable*>(item.component))
        places_[item.component->name()] = {part, item.component->name().c_str(), group};
}

std::vector<Reloads::Part> Reloads::parts() const {
  std::vector<Part> parts;
  for (const auto& [component, place] : places_) parts.push_back({component, place.part->source()});
  return parts;
}

Reloads::Issued Reloads::issue(Reload reload) {
  const auto found = places_.find(reload.component);
  if (found == places_.end()) {
    std::vector<std::string> known;
    for (const auto& [component, place] : places_) known.push_back(component);
    throw std::invalid_argument(
        known.empty()
            ? fmt::format("\"{}\" cannot be reloaded: no component's law comes from a file",
                          reload.component)
            : fmt::format("\"{}\" cannot be reloaded{}", reload.component,
                          suggestion(reload.component, known)));
  }
  tickets_.emplace_back(*this, std::move(reload), *found->second.part, found->second.owner);
  return {&tickets_.back(), found->second.group};
}

void Reloads::collect() {
  for (ReloadTicket& ticket : tickets_)
    if (ticket.collect() && !ticket.verdict().trouble.empty())
      troubles_.push_back(ticket.verdict());
}

std::vector<ReloadVerdict> Reloads::take_troubles() {
  collect();
  return std::exchange(troubles_, {});
}

std::vector<ReloadVerdict> Reloads::verdicts() {
  collect();
  std::vector<ReloadVerdict> verdicts;
  for (const ReloadTicket& ticket : tickets_) verdicts.push_back(ticket.verdict());
  return verdicts;
}

}  // namespace trocar
