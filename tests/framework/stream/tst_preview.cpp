// SPDX-License-Identifier: Apache-2.0
// Rows decimated for the eye: nothing that lasted one tick gets lost.
#include "framework/stream/preview.hpp"

#include <QTest>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/support/run_rig.hpp"

using namespace trocar;
using namespace trocar::stream;
using test::RunRig;

namespace {

/// Keeps the previews of a run's first thread.
class PreviewSink final : public RowSink {
 public:
  explicit PreviewSink(std::int64_t window_ns) : window_ns_(window_ns) {}
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph&) override {
    preview_.emplace(layouts.front(), window_ns_);
    decoder.emplace("trocar/Preview", preview_->schema());
  }
  void row(std::size_t, std::span<const std::byte> row) override {
    if (const auto full = preview_->add(row)) keep(*full);
  }
  void end() override {
    if (const auto rest = preview_->finish()) keep(*rest);
  }
  double value(std::size_t message, const char* path) const {
    return as_double(decoder->value(messages.at(message), *decoder->find(path)));
  }

  std::vector<std::vector<std::byte>> messages;
  std::vector<std::int64_t> times;
  std::optional<Ros2Decoder> decoder;

 private:
  void keep(std::span<const std::byte> message) {
    messages.emplace_back(message.begin(), message.end());
    times.push_back(preview_->time_ns());
  }
  std::int64_t window_ns_;
  std::optional<Preview> preview_;
};

}  // namespace

class TestPreview : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_has_least_greatest_and_last_of_each_window() {
    RunRig rig;
    PreviewSink sink(10'000'000);
    rig.run(0.035, {&sink});
    QCOMPARE(sink.messages.size(), std::size_t{4});
    QCOMPARE(sink.times,
             (std::vector<std::int64_t>{9'000'000, 19'000'000, 29'000'000, 34'000'000}));
    QCOMPARE(sink.value(1, "meter.value.min"), 12.0);
    QCOMPARE(sink.value(1, "meter.value.max"), 21.0);
    QCOMPARE(sink.value(1, "meter.value.last"), 21.0);
    QCOMPARE(sink.value(1, "meter.force.z.min"), -19.0);
    QCOMPARE(sink.value(1, "meter.force.z.max"), -10.0);
    QCOMPARE(sink.value(1, "meter.count.last"), -19.0);
    QCOMPARE(sink.value(1, "meter.odd.min"), 0.0);
    QCOMPARE(sink.value(1, "meter.odd.max"), 1.0);
    QCOMPARE(sink.value(3, "tick.min"), 30.0);
    QCOMPARE(sink.value(3, "tick.max"), 34.0);
  }

  void every_number_of_the_row_is_there() {
    RunRig rig;
    PreviewSink sink(10'000'000);
    rig.run(0.01, {&sink});
    const std::unique_ptr<WiredGraph> wired = wire(rig.graph, {});
    const RowLayout layout(wired->main());
    const Ros2Decoder row("trocar/Row", ros2_schema_text(layout.messages()));
    QCOMPARE(sink.decoder->leaves().size(), 3 * row.leaves().size());
    for (std::size_t i = 0; i < row.leaves().size(); ++i)
      QCOMPARE(sink.decoder->leaves()[3 * i].path, row.leaves()[i].path + ".min");
  }

  /// A spike of one tick in one of 10,000.
  void a_spike_of_one_tick_is_seen() {
    RunRig rig;
    const std::unique_ptr<WiredGraph> wired = wire(rig.graph, {});
    const RowLayout layout(wired->main());
    Preview preview(layout, 1'000'000'000);
    const Ros2Decoder decoder("trocar/Preview", preview.schema());
    std::vector<RowSignal> signals = layout.signals();
    const auto value = std::find_if(signals.begin(), signals.end(),
                                    [](const RowSignal& one) { return one.name == "meter.value"; });
    std::vector<std::byte> row(layout.size());
    for (std::int64_t i = 0; i < 10'000; ++i) {
      const RowHeader header{.tick = i, .time = i * 100'000};
      const double number = i == 5'000 ? 17.0 : 1.0;
      std::memcpy(row.data(), &header, sizeof header);
      std::memcpy(row.data() + value->row_offset, &number, sizeof number);
      QVERIFY(!preview.add(row));
    }
    const auto message = preview.finish();
    QVERIFY(message.has_value());
    QCOMPARE(as_double(decoder.value(*message, *decoder.find("meter.value.max"))), 17.0);
    QCOMPARE(as_double(decoder.value(*message, *decoder.find("meter.value.last"))), 1.0);
    QVERIFY(!preview.finish());
  }

  void numbers_that_are_not_finite_do_not_hide_the_others() {
    RunRig rig;
    PreviewSink sink(10'000'000);
    rig.run(0.02, {&sink}, {});
    rig.graph.set({rig.meter, "broken_from"}, Literal{15.0}, {"test", 1});
    PreviewSink broken(10'000'000);
    rig.run(0.02, {&broken}, {});
    QCOMPARE(broken.value(1, "meter.value.min"), 12.0);
    QCOMPARE(broken.value(1, "meter.value.max"), 16.0);
    QVERIFY(std::isnan(broken.value(1, "meter.value.last")));
  }
};

QTEST_GUILESS_MAIN(TestPreview)
#include "tst_preview.moc"
