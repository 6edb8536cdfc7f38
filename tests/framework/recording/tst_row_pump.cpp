// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/row_pump.hpp"

#include <cstring>
#include <thread>

#include <QTest>
#include <atomic>

#include "tests/support/run_rig.hpp"

using namespace trocar;
using test::RunRig;
using test::TestSink;

namespace {

/// A graph's layout and a ring that rows are written into by hand.
struct PumpRig {
  explicit PumpRig(std::size_t rows_in_ring)
      : ring(rings.emplace_back(rows_in_ring * (layout.size() + BroadcastRing::head_size + 8),
                                std::max(layout.size(), sizeof(Event)))) {}

  void write_row(std::int64_t tick, bool wait = false) {
    const std::span<std::byte> row = ring.begin(layout.size());
    layout.capture({.tick = tick, .time = tick * 1'000'000}, times, wired->main().memory(), row);
    commit(RecordKind::row, wait);
  }
  void write_event(std::int64_t tick) {
    const Event event{.kind = Event::Kind::edit, .tick = tick, .time_ns = tick * 1'000'000};
    std::memcpy(ring.begin(sizeof event).data(), &event, sizeof event);
    commit(RecordKind::event, false);
  }
  void commit(RecordKind kind, bool wait) {
    const auto tag = static_cast<std::uint32_t>(kind);
    wait ? ring.commit_when_read(tag) : ring.commit(tag);
  }

  RunRig run;
  std::unique_ptr<WiredGraph> wired = wire(run.graph, {});
  std::vector<RowLayout> layouts = layouts_of(*wired);
  const RowLayout& layout = layouts.front();
  std::vector<std::int64_t> times = std::vector<std::int64_t>(wired->main().schedule().size());
  std::deque<BroadcastRing> rings;
  BroadcastRing& ring;
};

/// Takes rows once the test lets it.
class HeldSink final : public RowSink {
 public:
  explicit HeldSink(std::string_view name = "recorder", bool open = false)
      : opened(open), name_(name) {}
  std::string_view reader_name() const override { return name_; }
  bool needs_every_row() const override { return name_ != "progress"; }
  void row(std::size_t, std::span<const std::byte> row) override {
    reached = true;
    while (!opened.load()) std::this_thread::yield();
    const std::int64_t tick = header_of(row).tick;
    in_order = in_order && tick > last;
    last = tick;
    ++rows;
  }
  void event(std::size_t, const Event&) override { ++events; }
  void missed(std::uint64_t records) override {
    told += records;
    told_behind = last;
  }

  std::atomic<bool> opened;
  std::atomic<bool> reached{false};
  std::atomic<int> rows{0};
  int events = 0;
  bool in_order = true;
  std::int64_t last = -1;
  std::uint64_t told = 0;
  std::int64_t told_behind = -1;

 private:
  std::string_view name_;
};

void wait_for(const auto& condition) {
  while (!condition()) std::this_thread::yield();
}

}  // namespace

