// SPDX-License-Identifier: Apache-2.0
// What `trocar list` and `trocar describe` say, on a registry of the test's own.
#include "cli/description.hpp"

#include <QFile>
#include <QTest>
#include <nlohmann/json.hpp>

#include "cli/catalogue.hpp"
#include "cli/reference.hpp"
#include "components/register.hpp"
#include "framework/graph.hpp"

using namespace trocar;
using namespace trocar::cli;

namespace {

struct Pusher final : Component {
  Input<Vector3> position{this, "position", {.unit = "m", .frame = "device", .doc = "Where it is"}};
  Input<double> gain{this, "gain", {.doc = "Factor", .optional = true}};
  Output<Vector3> force{this, "force", {.unit = "N", .frame = "device", .doc = "Its push"}};
  Parameter<double> stiffness{this,
                              "stiffness",
                              {.unit = "N/m",
                               .initial = "2.2 N/mm",
                               .min = "0 N/mm",
                               .max = "50 N/mm",
                               .doc = "How hard it pushes, for each metre that the tool is behind "
                                      "the place where it should be",
                               .live = true}};
  Parameter<double> mass{this, "mass", {.unit = "kg", .doc = "What it moves"}};
  Parameter<Choice> axis{this, "axis", {.initial = "x", .doc = "Along", .choices = {"x", "y"}}};

  Pusher() { place({.position = &position, .force = &force}); }
  void step(const Tick&) RT_SAFE override {}
};

struct Rig final : Group {
  Parameter<double> weight{this, "weight", {.unit = "kg", .initial = "1 kg", .doc = "Of it all"}};
  void build(GroupScope& scope) override {
    const NodeId pusher = scope.add("Pusher", "arm");
    scope.exports().outputs["lift"] = {pusher, "force", "z"};
    scope.exports().sites["tip"] = {};
  }
};

Registry registry() {
  Registry all;
  all.add<Pusher>("Pusher", "fixtures", "Pushes the tool");
  all.add<Rig>("Rig", "devices", "A pusher with a stand");
  return all;
}

}  // namespace

class TestDescription : public QObject {
  Q_OBJECT

  const Registry registry_ = registry();

 private Q_SLOTS:
  void components_are_listed_by_category() {
    QCOMPARE(catalogue_text(registry_), std::string("fixtures\n  Pusher  Pushes the tool\n\n"
                                                    "devices\n  Rig     A pusher with a stand "
                                                    "(group)\n\n"
                                                    "One of them in full: trocar describe "
                                                    "Pusher\n"));
    const auto json = catalogue_json(registry_)["components"];
    QCOMPARE(json.size(), std::size_t(2));
    QCOMPARE(json[0]["name"].get<std::string>(), std::string("Pusher"));
    QVERIFY(!json[0]["group"].get<bool>() && json[1]["group"].get<bool>());
  }

  void a_component_of_a_plugin_says_so() {
    Registry all;
    ComponentType type = *registry_.find("Pusher");
    type.plugin = "stand";
    all.add(type);
    QVERIFY(
        catalogue_text(all).starts_with("fixtures\n  Pusher  Pushes the tool (plugin stand)\n"));
    QCOMPARE(catalogue_json(all)["components"][0]["plugin"].get<std::string>(),
             std::string("stand"));
    QVERIFY(catalogue_json(registry_)["components"][0]["plugin"].is_null());
  }

  void an_empty_registry_is_said_to_be_empty() {
    QCOMPARE(catalogue_text(Registry()), std::string("No components are registered.\n"));
    QVERIFY(catalogue_json(Registry())["components"].is_array());
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, describe(Registry(), "Pusher"));
  }

  void a_component_is_described_in_full() {
    const std::string text = description_text(describe(registry_, "Pusher"));
    for (const char* part :
         {"Pusher (fixtures)\n  Pushes the tool\n",
          "  local pusher = trocar.Pusher { at = laparoscope.tip, mass = \"1 kg\", stiffness = ",
          "Inputs\n  position  Vector3 [m] in device, wired by at\n            Where it is\n",
          "  gain      double, optional\n", "Outputs\n  force  Vector3 [N] in device\n",
          "  stiffness  number, 0–50 N/mm, default 2.2 N/mm, live\n",
          "  mass       number [kg], required\n",
          "  axis       one of \"x\", \"y\", default \"x\"\n"})
      QVERIFY2(text.find(part) != std::string::npos, (part + ("\nis not in\n" + text)).c_str());
  }

  void no_line_is_wider_than_a_terminal() {
    for (const ComponentType& type : registry_.types()) {
      const QString text = QString::fromStdString(description_text(describe(registry_, type.name)));
      for (const QString& line : text.split('\n'))
        QVERIFY2(line.size() <= 80 || line.contains("trocar."), qPrintable(line));
    }
  }

  void a_component_is_described_for_programs() {
    const auto json = description_json(describe(registry_, "Pusher"));
    QCOMPARE(json["inputs"][0]["unit"].get<std::string>(), std::string("m"));
    QVERIFY(json["inputs"][1]["optional"].get<bool>());
    QCOMPARE(json["outputs"][0]["frame"].get<std::string>(), std::string("device"));
    QCOMPARE(json["parameters"][0]["range"].get<std::string>(), std::string("0–50 N/mm"));
    QVERIFY(json["parameters"][0]["live"].get<bool>());
    QVERIFY(json["parameters"][1]["default"].is_null());
    QCOMPARE(json["parameters"][2]["choices"].size(), std::size_t(2));
  }

  void a_group_shows_what_it_offers() {
    const Description rig = describe(registry_, "Rig");
    QVERIFY(rig.group);
    QCOMPARE(rig.outputs.at(0).name, std::string("lift"));
    QCOMPARE(rig.outputs.at(0).type, std::string("double"));
    QCOMPARE(rig.outputs.at(0).unit, std::string("N"));
    QCOMPARE(rig.sites.at(0), std::string("tip"));
    QCOMPARE(rig.parts.at("arm"), std::string("Pusher"));
    QCOMPARE(rig.parameters.at(0).name, std::string("weight"));
    QVERIFY(description_text(rig).find("Sites (for at)\n  tip\n") != std::string::npos);
  }

  void the_reference_is_of_today() {
    Registry registry;
    register_components(registry);
    QFile page(TROCAR_SOURCE_DIR "/docs/components.md");
    QVERIFY(page.open(QFile::ReadOnly));
    QVERIFY2(page.readAll().toStdString() == reference_markdown(registry),
             "build/bin/trocar list --markdown > docs/components.md");
  }

  void a_misspelt_name_gets_the_nearest() {
    try {
      describe(registry_, "Pushr");
      QFAIL("it was taken");
    } catch (const std::invalid_argument& error) {
      QCOMPARE(std::string(error.what()),
               std::string("there is no component \"Pushr\", did you mean \"Pusher\"?"));
    }
  }
};

QTEST_APPLESS_MAIN(TestDescription)
#include "tst_description.moc"
