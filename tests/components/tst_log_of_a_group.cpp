// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "components/register.hpp"
#include "framework/recording/mcap_reader.hpp"
#include "framework/recording/ros2_decode.hpp"
#include "framework/session.hpp"
// Qt's macro of that name hides RowStore::signals().
#include <QTemporaryDir>
#include <QTest>
#undef signals

using namespace trocar;

/// The schedule may put a fixture between the parts of a group; a reader must find every value
/// under its own name all the same.
class TestLogOfAGroup : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void every_value_stands_under_its_name() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.mcap").toStdString();
    Registry registry;
    register_components(registry);
    Session session(registry, {.clock = ClockKind::simulated, .record = path});
    Graph& graph = session.graph();
    const NodeId laparoscope = *graph.add("Laparoscope", "", {});
    graph.set({laparoscope, "hand"}, {std::string("push")}, {});
    graph.build_group(laparoscope);
    const NodeId wall = *graph.add("Wall", "", {});
    graph.set({wall, "point"}, literal_from_text("0, 0, 90 mm"), {});
    graph.set({wall, "normal"}, literal_from_text("0, 0, -1"), {});
    graph.place(wall, graph.node(laparoscope).exports.sites.at("tip"), {});
    const SessionRun& run = session.run({.duration = 1.5, .keep_rows = true});
    session.finish();

    std::map<std::string, double> kept;
    for (const RowSignal& signal : run.result.rows->signals())
      kept[signal.name] = run.result.rows->column(signal).back();
    QVERIFY(kept.at("wall.force.z") < -1.0);

    std::map<std::string, double> read = last_row(path);
    for (const auto& [name, value] : kept) {
      QVERIFY2(read.contains(name), name.c_str());
      QVERIFY2(read.at(name) == value, name.c_str());
    }
  }

 private:
  static std::map<std::string, double> last_row(const std::string& path) {
    const McapReader reader(path);
    const McapChannel* rows = reader.channel("/main");
    const McapSchema& schema = reader.schemas().at(rows->schema_id);
    const Ros2Decoder decoder(schema.name, schema.data);
    std::map<std::string, double> values;
    reader.messages([&](const McapMessage& message) {
      if (message.channel != rows->id) return;
      decoder.visit(message.payload, [&](const Ros2Leaf& leaf, const Ros2Value& value) {
        values[leaf.path] = as_double(value);
      });
    });
    return values;
  }
};

QTEST_APPLESS_MAIN(TestLogOfAGroup)
#include "tst_log_of_a_group.moc"
