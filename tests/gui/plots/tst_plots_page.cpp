// SPDX-License-Identifier: Apache-2.0
// The page of plots, as people use it.
#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "gui/pages/plots_page.hpp"
#include "gui/window/main_window.hpp"
#include "tests/gui/pictures.hpp"
#include "tests/gui/track_rig.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::TrackRig;

namespace {

/// A page in a window that looks at hand-made rows at 1 kHz.
struct Looking {
  Looking() {
    page = new PlotsPage(operators);
    window.add_page(page);
    window.show();
  }
  void feed(std::int64_t to) {
    rig.feed(fed, to, 1000.0, [](std::size_t i, std::int64_t tick) {
      return std::sin(0.004 * static_cast<double>(tick) + static_cast<double>(i)) +
             (tick == spike ? 9.0 : 0.0);
    });
    fed = to;
    window.refresh();
  }
  PlotPane& pane(int n) { return *page->findChild<PlotPane*>(QString("plot %1").arg(n)); }
  std::vector<std::string> curves(int n) { return pane(n).description().names; }
  void drop(PlotPane& onto, const QByteArray& names) {
    QMimeData mime;
    mime.setData(SignalTree::mime_type, names);
    QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&onto, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPoint(20, 20), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&onto, &drop);
  }
  template <typename T>
  T& find(const char* name) {
    return *page->findChild<T*>(name);
  }
  void choose(const QString& search) {
    find<QLineEdit>("signal_search").setText(search);
    auto& tree = find<QTreeView>("signal_tree");
    tree.selectionModel()->clear();
    for (int row = 0; row < tree.model()->rowCount(); ++row)
      tree.selectionModel()->select(tree.model()->index(row, 0),
                                    QItemSelectionModel::Select | QItemSelectionModel::Rows);
  }

  static constexpr std::int64_t spike = 4000;
  TrackRig rig{{"wall.force.x", "wall.force.z", "tip.x"}};
  Operator operators{Sources{rig.store}};
  MainWindow window{operators, "hand-made"};
  PlotsPage* page;
  std::int64_t fed = 0;
};

RunEvent event_at(double time, const char* kind, const char* source, const char* detail) {
  RunEvent made;
  made.time = time;
  made.kind = kind;
  made.source = source;
  made.detail = detail;
  return made;
}

}  // namespace

