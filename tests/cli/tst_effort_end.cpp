// SPDX-License-Identifier: Apache-2.0
#include "cli/effort_end.hpp"

#include <QTest>

#include "components/devices/hid/state_report.hpp"

using namespace trocar;
using cli::EffortEnd;

namespace {

hid::Report report(std::uint16_t sequence, std::uint32_t time_us) {
  hid::Report report;
  hid::encode({.sequence = sequence, .time_us = time_us}, report);
  return report;
}

QString said(std::uint32_t report_us, std::uint32_t command_us) {
  return QString::asprintf(
      "effort zero %.2f ms after the last good report and %.2f ms after the last command",
      report_us * 1e-3, command_us * 1e-3);
}

}  // namespace

class TestEffortEnd : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_is_counted_from_what_the_host_had_to_go_by() {
    EffortEnd end;
    end.cycle(false, 1000);
    QVERIFY2(end.text().empty(), "it never moved");
    end.report_left(report(1, 2000), 2000);
    end.command_taken(2250);
    end.cycle(true, 2500);
    QVERIFY2(end.text().empty(), "it moves");
    end.cycle(false, 8500);
    QCOMPARE(QString::fromStdString(end.text()), said(6500, 6250));
    end.report_left(report(2, 9000), 9000);
    end.cycle(false, 9250);
    QCOMPARE(QString::fromStdString(end.text()), said(6500, 6250));
    end.cycle(true, 9500);
    QVERIFY(end.text().empty());
    end.cycle(false, 9750);
    QCOMPARE(QString::fromStdString(end.text()), said(750, 7500));
    end.forget();
    QVERIFY(end.text().empty());
  }

  void what_the_host_cannot_use_is_no_good_report_data() {
    QTest::addColumn<QString>("what");
    for (const char* what : {"corrupted", "repeated", "older", "late"}) QTest::newRow(what) << what;
  }
  void what_the_host_cannot_use_is_no_good_report() {
    QFETCH(QString, what);
    constexpr std::uint32_t start = 0xFFFF'FF00;  // wraps soon
    EffortEnd end;
    end.report_left(report(0xFFFF, start), start);
    end.command_taken(start);
    end.cycle(true, start);
    hid::Report bad = report(0, start + 6000);
    if (what == "corrupted") bad[20] ^= 1;
    if (what == "repeated") bad = report(0xFFFF, start + 6000);
    if (what == "older") bad = report(0xFFFE, start + 6000);
    if (what == "late") bad = report(0, start + 900);
    end.report_left(bad, start + 6000);
    end.cycle(false, start + 7000);
    QCOMPARE(QString::fromStdString(end.text()), said(7000, 7000));
    end.cycle(true, start + 7250);
    end.report_left(report(0, start + 8000), start + 8000);
    end.cycle(false, start + 9000);
    QCOMPARE(QString::fromStdString(end.text()), said(1000, 9000));
  }
};

QTEST_APPLESS_MAIN(TestEffortEnd)
#include "tst_effort_end.moc"
