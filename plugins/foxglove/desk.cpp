// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/desk.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/text.hpp"

namespace trocar::foxglove {
namespace {

constexpr std::int64_t patience_ns = 1'000'000'000;

std::string mistakes(const std::exception& error) {
  const auto* broken = dynamic_cast<const BrokenGraph*>(&error);
  if (broken == nullptr) return error.what();
  std::vector<std::string> messages;
  for (const Finding& finding : broken->findings.all()) messages.push_back(finding.message);
  return join(messages, "; ");
}

/// Numbers without a unit are in SI.
Literal literal_of(const stream::ParameterValue& value, const ParameterState& parameter) {
  const std::string symbol = si_symbol(parameter.unit.dimension);
  const auto number = [&](double one) {
    return symbol.empty() ? Literal{one} : Literal{fmt::format("{:.17g} {}", one, symbol)};
  };
  if (const auto* one = std::get_if<double>(&value)) return number(*one);
  if (const auto* one = std::get_if<bool>(&value)) return Literal{*one};
  if (const auto* text = std::get_if<std::string>(&value)) return literal_from_text(*text);
  Literal::List list;
  if (const auto* numbers = std::get_if<std::vector<double>>(&value))
    for (const double one : *numbers) list.push_back(number(one));
  return Literal{list};
}

const ParameterState* find_state(const std::vector<ParameterState>& all, const std::string& key) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const ParameterState& one) { return one.key == key; });
  return found == all.end() ? nullptr : &*found;
}

Desk::Answer refusal(const Desk::Request& request, const std::string& why) {
  Desk::Answer answer{.client = request.client, .text = {}, .bytes = {}, .changed = {}};
  if (const auto* call = std::get_if<Desk::Call>(&request.what))
    answer.text = stream::call_failure(call->what.service, call->what.call, why);
  else
    answer.text = stream::status(stream::StatusLevel::error, why);
  return answer;
}

}  // namespace

stream::ParameterValue value_of(const ParameterState& parameter) {
  if (parameter.numbers.size() == 1) return parameter.numbers.front();
  if (!parameter.numbers.empty()) return parameter.numbers;
  if (parameter.text == "true" || parameter.text == "false") return parameter.text == "true";
  return parameter.text;
}

void Desk::refuse_overdue(std::int64_t now_ns) {
  for (Request& request : requests_.take_all())
    if (now_ns - request.asked_ns < patience_ns)
      requests_.put(std::move(request));
    else
      answers_.put(refusal(
          request, "no run takes requests now: none is going on, or it is in virtual time"));
}

bool Desk::operate(RunControl& control) {
  const std::deque<Request> requests = requests_.take_all();
  for (const Request& request : requests) try {
      answer(request, control);
    } catch (const std::exception& error) {
      answers_.put(refusal(request, mistakes(error)));
    }
  return !requests.empty();
}

void Desk::answer(const Request& request, RunControl& control) {
  Answer answer;
  if (const auto* get = std::get_if<stream::GetParameters>(&request.what)) {
    answer = answer_get(*get, control);
  } else if (const auto* set = std::get_if<stream::SetParameters>(&request.what)) {
    std::string wrong;
    answer = answer_set(*set, control, wrong);
    if (!wrong.empty()) answers_.put(refusal(request, wrong));
  } else {
    const Call& call = std::get<Call>(request.what);
    answer.bytes = stream::call_response(call.what.service, call.what.call,
                                         calls_.call(call.name, call.what.payload, control));
  }
  answer.client = request.client;
  answers_.put(std::move(answer));
}

Desk::Answer Desk::answer_get(const stream::GetParameters& get, RunControl& control) const {
  std::vector<stream::NamedValue> values;
  const std::vector<ParameterState> all = control.parameters();
  if (get.names.empty())
    for (const ParameterState& one : all) values.push_back({one.key, value_of(one)});
  for (const std::string& name : get.names)
    if (const ParameterState* one = find_state(all, name))
      values.push_back({name, value_of(*one)});
    else
      values.push_back({name, {}});
  return {
      .client = 0, .text = stream::parameter_values(values, get.id), .bytes = {}, .changed = {}};
}

Desk::Answer Desk::answer_set(const stream::SetParameters& set, RunControl& control,
                              std::string& wrong) const {
  Answer answer;
  for (const stream::NamedValue& one : set.values) {
    try {
      const std::vector<ParameterState> before = control.parameters();
      const ParameterState* parameter = find_state(before, one.name);
      // For what is not known, set() names the nearest.
      control.set(one.name, literal_of(one.value, parameter ? *parameter : ParameterState{}));
    } catch (const std::exception& error) {
      wrong += (wrong.empty() ? "" : "; ") + mistakes(error);
    }
  }
  for (const ParameterState& one : control.parameters())
    if (std::any_of(set.values.begin(), set.values.end(),
                    [&](const stream::NamedValue& asked) { return asked.name == one.key; }))
      answer.changed.push_back({one.key, value_of(one)});
  if (!set.id.empty()) answer.text = stream::parameter_values(answer.changed, set.id);
  return answer;
}

}  // namespace trocar::foxglove
