// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_picture.hpp"
#include "framework/scripting/script.hpp"

#include "tests/support/script_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

/// "wall: wall | Wall", within its clusters: "laparoscope/device: …".
QString place(const GraphPicture& picture, std::optional<std::size_t> cluster) {
  if (!cluster) return "";
  const GraphPicture::Cluster& at = picture.clusters[*cluster];
  return place(picture, at.inside) + text(at.title) + "/";
}

QStringList boxes(const GraphPicture& picture) {
  QStringList list;
  for (const GraphPicture::Box& box : picture.boxes) {
    QStringList parts = {place(picture, box.inside) + text(box.title)};
    if (!box.type.empty()) parts << text(box.type);
    for (const std::string& note : box.notes) parts << text(note);
    if (box.shape == GraphPicture::Shape::device) parts << "(device)";
    if (box.shape == GraphPicture::Shape::gate) parts << "(gate)";
    list << parts.join(" | ");
  }
  return list;
}

QStringList arrows(const GraphPicture& picture) {
  QStringList list;
  for (const GraphPicture::Arrow& arrow : picture.arrows) {
    QStringList labels;
    for (const GraphPicture::Label& label : arrow.labels)
      labels << text(label.ports) + (label.type.empty() ? "" : ": " + text(label.type));
    const auto name = [&](std::size_t box) {
      const bool gate = picture.boxes[box].shape == GraphPicture::Shape::gate;
      return text((gate ? "gate of " : "") + picture.boxes[box].name);
    };
    const char* line = arrow.line == GraphPicture::Line::same_tick      ? " --> "
                       : arrow.line == GraphPicture::Line::other_thread ? " ==> "
                                                                        : " ..> ";
    list << name(arrow.from) + line + name(arrow.to) + " | " + labels.join(" | ");
  }
  return list;
}

const QByteArray parts =
    "local device = trocar.SimulatedLaparoscope { hand = 'none', mount = { pitch = '20 deg' } }\n"
    "local foaw = trocar.Foaw { position = device.position }\n"
    "local tool = trocar.LaparoscopeKinematics { position = device.position,"
    " velocity = foaw.velocity }\n";

}  // namespace

