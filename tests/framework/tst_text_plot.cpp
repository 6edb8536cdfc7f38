// SPDX-License-Identifier: Apache-2.0
#include "framework/text_plot.hpp"

#include <QTest>
#include <cmath>
#include <vector>

using namespace trocar;

namespace {

struct Rows {
  std::vector<double> time, values;
};

Rows rows(std::size_t count, double (*value)(double)) {
  Rows result;
  for (std::size_t i = 0; i < count; ++i) {
    result.time.push_back(0.001 * static_cast<double>(i));
    result.values.push_back(value(result.time.back()));
  }
  return result;
}

QStringList lines(const std::string& plot) {
  return QString::fromStdString(plot).split('\n');
}

}  // namespace

class TestTextPlot : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_ramp_goes_from_corner_to_corner() {
    const Rows ramp = rows(100, [](double t) { return t; });
    const QStringList plot = lines(
        text_plot(ramp.time, ramp.values, {.width = 12, .height = 2, .unit = parse_unit("mm")}));
    QCOMPARE(plot[0], "99 mm │      ⣀⣠⠤⠖⠚⠉");
    QCOMPARE(plot[1], " 0 mm │⣀⡤⠴⠒⠋⠉⠁");
    QCOMPARE(plot[2], "      └────────────");
    QCOMPARE(plot[3], "       0 s  0.099 s");
  }

  void a_spike_of_one_row_stays_visible() {
    Rows flat = rows(10'000, [](double) { return 0.0; });
    flat.values[5'000] = 1.0;
    const QStringList plot = lines(text_plot(flat.time, flat.values, {.width = 20, .height = 4}));
    QVERIFY2(plot[0].trimmed() != "1 │", qPrintable(plot.join('\n')));
  }

  void the_level_is_in_view_and_has_its_label() {
    const Rows low = rows(50, [](double) { return 1.0; });
    const QStringList plot = lines(text_plot(
        low.time, low.values, {.width = 10, .height = 4, .unit = parse_unit("N"), .level = 5.0}));
    QVERIFY2(plot[0].startsWith("5 N │╌╌╌╌╌╌╌╌╌╌"), qPrintable(plot.join('\n')));
    QVERIFY2(plot[3].startsWith("1 N │⣀⣀"), qPrintable(plot.join('\n')));
  }

  void the_mark_stands_below_its_time() {
    const Rows ramp = rows(101, [](double t) { return t; });
    const QStringList plot =
        lines(text_plot(ramp.time, ramp.values, {.width = 41, .height = 2, .marked = 0.05}));
    const qsizetype axis = plot[2].indexOf("└") + 1;
    QCOMPARE(plot[2].indexOf("▲") - axis, 20);
    QVERIFY2(plot[3].contains("0.05 s"), qPrintable(plot.join('\n')));
    QVERIFY2(plot[3].endsWith("0.1 s"), qPrintable(plot.join('\n')));
  }

  void a_narrow_plot_drops_labels_that_would_touch() {
    const Rows ramp = rows(101, [](double t) { return t; });
    const QStringList plot =
        lines(text_plot(ramp.time, ramp.values, {.width = 12, .height = 2, .marked = 0.001}));
    QCOMPARE(plot[3].trimmed(), "0.001 s");
  }

  void numbers_that_are_not_finite_leave_a_gap() {
    Rows ramp = rows(100, [](double) { return 1.0; });
    for (std::size_t i = 25; i < 75; ++i) ramp.values[i] = std::nan("");
    const QStringList plot = lines(text_plot(ramp.time, ramp.values, {.width = 20, .height = 1}));
    QVERIFY2(plot[0].contains("       "), qPrintable(plot[0]));
  }

  void every_input_ends_in_a_text() {
    QVERIFY(text_plot({}, {}).empty());
    QVERIFY(text_plot(std::vector<double>{0.0}, std::vector<double>{}).empty());
    QVERIFY(
        !text_plot(std::vector<double>{0.0}, std::vector<double>{0.0}, {.marked = 0.0}).empty());
    QVERIFY(!text_plot(std::vector<double>{0.0}, std::vector<double>{std::nan("")}).empty());
    QVERIFY(!text_plot(std::vector<double>{0, 1}, std::vector<double>{1e300, -1e300}).empty());
  }
};

QTEST_GUILESS_MAIN(TestTextPlot)
#include "tst_text_plot.moc"
