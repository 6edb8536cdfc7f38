// SPDX-License-Identifier: Apache-2.0
// A window that is left alone for an hour takes no more memory than after its first minutes.
#include <unistd.h>

#include <QFile>
#include <QTest>
#include <cmath>

#include "framework/stream/batch.hpp"
#include "gui/data/live_feed.hpp"
#include "gui/pages/plots_page.hpp"
#include "gui/window/main_window.hpp"
#include "tests/gui/track_rig.hpp"

using namespace trocar;
using namespace trocar::gui;

namespace {

constexpr int columns = 100;
constexpr std::int64_t rows_a_batch = 1000;                      // a second of 1 kHz
constexpr std::int64_t first_minutes = 6 * 60, whole = 60 * 60;  // [s]

/// [B] that the process has in memory.
double resident() {
  QFile file("/proc/self/statm");
  if (!file.open(QFile::ReadOnly)) return std::nan("");
  return file.readAll().split(' ').value(1).toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// A second of rows as a stream sends them: a head, their number, the rows.
class Batches {
 public:
  explicit Batches(const test::TrackRig& rig) : message_(head), row_size_(rig.track->row_size()) {
    message_[1] = std::byte{1};
    const auto count = static_cast<std::uint32_t>(rows_a_batch);
    std::memcpy(message_.data() + 4, &count, sizeof count);
    std::vector<double> values(columns);
    for (std::int64_t row = 0; row < rows_a_batch; ++row) {
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::sin(0.01 * static_cast<double>(row) + static_cast<double>(i));
      const auto bytes = rig.row({}, values);
      message_.insert(message_.end(), bytes.begin(), bytes.end());
    }
  }

  /// The same numbers each second, at times of its own.
  const std::vector<std::byte>& of(std::int64_t second) {
    for (std::int64_t row = 0; row < rows_a_batch; ++row) {
      const std::int64_t tick = second * rows_a_batch + row;
      const std::int64_t tick_and_time[] = {tick, tick * 1'000'000};
      std::memcpy(message_.data() + head + static_cast<std::size_t>(row) * row_size_, tick_and_time,
                  sizeof tick_and_time);
    }
    return message_;
  }

 private:
  static constexpr std::size_t head = 12;
  std::vector<std::byte> message_;
  std::size_t row_size_;
};

}  // namespace

class TestMemory : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_hour_of_a_hundred_signals_takes_no_more_than_the_first_minutes() {
    std::vector<std::string> names;
    for (int i = 0; i < columns; ++i) names.push_back("signal" + std::to_string(i));
    const LiveFeed::Limits limits;
    test::TrackRig rig(names, limits.seconds, limits.memory);
    Operator operators{Sources{rig.store}};
    MainWindow window(operators, "an hour");
    auto* page = new PlotsPage(operators);
    window.add_page(page);
    const TriggerSettings trigger{
        .signal = "signal0", .mode = TriggerSettings::Mode::automatic, .level = 0.5};
    page->show_layout(
        {.cursors = Cursors{-4.0, -1.0},
         .trigger = trigger,
         .plots = {{.names = {names.begin(), names.begin() + 6}},
                   {.names = {names.begin() + 6, names.begin() + 12}},
                   {.kind = PlotDescription::Kind::xy, .names = {names[0], names[1]}}}});
    window.show();
    Batches batches(rig);
    double early = 0.0;
    std::uint64_t early_rows = 0;
    for (std::int64_t second = 0; second < whole; ++second) {
      for (const auto row : stream::Batch::rows(batches.of(second), rig.track->row_size()))
        rig.track->add(row);
      RunEvent event;
      event.tick = second * rows_a_batch;
      event.time = static_cast<double>(second);
      event.kind = "annotated";
      event.detail = "needle touched the wall";
      // So many that the list of events is full in the first minutes, too.
      const bool many = second < first_minutes || second % 10 == 0;
      for (int i = 0; many && i < 30; ++i) rig.store.add_event(event);
      if (second % 10 == 0) {
        window.refresh();
        QCoreApplication::processEvents();
      }
      if (second == first_minutes) {
        early = resident();
        early_rows = rig.track->end() - rig.track->first();
      }
    }
    QCOMPARE(rig.track->end(), std::uint64_t{whole * rows_a_batch});
    QCOMPARE(rig.track->missing(), std::uint64_t{0});
    const auto block = std::uint64_t{Column::block};
    const std::uint64_t rows = rig.track->end() - rig.track->first();
    QVERIFY(rows <= early_rows + block && early_rows <= rows + block);
    QVERIFY(rows > 120 * 1000);  // of what is promised to be kept
    QCOMPARE(rig.store.events().size(), DataStore::most_events);
    const double growth = resident() / early - 1.0;
    qInfo("%.1f MB after 6 min, %.1f MB after 60: %+.2f %%", 1e-6 * early, 1e-6 * resident(),
          100.0 * growth);
    QVERIFY(growth <= 0.01);
  }
};

QTEST_MAIN(TestMemory)
#include "tst_memory.moc"
