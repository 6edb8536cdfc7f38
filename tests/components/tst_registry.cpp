// SPDX-License-Identifier: Apache-2.0
#include "components/register.hpp"

// Before Qt, whose macros take words that the framework uses.
#include "tests/support/hid_rig.hpp"

#include <QTest>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "framework/component_definition.hpp"
#include "framework/scripting/definition_file.hpp"
#include "framework/wired_graph.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/sanitized.hpp"

using namespace trocar;

namespace {

/// Puts a rotation's w at 1 and every other number at 0, so that the value is a plausible one.
void rest(const TypeInfo& type, std::vector<double>& numbers) {
  if (type.fields.empty()) numbers.push_back(0.0);
  for (const TypeField& field : type.fields) {
    rest(*field.type, numbers);
    if (&type == &type_info<Rotation>() && field.name == "w") numbers.back() = 1.0;
  }
}

/// Feeds any input of numbers: a slow, small motion about rest.
class NumberProbe final : public Component {
 public:
  std::optional<Signature> natural_signature() const override {
    return Signature{&type_info<double>(), 0, {parse_unit("")}, ""};
  }
  void configure(const Setup&) override { rest(*value.signature()->type, rest_); }
  void start() override { write(0.0); }
  void step(const Tick& tick) RT_SAFE override { write(tick.time); }
  GenericOutput value{this, "value", {.doc = "a small motion"}};

 private:
  void write(double t) RT_SAFE {
    for (std::size_t i = 0; i < rest_.size(); ++i)
      value.values()[i] =
          rest_[i] == 1.0 ? 1.0 : 1e-3 * std::sin(6.0 * t + 0.1 * static_cast<double>(i));
  }
  std::vector<double> rest_;
};

/// Feeds an input of another type.
template <typename T>
class ValueProbe final : public Component {
 public:
  void step(const Tick&) RT_SAFE override {}
  Output<T> value{this, "value", {.doc = "a value that stays"}};
};

/// What the no-allocation check must find.
class Allocates final : public Component {
 public:
  void step(const Tick&) RT_SAFE override { numbers_.push_back(1.0); }
  Output<double> value{this, "value", {.doc = "nothing"}};

 private:
  std::vector<double> numbers_;
};

std::string probe_for(const InputPort& input) {
  if (!input.signature()) return "NumberProbe";
  const TypeInfo* type = input.signature()->type;
  if (type == &type_info<bool>()) return "BoolProbe";
  if (type == &type_info<std::int64_t>()) return "IntegerProbe";
  if (type == &type_info<Enumeration>()) return "EnumerationProbe";
  return "NumberProbe";
}

/// The device type that reports what the input needs: where its axes are is no small motion about
/// 0.
std::optional<std::string> device_for(const Registry& registry, const InputPort& input) {
  if (!input.signature()) return std::nullopt;
  for (const ComponentType& type : registry.types()) {
    const auto component = type.make ? type.make() : nullptr;
    auto* device = dynamic_cast<Device*>(component.get());
    if (device != nullptr && device->position().name() == input.name() &&
        mismatch(*device->position().signature(), *input.signature()).empty())
      return type.name;
  }
  return std::nullopt;
}

Registry probes_and_components() {
  Registry registry;
  register_components(registry);
  registry.add<NumberProbe>("NumberProbe", "test", "feeds numbers");
  registry.add<ValueProbe<bool>>("BoolProbe", "test", "feeds a flag");
  registry.add<ValueProbe<std::int64_t>>("IntegerProbe", "test", "feeds an integer");
  registry.add<ValueProbe<Enumeration>>("EnumerationProbe", "test", "feeds a choice");
  registry.add<Allocates>("Allocates", "test", "allocates as it steps");
  return registry;
}

/// The first of some values that the parameter takes.
std::optional<Literal> plausible(const ParameterBase& parameter) {
  const std::string unit = parameter.unit().symbol.empty() ? "" : " " + parameter.unit().symbol;
  std::vector<Literal> candidates = {{0.5}, {1.0}, {true}, {"text"}};
  for (const char* number : {"1", "0.5", "0.01", "10", "100", "0"})
    candidates.push_back({number + unit});
  for (const std::string& choice : parameter.choices()) candidates.push_back({choice});
  for (const std::string& one : {"1" + unit, "0.01" + unit, std::string("0")})
    candidates.push_back(literal_from_text("{" + one + ", " + one + ", " + one + "}"));
  for (const Literal& candidate : candidates)
    if (parameter.check(candidate).empty()) return candidate;
  return std::nullopt;
}

/// A type with a definition has one that is shipped.
NodeId add_alone(Graph& graph, const std::string& type, const Where& where) {
  const ComponentType& known = *graph.registry().find(type);
  if (!known.definition) return *graph.add(type, "", where);
  const ComponentDefinition::Shipped& shipped = known.definition->shipped.front();
  Findings wrong;
  const auto value = lua::read_definition(shipped.name, shipped.name, shipped.text, wrong);
  std::vector<DefinitionMistake> mistakes;
  return *graph.add(defined_type(known, value.value(), mistakes), "", where, "");
}

/// The component alone, each input fed by a probe and each required parameter set.
std::unique_ptr<WiredGraph> alone(const Registry& registry, const std::string& type) {
  Graph graph(registry);
  const Where where{"test", 1};
  const NodeId node = add_alone(graph, type, where);
  const Component& component = *graph.node(node).component;
  for (const ParameterBase* parameter : component.parameters()) {
    if (parameter->assigned()) continue;
    if (const auto value = plausible(*parameter))
      graph.set({node, parameter->name()}, *value, where);
  }
  if (type == "Capture") graph.set({node, "above"}, {1.0}, where);  // or below: one of two
  for (const InputPort* input : component.inputs()) {
    if (const auto device = device_for(registry, *input)) {
      const NodeId source = *graph.add(*device, "device_of_" + input->name(), where);
      graph.connect({source, input->name()}, {node, input->name()}, where);
      continue;
    }
    const NodeId probe = *graph.add(probe_for(*input), "probe_of_" + input->name(), where);
    graph.connect({probe, "value"}, {node, input->name()}, where);
  }
  return wire(graph, {});
}

int allocations_in_steps(WiredGraph& graph, std::int64_t ticks) {
  for (const ScheduleItem& item : graph.main().schedule()) item.component->start();
  return test::allocations_in([&] {
    for (std::int64_t i = 0; i < ticks; ++i) {
      const Tick tick{i, i * 1'000'000, static_cast<double>(i) * 1e-3, 1e-3};
      for (const ScheduleItem& item : graph.main().schedule()) item.component->step(tick);
    }
  });
}

/// Outputs of which only a simulation knows stand under "truth.".
bool is_snake_case(std::string name) {
  if (name.starts_with("truth.")) name.erase(0, 6);
  return !name.empty() && std::islower(static_cast<unsigned char>(name.front())) &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::islower(c) || std::isdigit(c) || c == '_';
         });
}

