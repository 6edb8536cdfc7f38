// SPDX-License-Identifier: Apache-2.0
// Plots: nothing that happened is left out, and axes keep still.
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "gui/plots/time_plot.hpp"
#include "gui/plots/xy_plot.hpp"
#include "tests/gui/track_rig.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::TrackRig;

namespace {

double wave(std::size_t i, std::int64_t tick) {
  return std::sin(0.003 * static_cast<double>(tick) + static_cast<double>(i));
}

/// Whether a column of pixels has the colour somewhere.
bool has_colour(const QImage& image, const QColor& colour, int left, int right, int top,
                int bottom) {
  for (int x = left; x < right; ++x)
    for (int y = top; y < bottom; ++y)
      if (image.pixelColor(x, y) == colour) return true;
  return false;
}

}  // namespace

class TestPlots : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bins_hold_the_extremes_of_their_time_data() {
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("bins");
    QTest::newRow("many rows a bin") << 10'000.0 << 300;
    QTest::newRow("a row a bin") << 1000.0 << 10'000;
    QTest::newRow("fewer rows than bins") << 100.0 << 5000;
  }
  void bins_hold_the_extremes_of_their_time() {
    QFETCH(double, rate);
    QFETCH(int, bins);
    TrackRig rig({"force"});
    BinnedCurve curve;
    const auto ticks = static_cast<std::int64_t>(rate);
    for (std::int64_t begin = 0; begin < 15 * ticks; begin += ticks / 7 + 3) {
      rig.feed(begin, begin + ticks / 7 + 3, rate, wave);
      const SignalRef signal = *rig.store.find("force");
      const double now = rig.store.now();
      curve.show(signal, now, 10.0, bins);
      Extremes all;
      for (const BinnedCurve::Bin& bin : curve.bins()) all.add(bin.extremes);
      const std::uint64_t from =
          rig.track->at(static_cast<double>(curve.bins().front().number) * curve.width());
      const Extremes expected = signal.column().extremes(from, rig.track->end());
      QCOMPARE(all.min, expected.min);
      QCOMPARE(all.max, expected.max);
      QVERIFY(!curve.bins().front().after_gap);
    }
  }

  void a_spike_of_one_tick_is_always_seen() {
    TrackRig rig({"force"});
    TimePlot plot(rig.store);
    plot.resize(700, 200);
    plot.add_curve("force");
    plot.set_span(10.0);
    plot.show();  // that it has its size
    const QColor colour = Theme::light().curve(0).color();
    constexpr std::int64_t spike = 60'000;
    std::int64_t fed = 0;
    int looks = 0;
    // Frames at odd times, so that the spike stands anywhere within a pixel.
    for (std::int64_t frame = 60'337; frame < 155'000; frame += 1'777) {
      rig.feed(fed, frame, 10'000,
               [](std::size_t, std::int64_t tick) { return tick == spike ? 7.0 : 0.0; });
      fed = frame;
      plot.refresh();
      const QImage image = plot.canvas().toPixmap().toImage();
      const QCPAxis& x = *plot.canvas().xAxis;
      const auto at = static_cast<int>(x.coordToPixel(6.0 - rig.store.now()));
      const auto top = static_cast<int>(plot.canvas().yAxis->coordToPixel(7.0));
      QVERIFY2(
          has_colour(image, colour, std::max(0, at - 2), at + 3, std::max(0, top - 1), top + 4),
          qPrintable(QString("frame %1: nothing at %2, %3").arg(frame).arg(at).arg(top)));
      ++looks;
    }
    QVERIFY(looks > 50);
  }

  void missing_ticks_are_a_gap() {
    TrackRig rig({"force"});
    rig.feed(0, 1000, 1000, wave);
    rig.feed(3000, 4000, 1000, wave);
    QCOMPARE(rig.track->missing(), std::uint64_t{2000});
    BinnedCurve curve;
    curve.show(*rig.store.find("force"), rig.store.now(), 10.0, 500);
    int gaps = 0;
    for (const BinnedCurve::Bin& bin : curve.bins()) gaps += bin.after_gap ? 1 : 0;
    QCOMPARE(gaps, 1);
  }

  void an_axis_grows_at_once_and_shrinks_late() {
    Autoscale scale;
    const auto data = [](double low, double high) {
      Extremes extremes;
      extremes.add(low);
      extremes.add(high);
      return extremes;
    };
    QVERIFY(scale.follow(data(-1, 1), 0.0));
    QVERIFY(scale.lower() <= -1 && scale.upper() >= 1);
    QVERIFY(!scale.follow(data(-0.9, 0.95), 0.1));
    QVERIFY(scale.follow(data(-1, 30), 0.2));
    QVERIFY(scale.upper() >= 30);
    for (double now = 0.3; now < 3.2; now += 0.1) QVERIFY(!scale.follow(data(-1, 1), now));
    QVERIFY(scale.follow(data(-1, 1), 3.5));
    QVERIFY(scale.upper() < 5);
    scale.include(20);
    QVERIFY(scale.follow(data(-1, 1), 4.0));
    QVERIFY(scale.upper() >= 20);
    QVERIFY(!Autoscale().follow({}, 0.0));
  }

  void frozen_is_the_picture_and_not_the_run() {
    TrackRig rig({"force"});
    TimePlot plot(rig.store);
    plot.add_curve("force");
    rig.feed(0, 5000, 1000, wave);
    plot.refresh();
    plot.freeze(rig.store.now());
    const double end = plot.window().end;
    rig.feed(5000, 9200, 1000, wave);
    plot.refresh();
    QCOMPARE(plot.window().end, end);
    QVERIFY2(plot.heading().contains("behind 4.2 s"), qPrintable(plot.heading()));
    plot.freeze({});
    QCOMPARE(plot.window().end, rig.store.now());
  }

  void the_cap_is_always_in_sight() {
    TrackRig rig({"force"});
    TimePlot plot(rig.store);
    plot.add_curve("force");
    plot.set_cap(20.0);
    rig.feed(0, 100, 1000, wave);
    plot.refresh();
    QVERIFY(plot.value_range().lower <= -20.0 && plot.value_range().upper >= 20.0);
  }

  void a_signal_that_is_not_there_yet_comes_with_the_next_run() {
    TrackRig rig({"force"});
    TimePlot plot(rig.store);
    plot.add_curve("nothing");
    plot.add_curve("force");
    plot.refresh();
    rig.feed(0, 100, 1000, wave);
    plot.refresh();
    QCOMPARE(plot.canvas().graph(1)->dataCount(), 0);
    QVERIFY(plot.canvas().graph(2)->dataCount() > 0);
    rig.begin();
    plot.refresh();
    QCOMPARE(plot.canvas().graph(2)->dataCount(), 0);
    plot.remove_curve("nothing");
    QCOMPARE(plot.curve_names(), std::vector<std::string>{"force"});
  }

  void one_over_the_other() {
    TrackRig rig({"depth", "force"});
    XyPlot plot(rig.store);
    plot.set_signals("depth", "force");
    rig.feed(0, 3000, 1000, [](std::size_t i, std::int64_t tick) {
      return (i == 0 ? 1e-3 : -2.0) * static_cast<double>(tick % 1000);
    });
    plot.refresh();
    const auto* curve = qobject_cast<QCPCurve*>(plot.canvas().plottable(0));
    QVERIFY(curve != nullptr && curve->dataCount() > 1000);
    for (const QCPCurveData& point : *curve->data())
      QVERIFY(std::abs(point.value + 2000.0 * point.key) < 1e-6);
  }
};

QTEST_MAIN(TestPlots)
#include "tst_plots.moc"
