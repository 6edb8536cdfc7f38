// SPDX-License-Identifier: Apache-2.0
#include "framework/run_control.hpp"

#include <QTest>
#include <utility>

#include "framework/recording/row_snapshot.hpp"
#include "tests/support/run_rig.hpp"

using namespace trocar;
using test::RunRig;

namespace {

/// A wired graph that nobody runs, with what came out of its queue.
struct ControlRig {
  RunRig rig;
  WiringOptions options{};
  std::unique_ptr<WiredGraph> live = wire(rig.graph, options);
  std::deque<CommandQueue> queues = std::deque<CommandQueue>(1);
  Reloads reloads{*live};
  RunControl control{rig.graph, options, *live, queues, reloads};

  ParameterBase* gain() {
    for (ParameterBase* parameter : live->find("meter")->parameters())
      if (parameter->name() == "gain") return parameter;
    return nullptr;
  }
  QString refusal(const char* key, const char* value) {
    try {
      control.set(key, literal_from_text(value));
    } catch (const BrokenGraph& broken) {
      return QString::fromStdString(broken.findings.all().front().message);
    }
    return {};
  }
};

}  // namespace

class TestRunControl : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_value_goes_to_the_loop_and_not_into_the_parameter() {
    ControlRig rig;
    rig.control.set("meter.gain", literal_from_text("3 N"));
    const auto command = rig.queues[0].try_pop();
    QVERIFY(command.has_value());
    QVERIFY(command->kind == Command::Kind::set_parameter);
    QCOMPARE(command->parameter, rig.gain());
    QCOMPARE(command->target[0], 3.0);
    QCOMPARE(command->owner, "meter");
    QCOMPARE(rig.gain()->numbers()[0], 2.0);
    QVERIFY(!rig.queues[0].try_pop());
  }

  void it_knows_what_was_asked_last() {
    ControlRig rig;
    QCOMPARE(rig.control.text("meter.gain"), "2 N (at most 9 N)");
    rig.control.set("meter.gain", literal_from_text("3 N"));
    QCOMPARE(rig.control.text("meter.gain"), "3 N (at most 9 N)");
    QCOMPARE(rig.control.live_keys(), (std::vector<std::string>{"meter.gain"}));
  }

  void it_shows_parameters_with_unit_and_range() {
    ControlRig rig;
    rig.control.set("meter.gain", literal_from_text("3 N"));
    const std::vector<ParameterState> all = rig.control.parameters();
    const auto gain = std::find_if(
        all.begin(), all.end(), [](const ParameterState& one) { return one.key == "meter.gain"; });
    QVERIFY(gain != all.end());
    QCOMPARE(gain->text, "3 N");
    QCOMPARE(gain->numbers, std::vector{3.0});
    QCOMPARE(gain->unit.symbol, "N");
    QCOMPARE(gain->max, 9.0);
    QVERIFY(gain->min < -1e300);
    QVERIFY(gain->live);
  }

  void what_cannot_be_is_explained() {
    ControlRig rig;
    QVERIFY2(rig.refusal("meter.gane", "3 N").contains("did you mean \"meter.gain\"?"),
             qPrintable(rig.refusal("meter.gane", "3 N")));
    QVERIFY(rig.refusal("meter.gain", "30 N").contains("9 N"));
    QVERIFY(rig.refusal("meter.gain", "3 mm").contains("needs N"));
    QVERIFY(rig.refusal("meter.fixed", "3 N").contains("cannot be edited while it runs"));
    QVERIFY(!rig.queues[0].try_pop());
    QVERIFY_THROWS_EXCEPTION(BrokenGraph, rig.control.text("meter"));
  }

  void a_remark_stays_as_long_as_the_run() {
    ControlRig rig;
    rig.control.annotate("the gel is dry");
    rig.control.annotate("and dusty");
    const auto first = rig.queues[0].try_pop(), second = rig.queues[0].try_pop();
    QVERIFY(first && first->kind == Command::Kind::annotate);
    QCOMPARE(first->text, "the gel is dry");
    QCOMPARE(second->text, "and dusty");
  }

  void nothing_is_lost_when_the_queue_is_full() {
    ControlRig rig;
    constexpr int requests = 700;  // more than twice what the queue holds
    for (int i = 0; i < requests; ++i) rig.control.request(Command::Kind::acknowledge);
    rig.control.request(Command::Kind::end);
    int acknowledged = 0;
    bool ended = false;
    for (int round = 0; round < 4; ++round) {
      while (const auto command = rig.queues[0].try_pop()) {
        QVERIFY(!ended);
        ended = command->kind == Command::Kind::end;
        acknowledged += ended ? 0 : 1;
      }
      rig.control.flush();
    }
    QCOMPARE(acknowledged, requests);
    QVERIFY(ended);
    QVERIFY(!rig.control.flush());
  }

  void a_run_in_real_time_is_watched_and_moved() {
    RunRig rig;
    RowSnapshot rows;
    RunOptions options;
    options.sinks = {&rows};
    bool asked = false;
    double gain = 0.0;
    options.operator_input = [&](RunControl& control) {
      if (!std::exchange(asked, true)) control.set("meter.gain", literal_from_text("4 N"));
      const auto value = [&](const char* name) {
        for (const RowSignal& signal : rows.signals())
          if (signal.name == name)
            if (const auto now = rows.value(signal)) return now->number;
        return 0.0;
      };
      const double count = -value("meter.count");
      if (count > 0.0) gain = value("meter.force.y") / value("meter.force.x");
      if (gain == 4.0) control.request(Command::Kind::end);
      return false;
    };
    const RunResult result = trocar::run(rig.graph, options);
    QCOMPARE(gain, 4.0);
    QVERIFY(result.main().loop.ticks > 200);  // the ramp takes 0.2 s
  }
};

QTEST_GUILESS_MAIN(TestRunControl)
#include "tst_run_control.moc"