class TestGraphPicture : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_shows_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QStringList>("wanted_boxes");
    QTest::addColumn<QStringList>("wanted_arrows");
    const auto row = [](const char* name, const QByteArray& script, const QStringList& some_boxes,
                        const QStringList& some_arrows) {
      QTest::newRow(name) << script << some_boxes << some_arrows;
    };
    row("name, type, and what a component cannot be without",
        "trocar.Sine { amplitude = '3 mm', name = 'breath' }", {"breath | Sine | amplitude = 3 mm"},
        {});
    row("a rate of its own",
        parts + "trocar.Difference { position = device.position, rate = '100 Hz', phase = 3 }",
        {"difference | Difference | 100 Hz, phase 3"}, {});
    row("no phase where it is 0",
        parts + "trocar.Difference { position = device.position, rate = '100 Hz' }",
        {"difference | Difference | 100 Hz"}, {});
    row("a device", parts, {"simulated_laparoscope | SimulatedLaparoscope | (device)"}, {});
    row("ports that are called alike once, with units in short", parts, {},
        {"simulated_laparoscope --> foaw | position: Joints [m ×3, rad ×3]",
         "foaw --> laparoscope_kinematics | velocity: Joints [m/s ×3, rad/s ×3]"});
    row("the field that is read, and its type",
        parts +
            "trocar.Wall { position = tool.tip.position, velocity = tool.tip.velocity,"
            " offset = tool.pose.position.z }",
        {},
        {"laparoscope_kinematics --> wall | pose.position.z → offset: double [m] | "
         "tip.position → position: Vector3 [m] | tip.velocity → velocity: Vector3 [m/s]"});
    row("the gate between a device and what feeds hold or effort, outside of every group",
        "trocar.Laparoscope {}",
        {"laparoscope/device | SimulatedLaparoscope | (device)", "gate | (gate)"},
        {"laparoscope.weight ..> gate of laparoscope.device | effort → hold: Joints [N ×3, N m ×3]",
         "laparoscope.statics ..> gate of laparoscope.device | effort: Joints [N ×3, N m ×3]",
         "gate of laparoscope.device ..> laparoscope.device | GatedEffort"});
    row("a gate for each device",
        "trocar.Laparoscope { name = 'left' } trocar.Laparoscope { name = 'right' }",
        {"gate | of left.device | (gate)", "gate | of right.device | (gate)"}, {});
    row("a load on the tool, which passes no gate",
        "trocar.Staircase { at = trocar.Laparoscope {}.tip, peak = '5 N' }", {},
        {"staircase ..> laparoscope.device | force → tip_load: Vector3 [N]"});
    row("a loop's delay as read later",
        "local delay = trocar.Delay { name = 'last', initial = 0 }\n"
        "local sum = trocar.Sum { terms = { trocar.Constant { value = '1 N' }.value, delay.value } "
        "}\n"
        "sum.value:to(delay.input)",
        {"last | Delay | initial = 0"},
        {"sum ..> last | value → input: double [N]", "last --> sum | value → terms: double [N]"});
    row("the type that a generic port got",
        "local c = trocar.Constant { value = '2 N' }\n"
        "trocar.Scale { input = c.value, factor = '3 mm' }",
        {"scale | Scale | factor = 3 mm"}, {"constant --> scale | value → input: double [N]"});
    row("a parameter that follows another component's",
        parts + "trocar.GravityCompensation { position = device.position, mount = device.mount }",
        {"gravity_compensation | GravityCompensation | mount = simulated_laparoscope.mount"}, {});
    row("nothing of what a group forwards to its own parts", "trocar.Laparoscope {}",
        {"laparoscope/weight | GravityCompensation"}, {});
    row("threads, where there are several, and how values go between them",
        "local fast = trocar.thread { rate = '1 kHz' }\n"
        "local slow = trocar.thread { rate = '100 Hz', priority = 40 }\n"
        "local wall = fast.Wall { at = fast.Laparoscope {}.tip }\n"
        "slow.Creep { load = wall.load:latest { stale = '5 ms' } }",
        {"fast/laparoscope/device | SimulatedLaparoscope | (device)", "fast/gate | (gate)",
         "fast/wall | Wall", "slow/creep | Creep"},
        {"wall ==> creep | load, latest, stale 5 ms: double [N]"});
    row("groups in groups",
        "local Inner = trocar.group { name = 'Inner', build = function()\n"
        "  return { value = trocar.Constant { value = '1 N' }.value } end }\n"
        "local Outer = trocar.group { name = 'Outer', build = function()\n"
        "  return { value = Inner {}.value } end }\n"
        "Outer {}",
        {"outer/inner/constant | Constant | value = \"1 N\""}, {});
  }
  void it_shows() {
    QFETCH(QByteArray, script);
    QFETCH(QStringList, wanted_boxes);
    QFETCH(QStringList, wanted_arrows);
    const ScriptOutcome outcome = run_script_text(script, {}, {.check_only = true});
    QCOMPARE(outcome.findings, QStringList());
    const Graph& graph = outcome.session->graph();
    const GraphPicture picture = picture_of(graph, *wire(graph, {}));
    for (const QString& box : wanted_boxes)
      QVERIFY2(boxes(picture).contains(box), qPrintable(boxes(picture).join('\n')));
    for (const QString& arrow : wanted_arrows)
      QVERIFY2(arrows(picture).contains(arrow), qPrintable(arrows(picture).join('\n')));
  }

  void what_comes_back_from_a_gate_and_into_a_delay_closes_a_loop() {
    const ScriptOutcome outcome = run_script_text(
        "local scope = trocar.Laparoscope {}\n"
        "trocar.Staircase { at = scope.tip, peak = '5 N' }\n"
        "local delay = trocar.Delay { initial = 0 }\n"
        "local sum = trocar.Sum { terms = { trocar.Constant { value = '1 N' }.value, delay.value } "
        "}\n"
        "sum.value:to(delay.input)",
        {}, {.check_only = true});
    QCOMPARE(outcome.findings, QStringList());
    const Graph& graph = outcome.session->graph();
    const GraphPicture picture = picture_of(graph, *wire(graph, {}));
    QStringList back;
    for (const GraphPicture::Arrow& arrow : picture.arrows)
      if (arrow.back)
        back << text(picture.boxes[arrow.from].title + " " + picture.boxes[arrow.to].title);
    QCOMPARE(back, QStringList({"gate device", "sum delay"}));
  }

  void a_cluster_comes_before_those_inside_it() {
    const ScriptOutcome outcome = run_script_text(
        "local Rig = trocar.group { name = 'Rig', build = function()\n"
        "  return { tip = trocar.Laparoscope {}.pose } end }\n"
        "Rig {}",
        {}, {.check_only = true});
    QCOMPARE(outcome.findings, QStringList());
    const Graph& graph = outcome.session->graph();
    const GraphPicture picture = picture_of(graph, *wire(graph, {}));
    QCOMPARE(picture.clusters.size(), std::size_t{2});
    QCOMPARE(picture.clusters[0].name, std::string("rig"));
    QCOMPARE(picture.clusters[1].name, std::string("rig.laparoscope"));
    QCOMPARE(picture.clusters[1].type, std::string("Laparoscope"));
    QVERIFY(picture.clusters[1].inside == std::size_t{0});
  }
};

QTEST_GUILESS_MAIN(TestGraphPicture)
#include "tst_graph_picture.moc"