class TestPlotsPage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void signals_are_dropped_onto_a_plot() {
    Looking looking;
    looking.feed(2000);
    QCOMPARE(looking.page->board().count(), 1);
    QVERIFY(looking.curves(1).empty());
    looking.drop(looking.pane(1), "wall.force.x\nwall.force.z");
    looking.drop(looking.pane(1), "wall.force.z");  // is there already
    QCOMPARE(looking.curves(1), (std::vector<std::string>{"wall.force.x", "wall.force.z"}));
    looking.window.refresh();
    QVERIFY(looking.pane(1).heading().contains("wall.force"));
    QMimeData other;
    other.setText("wall.force.x");
    QDragEnterEvent enter(QPoint(20, 20), Qt::CopyAction, &other, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&looking.pane(1), &enter);
    QVERIFY(!enter.isAccepted());
  }

  void signals_are_searched_and_added_by_keys() {
    Looking looking;
    looking.feed(100);
    looking.choose("WALL.force");
    QTest::keyClick(&looking.find<QTreeView>("signal_tree"), Qt::Key_Return);
    QCOMPARE(looking.curves(1), (std::vector<std::string>{"wall.force.x", "wall.force.z"}));
    QTest::mouseClick(&looking.find<QPushButton>("add_plot"), Qt::LeftButton);
    QCOMPARE(looking.page->board().count(), 2);
    QCOMPARE(looking.page->board().chosen(), 1);
    // A click, or the keyboard's focus, chooses a plot.
    QTest::mouseClick(&looking.pane(1).canvas(), Qt::LeftButton);
    QCOMPARE(looking.page->board().chosen(), 0);
    looking.choose("tip");
    QTest::keyClick(&looking.find<QTreeView>("signal_tree"), Qt::Key_Return);
    QCOMPARE(looking.curves(1).back(), std::string("tip.x"));
    // Delete in the table takes a curve out.
    looking.window.refresh();
    auto& values = looking.find<QTableView>("value_table");
    QCOMPARE(values.model()->rowCount(), 5);
    QCOMPARE(values.model()->index(2, 1).data().toString(), QString("tip.x"));
    values.setCurrentIndex(values.model()->index(2, 1));
    QVERIFY(QTest::qWaitForWindowActive(&looking.window));
    values.setFocus();
    QTest::keyClick(&values, Qt::Key_Delete);
    QCOMPARE(looking.curves(1).size(), std::size_t{2});
    QTest::mouseClick(&looking.find<QPushButton>("remove_plot"), Qt::LeftButton);
    QCOMPARE(looking.page->board().count(), 1);
  }

  void a_plot_gets_a_title() {
    Looking looking;
    looking.feed(10);
    QTest::mouseClick(&looking.find<QPushButton>("plot_title"), Qt::LeftButton);
    auto* dialog = looking.page->findChild<QInputDialog*>("title_dialog");
    QVERIFY(dialog != nullptr);
    dialog->setTextValue("Contact & release");
    dialog->accept();
    QCOMPARE(looking.page->layout_shown().plots[0].title, std::string("Contact & release"));
    QVERIFY(looking.pane(1).heading().contains("Contact &amp; release"));
    QCOMPARE(looking.pane(1).canvas().accessibleName(), QString("plot 1, Contact & release"));
  }

  void one_signal_over_another() {
    Looking looking;
    looking.feed(3000);
    looking.choose("tip");
    QTest::mouseClick(&looking.find<QPushButton>("add_xy"), Qt::LeftButton);
    QCOMPARE(looking.page->board().count(), 1);
    QVERIFY(looking.find<QLabel>("plots_notice").text().contains("takes two signals"));
    looking.choose("wall");
    QTest::mouseClick(&looking.find<QPushButton>("add_xy"), Qt::LeftButton);
    QCOMPARE(looking.page->board().count(), 2);
    looking.window.refresh();
    QVERIFY(looking.pane(2).heading().contains("wall.force.z over wall.force.x"));
    looking.drop(looking.pane(2), "tip.x");  // takes the place of y
    QCOMPARE(looking.curves(2), (std::vector<std::string>{"wall.force.x", "tip.x"}));
  }

  void a_spike_is_seen_over_another_signal_too() {
    TrackRig rig({"x", "y"});
    XyPlot plot(rig.store);
    plot.set_signals("x", "y");
    rig.feed(0, 60'000, 10'000.0, [](std::size_t i, std::int64_t tick) {
      return i == 0 ? static_cast<double>(tick % 1000) : tick == 31'337 ? 5.0 : 0.0;
    });
    plot.refresh();
    QVERIFY(plot.canvas().yAxis->range().upper >= 5.0);
  }

  void scrubbing_freezes_the_window_and_keeps_cursors_at_their_rows() {
    Looking looking;
    looking.feed(20'000);
    PlotsPage& page = *looking.page;
    page.set_cursors(Cursors{-4.0, -2.0});
    const double newest = looking.rig.store.now();
    QTest::keyClick(&looking.pane(1).canvas(), Qt::Key_Left);  // a twentieth
    QVERIFY(looking.window.frozen());
    QCOMPARE(page.window_shown().end, newest - 0.5);
    QCOMPARE((*page.cursors())[0], -3.5);
    looking.feed(21'000);  // the run goes on
    QCOMPARE(page.window_shown().end, newest - 0.5);
    QVERIFY(looking.find<QLabel>("scrub_place").text().contains("frozen"));
    QTest::keyClick(&looking.pane(1).canvas(), Qt::Key_Right, Qt::ShiftModifier);  // cursor B
    QCOMPARE((*page.cursors())[1], -1.5 + 0.0025 * 10.0);
    // To the right end, and it follows again.
    for (int i = 0; i < 3; ++i) QTest::keyClick(&looking.pane(1).canvas(), Qt::Key_Right);
    QVERIFY(!looking.window.frozen());
    QCOMPARE(page.window_shown().end, looking.rig.store.now());
    looking.find<QSlider>("scrub").setValue(5000);
    QVERIFY(looking.window.frozen());
    QVERIFY(std::abs(page.window_shown().end - 10.5) < 0.01);
    QVERIFY(QTest::qWaitForWindowActive(&looking.window));
    QTest::keyClick(&looking.window, Qt::Key_F8);
    QVERIFY(!looking.window.frozen());
    QCOMPARE(page.window_shown().end, looking.rig.store.now());
  }

  void the_mouse_moves_the_picture_and_cursors() {
    Looking looking;
    looking.feed(20'000);
    PlotsPage& page = *looking.page;
    QCustomPlot& canvas = looking.pane(1).canvas();
    const int middle = canvas.axisRect()->center().y();
    const auto x_of = [&](double at) { return static_cast<int>(canvas.xAxis->coordToPixel(at)); };
    page.set_cursors(Cursors{-8.0, -2.0});
    const auto drag = [&](int from, int to) {
      QTest::mousePress(&canvas, Qt::LeftButton, {}, QPoint(from, middle));
      QTest::mouseMove(&canvas, QPoint(to, middle));
      QTest::mouseRelease(&canvas, Qt::LeftButton, {}, QPoint(to, middle));
    };
    drag(x_of(-2.0), x_of(-3.0));
    QVERIFY(std::abs((*page.cursors())[1] + 3.0) < 0.05);
    QVERIFY(!looking.window.frozen());
    const double end = page.window_shown().end;
    drag(x_of(-6.0), x_of(-4.0));  // to the past
    QVERIFY(std::abs(page.window_shown().end - end + 2.0) < 0.05);
    QVERIFY(looking.window.frozen());
    QTest::keyClick(&canvas, Qt::Key_Plus);
    QCOMPARE(looking.find<QDoubleSpinBox>("span").value(), 8.0);
  }

  void a_trigger_shows_the_time_about_it() {
    Looking looking;
    looking.feed(1000);
    PlotsPage& page = *looking.page;
    const TriggerSettings settings{.signal = "wall.force.z",
                                   .mode = TriggerSettings::Mode::single,
                                   .level = 5.0,
                                   .before = 0.25,
                                   .after = 0.75};
    page.show_layout({.span = 5.0, .trigger = settings, .plots = {{.names = {"wall.force.z"}}}});
    QVERIFY(looking.find<QPushButton>("trigger_arm").isVisible());
    looking.feed(4500);
    QVERIFY(!page.trigger().shot());
    QCOMPARE(page.window_shown().end, looking.rig.store.now());
    looking.feed(9000);
    QVERIFY(page.trigger().shot());
    QCOMPARE(page.window_shown().begin, 3.75);
    QCOMPARE(page.window_shown().end, 4.75);
    QVERIFY(looking.pane(1).heading().contains("TRIGGERED at 4.0000 s"));
    QCOMPARE(looking.pane(1).canvas().xAxis->range().lower, -0.25);
    QVERIFY(trocar::test::colours_in(trocar::test::picture_of(page, "plots_triggered")) > 10);
    // Moving the picture leaves the shot; Arm goes back to the run.
    QTest::keyClick(&looking.pane(1).canvas(), Qt::Key_Left);
    QVERIFY(!page.trigger().shot());
    QVERIFY(looking.window.frozen());
    QTest::mouseClick(&looking.find<QPushButton>("trigger_arm"), Qt::LeftButton);
    QVERIFY(!looking.window.frozen());
    QCOMPARE(page.trigger().state(), Trigger::State::armed);
  }

  void the_level_is_edited_in_the_unit_that_is_shown() {
    Looking looking;
    looking.feed(10);
    looking.find<QCheckBox>("trigger").setChecked(true);
    QCOMPARE(looking.page->trigger().state(), Trigger::State::off);  // of what?
    looking.drop(looking.pane(1), "wall.force.z");
    QCOMPARE(looking.page->trigger().state(), Trigger::State::armed);
    looking.find<QDoubleSpinBox>("trigger_level").setValue(2.5);
    QCOMPARE(looking.page->trigger().settings().level, 2.5);
    QCOMPARE(looking.page->trigger().settings().signal, std::string("wall.force.z"));
    QCOMPARE(looking.find<QDoubleSpinBox>("trigger_level").suffix(), QString(" N"));
    looking.find<QCheckBox>("trigger").setChecked(false);
    QCOMPARE(looking.page->trigger().state(), Trigger::State::off);
  }

  void events_are_marked_where_they_were() {
    Looking looking;
    looking.feed(5000);
    looking.drop(looking.pane(1), "wall.force.z");
    const auto shown = [&] {
      looking.window.refresh();
      QStringList texts;
      QCustomPlot& canvas = looking.pane(1).canvas();
      for (int i = 0; i < canvas.itemCount(); ++i)
        if (const auto* text = qobject_cast<QCPItemText*>(canvas.item(i)))
          if (text->visible())
            texts << QString("%1 at %2").arg(text->text()).arg(text->position->coords().x());
      return texts;
    };
    QCOMPARE(shown(), QStringList());
    looking.rig.store.add_event(event_at(2.999, "annotated", "", "cut"));
    looking.rig.store.add_event(event_at(3.999, "fault", "wall", ""));
    looking.rig.store.add_event(event_at(4.0, "edit", "", ""));
    QCOMPARE(shown(), (QStringList{"fault wall at -1", "cut at -2"}));
    looking.find<QCheckBox>("events").setChecked(false);
    QCOMPARE(shown(), QStringList());
    looking.find<QCheckBox>("events").setChecked(true);
    looking.find<QCheckBox>("cursors").setChecked(true);
    QCOMPARE(shown().size(), qsizetype{4});
  }

  void a_layout_goes_through_a_file_by_the_menu() {
    Looking looking;
    looking.feed(3000);
    const QTemporaryDir folder;
    const QString path = folder.filePath("page.json");
    const PlotLayout layout{.span = 3.0,
                            .cursors = Cursors{-2.0, -1.0},
                            .plots = {{.title = "Force", .names = {"wall.force.z"}},
                                      {.title = "Tip", .names = {"tip.x"}}}};
    looking.page->show_layout(layout);
    looking.window.refresh();
    const PlotLayout shown = looking.page->layout_shown();
    QCOMPARE(shown.plots.size(), std::size_t{2});
    QCOMPARE(shown.cursors, layout.cursors);
    write_layout_file(path, layout);
    looking.page->show_layout({});
    QCOMPARE(looking.page->board().count(), 0);
    auto* menu = looking.page->findChild<QToolButton*>("layout_menu")->menu();
    menu->actions()[1]->trigger();
    auto* dialog = looking.page->findChild<QFileDialog*>("file_dialog");
    QVERIFY(dialog != nullptr);
    Q_EMIT dialog->fileSelected(path);
    dialog->close();
    QCOMPARE(looking.page->board().count(), 2);
    QVERIFY(looking.find<QLabel>("plots_notice").text().contains("loaded: page.json"));
    // A file that is none is told, and what is there stays.
    QFile(path).resize(5);
    Q_EMIT dialog->fileSelected(path);
    QVERIFY(looking.find<QLabel>("plots_notice").text().contains("no JSON"));
    QCOMPARE(looking.page->board().count(), 2);
  }

  void what_is_visible_goes_into_a_table() {
    Looking looking;
    looking.feed(20'000);
    looking.drop(looking.pane(1), "wall.force.z\ntip.x");
    looking.find<QDoubleSpinBox>("span").setValue(0.5);
    QTest::keyClick(&looking.pane(1).canvas(), Qt::Key_Left);
    const TimeWindow window = looking.page->window_shown();
    const QTemporaryDir folder;
    const QString path = folder.filePath("visible.csv");
    looking.page->export_table(path);
    QFile file(path);
    QVERIFY(file.open(QFile::ReadOnly));
    const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    QCOMPARE(lines[0], QByteArray("time [s],wall.force.z [N],tip.x [N]"));
    QVERIFY(std::abs(lines.size() - 1 - 501) <= 1);
    QVERIFY(lines[1].split(',')[0].toDouble() >= window.begin);
    QVERIFY(lines.last().split(',')[0].toDouble() <= window.end);
  }

  void pictures_are_written_as_what_their_names_say() {
    Looking looking;
    looking.feed(5000);
    looking.drop(looking.pane(1), "wall.force.z");
    looking.window.set_theme(Theme::dark_one());
    const QTemporaryDir folder;
    const auto written = [&](const QString& name) {
      looking.page->export_picture(folder.filePath(name));
      QFile file(folder.filePath(name));
      return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
    };
    QVERIFY(written("a.pdf").startsWith("%PDF"));
    const QByteArray svg = written("a.svg");
    QVERIFY(svg.contains("<svg") && svg.contains("wall.force.z") && svg.contains("<polyline"));
    QImage png;
    QVERIFY(png.loadFromData(written("a.png"), "PNG"));
    QVERIFY(png.width() > 2000);
    QCOMPARE(png.pixelColor(2, png.height() - 2), QColor(Qt::white));
    QVERIFY(trocar::test::colours_in(png) > 20);
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                             looking.page->export_picture(folder.filePath("a.bmp")));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, looking.page->export_picture("/nowhere/a.png"));
    // The window keeps its own colours.
    QCOMPARE(looking.pane(1).canvas().xAxis->labelColor(), Theme::dark_one().text);
  }

  void another_run_is_shown_in_the_same_plots() {
    Looking looking;
    looking.feed(20'000);
    looking.drop(looking.pane(1), "wall.force.z");
    QTest::keyClick(&looking.pane(1).canvas(), Qt::Key_Left);
    QVERIFY(looking.window.frozen());
    looking.rig.begin();
    looking.fed = 0;
    QVERIFY(!looking.window.frozen());
    looking.feed(100);
    QCOMPARE(looking.curves(1), std::vector<std::string>{"wall.force.z"});
    QCOMPARE(looking.page->window_shown().end, looking.rig.store.now());
  }
};

QTEST_MAIN(TestPlotsPage)
#include "tst_plots_page.moc"
