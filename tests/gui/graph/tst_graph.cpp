// SPDX-License-Identifier: Apache-2.0
// A graph is drawn in order, and what is told of its components is what the rows say.
#include <QAbstractItemModelTester>
#include <QApplication>
#include <QSignalSpy>
#include <QTableView>
#include <random>

#include "gui/graph/graph_reading.hpp"
#include "gui/operate/operator.hpp"
#include "gui/pages/graph_page.hpp"
#include "tests/gui/log_rig.hpp"
#include "tests/gui/pictures.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::colours_in;
using trocar::test::LogRig;
using trocar::test::picture_of;

namespace {

QByteArray script_text(const char* name) {
  QFile file(QString(TROCAR_SOURCE_DIR "/scripts/tutorial/") + name);
  return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

GraphStructure random_graph(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  GraphStructure graph;
  const std::size_t groups = below(5), nodes = 1 + below(30);
  for (std::size_t i = 0; i < groups; ++i)
    graph.groups.push_back({"g" + std::to_string(i), "group",
                            i > 0 && below(2) == 0 ? std::optional(below(i)) : std::nullopt});
  graph.threads = 1 + below(3);
  for (std::size_t i = 0; i < nodes; ++i)
    graph.nodes.push_back(
        {.name = "n" + std::to_string(i),
         .type = "T",
         .doc = "",
         .thread = "t" + std::to_string(below(graph.threads)),
         .group = groups > 0 && below(3) > 0 ? std::optional(below(groups)) : std::nullopt});
  for (std::size_t i = 0; i < 2 * nodes; ++i)
    graph.edges.push_back({.from = below(nodes),
                           .to = below(nodes),
                           .line = static_cast<GraphStructure::Line>(below(3))});
  return graph;
}

bool meets(const QRectF& box, const QLineF& line) {
  const QRectF inner = box.adjusted(1, 1, -1, -1);
  if (inner.contains(line.p1()) || inner.contains(line.p2())) return true;
  const QLineF sides[] = {{inner.topLeft(), inner.topRight()},
                          {inner.topRight(), inner.bottomRight()},
                          {inner.bottomRight(), inner.bottomLeft()},
                          {inner.bottomLeft(), inner.topLeft()}};
  return std::any_of(std::begin(sides), std::end(sides), [&](const QLineF& side) {
    return side.intersects(line, nullptr) == QLineF::BoundedIntersection;
  });
}

/// What is wrong with a layout, or "".
QString mistake_in(const GraphStructure& graph, const GraphLayout& layout) {
  for (std::size_t i = 0; i < layout.boxes.size(); ++i) {
    if (!layout.bounds.contains(layout.boxes[i])) return "a box is out of bounds";
    for (std::size_t j = 0; j < i; ++j)
      if (layout.boxes[i].intersects(layout.boxes[j]))
        return QString("boxes %1 and %2 overlap").arg(i).arg(j);
    for (const GraphLayout::Frame& frame : layout.frames)
      if (frame.rect.intersects(layout.boxes[i]) && !frame.rect.contains(layout.boxes[i]))
        return QString("box %1 is on the edge of %2").arg(i).arg(frame.title);
  }
  for (std::size_t i = 0; i < layout.frames.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const QRectF &inner = layout.frames[i].rect, &outer = layout.frames[j].rect;
      if (inner.intersects(outer) && !outer.contains(inner) && !inner.contains(outer))
        return layout.frames[i].title + " overlaps " + layout.frames[j].title;
    }
  for (std::size_t i = 0; i < layout.routes.size(); ++i) {
    const GraphLayout::Route& route = layout.routes[i];
    const bool rightwards = layout.layers[graph.edges[i].to] > layout.layers[graph.edges[i].from];
    if (rightwards == route.back) return QString("wire %1 goes the wrong way").arg(i);
    for (qsizetype k = 1; k < route.points.size(); ++k) {
      if (!route.back && route.points[k].x() < route.points[k - 1].x())
        return QString("wire %1 turns back").arg(i);
      for (std::size_t box = 0; box < layout.boxes.size(); ++box)
        if (meets(layout.boxes[box], {route.points[k - 1], route.points[k]}))
          return QString("wire %1 runs through box %2").arg(i).arg(box);
    }
  }
  return "";
}

/// A graph whose wires of the same tick have no loop, as those that run.
bool runs(const GraphStructure& graph) {
  const GraphLayout layout = GraphLayout::of(graph);
  for (std::size_t i = 0; i < graph.edges.size(); ++i)
    if (graph.edges[i].line == GraphStructure::Line::same_tick && layout.routes[i].back)
      return false;
  return true;
}

}  // namespace

class TestGraph : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_layout_is_in_order_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<int>("threads");
    QTest::addColumn<int>("frames");
    QTest::newRow("one group and a fixture") << script_text("01_feel_a_wall.lua") << 1 << 1;
    QTest::newRow("parts wired by hand") << script_text("03_tilted.lua") << 1 << 0;
    QTest::newRow("two threads") << script_text("04_two_rates.lua") << 2 << 3;
    QTest::newRow("a group of the script") << script_text("10_group.lua") << 1 << -1;
  }
  void the_layout_is_in_order() {
    QFETCH(QByteArray, script);
    LogRig rig(script);
    QVERIFY2(rig.findings.isEmpty(), qPrintable(rig.findings.join('\n')));
    const GraphStructure graph = GraphStructure::of(rig.feed.graph());
    QTEST(static_cast<int>(graph.threads), "threads");
    const GraphLayout layout = GraphLayout::of(graph);
    QCOMPARE(mistake_in(graph, layout), QString());
    QVERIFY(runs(graph));
    QFETCH(int, frames);
    if (frames >= 0) QCOMPARE(static_cast<int>(layout.frames.size()), frames);
  }

  void any_graph_is_laid_out_in_order() {
    int back = 0, wires = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
      const GraphStructure graph = random_graph(seed);
      const GraphLayout layout = GraphLayout::of(graph);
      const QString mistake = mistake_in(graph, layout);
      QVERIFY2(mistake.isEmpty(), qPrintable(QString("seed %1: %2").arg(seed).arg(mistake)));
      for (const GraphLayout::Route& route : layout.routes) back += route.back;
      wires += static_cast<int>(layout.routes.size());
    }
    qInfo("%d of %d wires go back", back, wires);
    QVERIFY(back > 0 && back < wires);
  }

  void what_is_no_graph_is_an_empty_one_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("nothing") << QByteArray("null");
    QTest::newRow("numbers") << QByteArray(R"({"nodes": [1, {}], "wires": [3, {"source": 1}]})");
    QTest::newRow("groups in each other")
        << QByteArray(R"({"groups": [{"name": "a", "group": "b"}, {"name": "b", "group": "a"}]})");
    QTest::newRow("wires to nothing")
        << QByteArray(R"({"wires": [{"source": {"node": "a"}, "target": {"node": "b"}}]})");
  }
  void what_is_no_graph_is_an_empty_one() {
    QFETCH(QByteArray, text);
    const GraphStructure graph = GraphStructure::of(nlohmann::json::parse(text.toStdString()));
    QVERIFY(graph.nodes.empty() && graph.edges.empty());
    QVERIFY(GraphLayout::of(graph).boxes.empty());
  }

  void components_say_how_they_are() {
    LogRig rig(script_text("01_feel_a_wall.lua"), {}, 2.0);
    GraphModel model(rig.sources());
    const std::size_t wall = *model.structure().find("wall");
    QCOMPARE(model.node(wall).state, GraphModel::State::running);
    QVERIFY(std::abs(model.node(wall).rate - 1000.0) < 1e-6);
    QVERIFY(std::isnan(model.node(wall).step_mean));  // virtual time
    QVERIFY(model.description(wall).startsWith("wall, a Wall; running; 1000 Hz"));

    rig.store.add_event({1500, 1.5, "main", "fault", "wall", "too deep", 1.0, 0.5});
    model.refresh();
    QCOMPARE(model.node(wall).state, GraphModel::State::faulted);
    QCOMPARE(model.state_text(wall), QString("FAULT: too deep"));
    rig.store.set_view_end(1.0);  // it had not happened yet
    model.refresh();
    QCOMPARE(model.node(wall).state, GraphModel::State::running);
    rig.store.set_view_end(std::nullopt);
    rig.store.add_event({1600, 1.6, "main", "acknowledged", "", "", 0.0, 0.0});
    model.refresh();
    QCOMPARE(model.node(wall).state, GraphModel::State::running);
  }

  void ports_have_values_and_units() {
    LogRig rig(script_text("01_feel_a_wall.lua"), {}, 2.0);
    GraphModel model(rig.sources());
    CellTable table(GraphModel::port_header());
    QAbstractItemModelTester tester(&table);
    table.show(model.port_rows(*model.structure().find("wall")));
    const auto text = [&](const QString& port, int column) {
      for (int row = 0; row < table.rowCount(); ++row)
        if (table.index(row, 1).data() == port) return table.index(row, column).data().toString();
      return QString("no such port");
    };
    const double depth = rig.store.find("wall.depth")->last();
    QVERIFY(depth > 0.0);
    QCOMPARE(text("depth", 2), QString("%1 mm").arg(1e3 * depth, 0, 'f', 2));
    QCOMPARE(text("force", 0), QString("out"));
    QVERIFY(text("force", 2).endsWith(" N"));
    QCOMPARE(text("force", 3), QString("laparoscope.statics.tip_force"));
    QCOMPARE(text("position", 3), QString("laparoscope.tool.tip.position"));
    QVERIFY(text("position", 2).endsWith(" mm"));
    QCOMPARE(text("offset", 2), QString("–"));
    table.show(model.port_rows(*model.structure().find("laparoscope.device")));
    QVERIFY(text("position", 2).contains(" mm; ") && text("position", 2).endsWith("°"));
  }

  void values_between_threads_have_an_age() {
    LogRig rig(script_text("04_two_rates.lua"), {}, 0.5);
    GraphModel model(rig.sources());
    int known = 0;
    for (std::size_t i = 0; i < model.structure().edges.size(); ++i) {
      if (model.structure().edges[i].line != GraphStructure::Line::other_thread) continue;
      QVERIFY(model.edge(i).known);
      QVERIFY(model.edge(i).valid);
      QVERIFY(model.edge(i).age >= 0.0 && model.edge(i).age <= 0.011);
      ++known;
    }
    QCOMPARE(known, 2);
    QCOMPARE(model.node(*model.structure().find("sine")).rate, 100.0);
  }

  void components_are_chosen_by_mouse_and_keys() {
    LogRig rig(script_text("01_feel_a_wall.lua"), {}, 1.0);
    GraphModel model(rig.sources());
    GraphView view(model);
    view.resize(900, 500);
    view.show();
    QVERIFY(QTest::qWaitForWindowActive(&view));
    QSignalSpy chosen(&view, &GraphView::selected_changed);
    for (std::size_t node = model.structure().nodes.size(); node-- > 0;) {
      QTest::mouseClick(&view, Qt::LeftButton, {}, view.box_of(node).center().toPoint());
      QCOMPARE(view.selected(), std::optional(node));
      QCOMPARE(view.accessibleDescription(), model.description(node));
    }
    QVERIFY(chosen.size() >= 5);
    // Every component is reached by the arrow keys from the first.
    std::set<std::size_t> reached = {0};
    for (std::size_t size = 0; size < reached.size();) {
      size = reached.size();
      for (const std::size_t from : std::set(reached))
        for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}) {
          view.select(from);
          QTest::keyClick(&view, key);
          reached.insert(*view.selected());
        }
    }
    QCOMPARE(reached.size(), model.structure().nodes.size());
    const double scale = view.scale();
    QTest::keyClick(&view, Qt::Key_Plus);
    QVERIFY(view.scale() > scale);
    QTest::keyClick(&view, Qt::Key_Home);
    QCOMPARE(view.scale(), scale);
  }

  void the_page_shows_the_chosen_component() {
    for (const char* script : {"01_feel_a_wall.lua", "04_two_rates.lua"}) {
      LogRig rig(script_text(script), {}, 1.0);
      Operator operators(rig.sources());
      for (const Theme& theme : {Theme::dark_one(), Theme::light()}) {
        QApplication::setPalette(theme.palette());
        GraphPage page(operators);
        page.set_theme(theme);
        page.resize(1260, 600);
        page.view().select(*GraphStructure::of(rig.feed.graph()).find("wall"));
        page.refresh();
        const QImage image =
            picture_of(page, QString("graph_%1_%2").arg(script).arg(theme.dark ? "dark" : "light"));
        QVERIFY(colours_in(image) > 50);
        auto* table = page.findChild<QTableView*>("port_table");
        QCOMPARE(table->model()->rowCount(), 6);
      }
    }
  }
};

QTEST_MAIN(TestGraph)
#include "tst_graph.moc"
