// SPDX-License-Identifier: Apache-2.0
#include "cli/machine.hpp"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace trocar::cli;

namespace {

/// A machine made of files.
class Files {
 public:
  void put(const QString& path, const QByteArray& text) {
    QDir(folder_.path()).mkpath(QFileInfo(path).path().mid(1));
    QFile file(folder_.path() + path);
    QVERIFY(file.open(QFile::WriteOnly) && file.write(text) == text.size());
  }
  std::string root() const { return folder_.path().toStdString(); }
  QString value(const std::string& key) const {
    for (const MachineFact& fact : machine_facts(root()))
      if (fact.key == key) return QString::fromStdString(fact.value);
    return "no such fact";
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace

class TestMachine : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_the_system_says_is_told() {
    Files files;
    files.put("/proc/cpuinfo",
              "processor\t: 0\nmodel name\t: Abacus 9\nflags\t\t: fpu hypervisor sse\n\n"
              "processor\t: 1\nmodel name\t: Abacus 9\nflags\t\t: fpu hypervisor sse\n");
    files.put("/sys/class/dmi/id/product_name", "Virtual Tin\n");
    files.put("/sys/devices/system/clocksource/clocksource0/current_clocksource", "tsc\n");
    files.put("/sys/devices/system/cpu/isolated", "1\n");
    files.put("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "powersave\n");
    files.put("/sys/devices/system/cpu/cpu1/cpufreq/scaling_governor", "performance\n");
    files.put("/sys/kernel/realtime", "1\n");
    files.put("/proc/loadavg", "0.50 0.40 0.30 1/99 1234\n");
    files.put("/proc/sys/kernel/sched_rt_runtime_us", "950000\n");
    files.put("/proc/sys/kernel/sched_rt_period_us", "1000000\n");
    QCOMPARE(files.value("processor"), "2 × Abacus 9");
    QCOMPARE(files.value("virtual_machine"),
             "yes (Virtual Tin): its host takes processors away at will");
    QCOMPARE(files.value("clock_source"), "tsc");
    QCOMPARE(files.value("isolated"), "1");
    QCOMPARE(files.value("governor"), "performance, powersave");
    QCOMPARE(files.value("preemption"), "PREEMPT_RT");
    QCOMPARE(files.value("load"), "0.50 0.40 0.30 1/99 1234");
    QCOMPARE(files.value("real_time_limit"), "950000 of 1000000 µs (sched_rt_runtime_us)");
  }

  void what_it_does_not_say_is_told_as_well() {
    const Files nothing;
    QCOMPARE(nothing.value("clock_source"), "not readable");
    QCOMPARE(nothing.value("processor"), "0 × not readable");
    QCOMPARE(nothing.value("virtual_machine"), "not as far as the processor says");
    QCOMPARE(nothing.value("governor"), "none: the kernel does not set the frequency");
    QCOMPARE(nothing.value("isolated"), "none");
    QCOMPARE(nothing.value("real_time_limit"), "not readable");
  }

  void no_limit_of_real_time_threads() {
    Files files;
    files.put("/proc/sys/kernel/sched_rt_runtime_us", "-1\n");
    QCOMPARE(files.value("real_time_limit"), "no limit (sched_rt_runtime_us = -1)");
  }

  void this_machine_has_a_kernel_and_versions() {
    for (const MachineFact& fact : machine_facts()) {
      QVERIFY(!fact.label.empty() && !fact.value.empty());
      if (fact.key == "kernel") QVERIFY(fact.value.starts_with("Linux "));
      if (fact.key == "versions") QVERIFY(fact.value.starts_with("trocar 0."));
    }
  }

  void load_is_what_happened_between_two_looks() {
    Files files;
    files.put("/proc/stat", "cpu  100 0 50 800 50 0 0 10 0 0\ncpu0 1 1 1 1 1 1 1 1\n");
    const ProcessorTimes begin = ProcessorTimes::now(files.root());
    QCOMPARE(begin.all, std::uint64_t{1010});
    QCOMPARE(begin.idle, std::uint64_t{850});
    QCOMPARE(begin.stolen, std::uint64_t{10});
    files.put("/proc/stat", "cpu  130 0 55 855 55 0 0 15 0 0\n");
    QCOMPARE(load_between(begin, ProcessorTimes::now(files.root())),
             std::string("40 % busy, 5.0 % stolen by the host"));
    QCOMPARE(load_between(begin, begin), std::string("not readable"));
    QCOMPARE(load_between({}, {}), std::string("not readable"));
  }
};

QTEST_GUILESS_MAIN(TestMachine)
#include "tst_machine.moc"