class TestRowPump : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_sink_that_falls_behind_is_told_and_delays_nobody() {
    PumpRig rig(16);
    HeldSink slow, fast("live view", true);
    RowPump pump(rig.rings, {&slow, &fast}, rig.layouts, *rig.wired, false);
    rig.write_row(0);
    wait_for([&] { return slow.reached.load(); });
    for (int tick = 1; tick < 200; ++tick) {
      rig.write_row(tick);
      wait_for([&] { return fast.rows.load() == tick + 1; });
    }
    slow.opened = true;
    const PumpResult result = pump.finish();
    QCOMPARE(fast.rows.load(), 200);
    QCOMPARE(fast.told, std::uint64_t{0});
    QVERIFY(slow.told > 150);
    QVERIFY(slow.in_order);
    QCOMPARE(slow.told + static_cast<std::uint64_t>(slow.rows), std::uint64_t{200});
    QCOMPARE(slow.last, std::int64_t{199});
    QCOMPARE(result.losses.size(), std::size_t{1});
    const ReaderLoss& loss = result.losses[0];
    QCOMPARE(loss.reader, std::string("recorder"));
    QCOMPARE(loss.records, slow.told);
    QCOMPARE(loss.gaps, std::uint64_t{1});
    QVERIFY(loss.matters);
    QCOMPARE(loss.time, 1e-3 * static_cast<double>(1 + slow.told));
    QVERIFY(result.failures.empty());
  }

  void events_count_where_rows_are_missed() {
    PumpRig rig(8);
    HeldSink slow("progress");
    RowPump pump(rig.rings, {&slow}, rig.layouts, *rig.wired, false);
    rig.write_row(0);
    wait_for([&] { return slow.reached.load(); });
    for (int tick = 1; tick < 100; ++tick) {
      rig.write_event(tick);
      rig.write_row(tick);
    }
    slow.opened = true;
    const PumpResult result = pump.finish();
    QCOMPARE(slow.told + static_cast<std::uint64_t>(slow.rows + slow.events), std::uint64_t{199});
    QCOMPARE(slow.told_behind, std::int64_t{0});
    QVERIFY(!result.losses.at(0).matters);
  }

  void in_virtual_time_the_writer_waits_for_the_slowest() {
    PumpRig rig(8);
    HeldSink slow, fast("live view", true);
    RowPump pump(rig.rings, {&slow, &fast}, rig.layouts, *rig.wired, true);
    std::thread writer([&] {
      for (int tick = 0; tick < 500; ++tick) rig.write_row(tick, true);
    });
    wait_for([&] { return slow.reached.load(); });
    slow.opened = true;
    writer.join();
    const PumpResult result = pump.finish();
    QCOMPARE(slow.rows.load(), 500);
    QCOMPARE(fast.rows.load(), 500);
    QVERIFY(result.losses.empty());
  }

  void a_sink_that_threw_holds_nobody_up() {
    PumpRig rig(8);
    TestSink broken(TestSink::Throws::in_row);
    HeldSink sound("recorder", true);
    RowPump pump(rig.rings, {&broken, &sound}, rig.layouts, *rig.wired, true);
    for (int tick = 0; tick < 500; ++tick) rig.write_row(tick, true);
    const PumpResult result = pump.finish();
    QCOMPARE(result.failures, std::vector<std::string>{"sink is full"});
    QCOMPARE(broken.rows, 1);
    QCOMPARE(broken.ends, 0);
    QCOMPARE(sound.rows.load(), 500);
  }

  void a_loss_is_told_in_words_data() {
    QTest::addColumn<int>("records");
    QTest::addColumn<int>("gaps");
    QTest::addColumn<QString>("text");
    QTest::newRow("one") << 1 << 1 << "recorder missed 1 row before 3.214 s";
    QTest::newRow("many at once") << 120 << 1 << "recorder missed 120 rows before 3.214 s";
    QTest::newRow("in several gaps")
        << 120 << 2 << "recorder missed 120 rows in 2 gaps, the first before 3.214 s";
  }
  void a_loss_is_told_in_words() {
    QFETCH(int, records);
    QFETCH(int, gaps);
    QFETCH(QString, text);
    const ReaderLoss loss{.reader = "recorder",
                          .records = static_cast<std::uint64_t>(records),
                          .gaps = static_cast<std::uint64_t>(gaps),
                          .time = 3.214};
    QCOMPARE(QString::fromStdString(loss.text()), text);
  }

  void the_ring_holds_five_seconds_of_rows_within_bounds_data() {
    QTest::addColumn<double>("period");
    QTest::addColumn<bool>("lossless");
    QTest::addColumn<double>("rows");  // at least
    QTest::addColumn<double>("most");  // [bytes]
    QTest::newRow("a rate of 1 kHz") << 1e-3 << false << 5e3 << 8.0 * (1 << 20);
    QTest::newRow("a high rate") << 1e-4 << false << 5e4 << 64.0 * (1 << 20);
    QTest::newRow("a rate beyond the bound") << 1e-7 << false << 1e5 << 256.0 * (1 << 20);
    QTest::newRow("virtual time") << 1e-4 << true << 64.0 << 8.0 * (1 << 20);
  }
  void the_ring_holds_five_seconds_of_rows_within_bounds() {
    QFETCH(double, period);
    QFETCH(bool, lossless);
    QFETCH(double, rows);
    QFETCH(double, most);
    const PumpRig rig(8);
    const auto capacity = static_cast<double>(ring_capacity(rig.layout, period, lossless));
    QVERIFY(capacity >= rows * static_cast<double>(rig.layout.size()));
    QVERIFY(capacity <= most);
  }
};

QTEST_APPLESS_MAIN(TestRowPump)
#include "tst_row_pump.moc"