void component_rows(const Registry& registry) {
  QTest::addColumn<QString>("type");
  for (const ComponentType& type : registry.types())
    if (type.make && type.category != "test")
      QTest::newRow(type.name.c_str()) << QString::fromStdString(type.name);
}

}  // namespace

class TestRegistry : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void holds_components() { QVERIFY(registry_.types().size() > 5); }

  void every_type_has_a_line_of_documentation() {
    for (const ComponentType& type : registry_.types()) {
      QVERIFY2(!type.doc.empty() && type.doc.find('\n') == std::string::npos, type.name.c_str());
      QVERIFY2(is_snake_case(type.category), type.name.c_str());
    }
  }

  void declarations_are_documented_and_in_snake_case_data() { component_rows(registry_); }
  void declarations_are_documented_and_in_snake_case() {
    QFETCH(QString, type);
    const auto component = registry_.find(type.toStdString())->make();
    const auto check = [](const auto& declared) {
      std::set<std::string> names;
      for (const auto* one : declared) {
        QVERIFY2(!one->doc().empty(), one->name().c_str());
        QVERIFY2(is_snake_case(one->name()), one->name().c_str());
        QVERIFY2(names.insert(one->name()).second, one->name().c_str());
      }
    };
    check(component->inputs());
    check(component->outputs());
    check(component->parameters());
  }

  void ten_thousand_steps_do_not_allocate_data() { component_rows(registry_); }
  void ten_thousand_steps_do_not_allocate() {
    QFETCH(QString, type);
    bench_.add(test::EmulatedBench::settings(1));
    std::unique_ptr<WiredGraph> graph;
    try {
      graph = alone(registry_, type.toStdString());
    } catch (const std::exception& error) {
      QFAIL(error.what());
    }
    QCOMPARE(allocations_in_steps(*graph, test::sanitized ? 1'000 : 10'000), 0);
    for (const double number : graph->main().numbers()) QVERIFY(std::isfinite(number));
    for (const ScheduleItem& item : graph->main().schedule()) {
      QVERIFY2(item.component->failure() == nullptr, item.component->failure());
      item.component->stop();
    }
    bench_.units.clear();
  }

  void a_component_that_allocates_is_found() {
    const auto graph = alone(registry_, "Allocates");
    QVERIFY(allocations_in_steps(*graph, 10'000) > 0);
  }

 private:
  test::EmulatedBench bench_;  // for what needs a device of its own
  const Registry registry_ = test::on_bench(probes_and_components(), bench_);
};

QTEST_APPLESS_MAIN(TestRegistry)
#include "tst_registry.moc"
