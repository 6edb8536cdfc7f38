// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/wiring.hpp"

namespace trocar {
namespace {

constexpr std::size_t word = sizeof(double);

std::size_t words_of(const Signature& signature) {
  return (signature.type->size + word - 1) / word;
}

bool is_number(const Signature& signature) {
  return !signature.type->fields.empty() || signature.type->scalar == Scalar::real;
}

}  // namespace

/// What has no ports does nothing in the loop, a Logger say, and needs no thread of its own.
void Wiring::settle_threads() {
  const auto has_ports = [&](NodeId id) {
    const Component* component = result_->components_[id].get();
    return component != nullptr && !(component->inputs().empty() && component->outputs().empty());
  };
  std::optional<ThreadId> first;
  for (NodeId id = 0; id < graph_.size(); ++id) {
    thread_of_.push_back(graph_.node(id).thread);
    if (has_ports(id)) first = std::min(first.value_or(thread_of_[id]), thread_of_[id]);
  }
  for (NodeId id = 0; id < graph_.size(); ++id)
    if (first && !has_ports(id)) thread_of_[id] = *first;
}

double Wiring::thread_rate(NodeId node) const {
  const double own = graph_.threads()[thread_of_[node]].rate;
  return own > 0.0 ? own : options_.rate;
}

void Wiring::check_connections() {
  for (const ResolvedWire& wire : wires_) {
    const auto thread_of = [&](NodeId node) -> const std::string& {
      return graph_.threads()[thread_of_[node]].name;
    };
    const bool crosses = thread_of_[wire.from_node] != thread_of_[wire.to_node];
    const double own_rate = graph_.node(wire.from_node).rate;
    const double value_rate = own_rate > 0.0 ? own_rate : thread_rate(wire.from_node);
    if (!crosses && !wire.connection) continue;
    const std::string source = wire.text().substr(0, wire.text().find(" →"));
    if (crosses && !wire.connection)
      findings_.add(wire.where,
                    fmt::format("{} goes from thread {} to thread {}: say how, by "
                                "{}:latest {{ stale = \"{:.3g} ms\" }} or {}:queue()",
                                wire.text(), thread_of(wire.from_node), thread_of(wire.to_node),
                                source, 3e3 / value_rate, source));
    else if (!crosses && wire.connection)
      findings_.add(wire.where,
                    fmt::format("{}: both are in thread {}; take {} without {}", wire.text(),
                                thread_of(wire.to_node), source, to_string(wire.connection->kind)));
    else if (crosses && wire.connection->kind == Connection::Kind::queue &&
             value_rate > thread_rate(wire.to_node) * (1.0 + 1e-9))
      findings_.add(wire.where,
                    fmt::format("{}: a queue from {:.6g} Hz to {:.6g} Hz fills up; take latest",
                                wire.text(), value_rate, thread_rate(wire.to_node)));
    else if (crosses && wire.connection->stale * value_rate < 1.0)
      findings_.add(wire.where,
                    fmt::format("{}: stale = {:.3g} ms is less than the {:.3g} ms from one value "
                                "to the next",
                                wire.text(), 1e3 * wire.connection->stale, 1e3 / value_rate));
  }
}

/// One for each thread in use, in the order of declaration, with its schedule and its memory. Where
/// nothing runs, the last one has a group all the same.
void Wiring::make_groups() {
  group_index_.assign(graph_.size(), 0);
  item_index_.assign(graph_.size(), 0);
  position_.assign(graph_.size(), 0);
  std::vector<bool> in_use(graph_.threads().size(), false);
  if (order_.empty()) in_use.back() = true;
  for (const NodeId id : order_) in_use[thread_of_[id]] = true;
  std::vector<std::size_t> group_of_thread(in_use.size(), 0);
  for (ThreadId thread = 0; thread < in_use.size(); ++thread) {
    group_of_thread[thread] = result_->groups_.size();
    if (in_use[thread]) begin_group(thread);
  }
  for (std::size_t i = 0; i < order_.size(); ++i) {
    position_[order_[i]] = i;
    add_to_group(order_[i], group_of_thread[thread_of_[order_[i]]]);
  }
  for (ResolvedWire& wire : wires_) {
    if (!wire.connection) continue;
    RateGroup& reader = group_of(wire.to_node);
    wire.arrival = reader.arrivals_.size();
    reader.arrivals_.push_back(
        {.input = wire.to, .item = item_index_[wire.to_node], .signature = *wire.to->signature()});
  }
  for (RateGroup& group : result_->groups_) lay_out_memory(group);
}

void Wiring::begin_group(ThreadId thread) {
  const Graph::Thread& declared = graph_.threads()[thread];
  RateGroup& group = result_->groups_.emplace_back();
  group.name_ = declared.name;
  group.period_ns_ = std::llround(1e9 / (declared.rate > 0.0 ? declared.rate : options_.rate));
  group.period_ = static_cast<double>(group.period_ns_) * 1e-9;
  group.phase_ns_ = std::llround(declared.phase * 1e9);
  group.priority_ = declared.priority;
  group.processor_ = declared.processor;
}

void Wiring::add_to_group(NodeId id, std::size_t index) {
  const Graph::Node& node = graph_.node(id);
  RateGroup& group = result_->groups_[index];
  group_index_[id] = index;
  item_index_[id] = group.schedule_.size();
  const double divider = node.rate == 0.0 ? 1.0 : std::round(thread_rate(id) / node.rate);
  group.schedule_.push_back({.component = result_->components_[id].get(),
                             .divider = static_cast<std::int64_t>(divider),
                             .phase = node.phase});
  if (auto* device = dynamic_cast<Device*>(result_->components_[id].get()))
    group.devices_.push_back(device);
}

/// Numbers of outputs first, the other outputs, then what arrives: value, tick, validity.
void Wiring::lay_out_memory(RateGroup& group) {
  std::size_t words = 0;
  for (const ScheduleItem& item : group.schedule_)
    for (const OutputPort* output : item.component->outputs())
      words += words_of(*output->signature());
  for (const Arrival& arrival : group.arrivals_) words += words_of(arrival.signature) + 2;
  group.memory_.assign(words, 0.0);

  std::size_t at = 0;
  for (const bool numbers : {true, false}) {
    for (ScheduleItem& item : group.schedule_) {
      if (numbers) item.begin = at;
      for (OutputPort* output : item.component->outputs()) {
        if (is_number(*output->signature()) != numbers) continue;
        output->place(reinterpret_cast<std::byte*>(&group.memory_[at]));
        at += words_of(*output->signature());
      }
      if (numbers) item.end = at;
    }
    if (numbers) group.number_count_ = at;
  }
  for (Arrival& arrival : group.arrivals_) {
    arrival.value = reinterpret_cast<const std::byte*>(&group.memory_[at]);
    at += words_of(arrival.signature);
    arrival.tick = new (&group.memory_[at++]) std::int64_t(-1);
    arrival.valid = new (&group.memory_[at++]) bool(false);
  }
}

void Wiring::connect() {
  for (const ResolvedWire& wire : wires_) {
    if (wire.connection)
      connect_across(wire);
    else
      wire.to->connect({.output = wire.from,
                        .offset = select_field(*wire.from->signature(), wire.path).offset,
                        .this_tick = position_[wire.from_node] < position_[wire.to_node]});
  }
}

void Wiring::connect_across(const ResolvedWire& wire) {
  RateGroup& reader = group_of(wire.to_node);
  RateGroup& producer = group_of(wire.from_node);
  Arrival& arrival = reader.arrivals_[wire.arrival];
  std::byte* const memory = reinterpret_cast<std::byte*>(reader.memory_.data());
  const std::size_t offset = select_field(*wire.from->signature(), wire.path).offset;
  Crossing& crossing = result_->crossings_.emplace_back(
      *wire.connection, std::span(wire.from->data() + offset, arrival.signature.type->size),
      Crossing::Target{memory + reader.offset_of(arrival.value),
                       reinterpret_cast<std::int64_t*>(memory + reader.offset_of(arrival.tick)),
                       reinterpret_cast<bool*>(memory + reader.offset_of(arrival.valid))},
      wire.text());
  arrival.crossing = &crossing;
  // More than fit share the last bit: what is lost for one is then lost for each of them.
  constexpr std::size_t most_bits = 64;
  const std::size_t bit = std::min(producer.departures_.size(), most_bits - 1);
  const std::size_t item = item_index_[wire.from_node];
  producer.departures_.push_back(
      {.crossing = &crossing, .item = item, .mask = std::uint64_t{1} << bit});
  const double divider = static_cast<double>(producer.schedule_[item].divider);
  wire.to->connect({.output = wire.from,
                    .offset = offset,
                    .this_tick = true,
                    .info = &crossing.info(),
                    .value = arrival.value,
                    .transfer = producer.period_ * divider});
}

}  // namespace trocar
