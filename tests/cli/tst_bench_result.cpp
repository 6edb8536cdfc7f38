// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_result.hpp"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace trocar::cli;
using nlohmann::json;

namespace {

constexpr std::int64_t us = 1000;  // [ns]

/// 1000 slots: all but 20 of them late by `usual`, those by `rare`.
LoopRound round_of(std::int64_t usual, std::int64_t rare, std::int64_t skipped = 0) {
  LoopRound round;
  for (int i = 0; i < 980; ++i) round.lateness.add(usual);
  for (int i = 0; i < 20; ++i) round.lateness.add(rare);
  round.used = 1000;
  round.skipped = skipped;
  round.elapsed = static_cast<double>(999 + skipped) + 0.01;
  round.uncertainty = 0.02;
  round.spun = 0.1;
  round.complete = true;
  return round;
}

/// Three rounds; Trocar's loop is later by a quarter.
BenchResult result_of() {
  BenchResult result;
  result.rounds_wanted = 3;
  result.round_time = 1.0;
  result.timing.spin = 100e-6;
  result.machine = {{"kernel", "kernel", "Linux 1.0"}};
  result.grants = {true, 80, 1, 2048};
  result.load = "50 % busy, 0.0 % stolen by the host";
  result.shortcomings = {"something is missing: do this"};
  result.rates.push_back(
      {1000.0,
       {round_of(16 * us, 64 * us), round_of(32 * us, 128 * us), round_of(16 * us, 64 * us, 5)},
       {round_of(20 * us, 64 * us), round_of(20 * us, 64 * us), round_of(40 * us, 256 * us, 2)}});
  return result;
}

bool near(double value, double expected) {  // to the width of a histogram's bin
  return value >= expected * (1.0 - 1e-9) && value <= expected * (1.0 + 1.0 / 16.0);
}

}  // namespace

class TestBenchResult : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_figure_is_the_median_over_rounds() {
    const BenchResult result = result_of();
    const OverRounds half = over_rounds(result.rates[0].bare, 0.5);
    QVERIFY(near(half.median, 16e-6) && near(half.least, 16e-6) && near(half.greatest, 32e-6));
    QVERIFY(near(over_rounds(result.rates[0].bare, 0.99).median, 64e-6));
    QCOMPARE(over_rounds(result.rates[0].trocar, 1.0).greatest, 256e-6);  // the worst is exact
    const OverRounds even = over_rounds({round_of(16 * us, us), round_of(32 * us, us)}, 0.5);
    QVERIFY(near(even.median, 24e-6));
    QCOMPARE(over_rounds({}, 0.5).median, 0.0);
  }

  void the_ratio_is_that_of_pairs() {
    // Each pair on a machine that got twice as slow since the one before.
    RateRounds rounds{.rate = 1000.0};
    for (int i = 0; i < 5; ++i) {
      rounds.bare.push_back(round_of((16 * us) << i, 64 * us << i));
      rounds.trocar.push_back(round_of((20 * us) << i, 64 * us << i));
    }
    std::optional<PairRatio> half = ratio_over_pairs(rounds, 0.5);
    QVERIFY(half && std::abs(half->median - 1.25) < 0.08);
    QVERIFY2(!half->interval, "five pairs bound nothing with 95 %");
    QCOMPARE(ratio_over_pairs(rounds, 1.0)->median, 1.0);
    rounds.bare.push_back(round_of(16 * us, 64 * us));
    rounds.trocar.push_back(round_of(16 * us, 256 * us));
    const std::optional<PairRatio> worst = ratio_over_pairs(rounds, 1.0);
    QCOMPARE(worst->median, 1.0);
    QVERIFY(worst->interval && worst->interval->first == 1.0 && worst->interval->second == 4.0);
  }

  // Ranks of the sign test: 1 of 6, 2 of 10, 6 of 20 (tables of the binomial distribution).
  void the_interval_takes_its_ranks_from_the_binomial_distribution_data() {
    QTest::addColumn<int>("pairs");
    QTest::addColumn<int>("rank");
    for (const auto& [pairs, rank] : {std::pair(6, 1), {8, 1}, {9, 2}, {10, 2}, {20, 6}, {40, 14}})
      QTest::addRow("%d", pairs) << pairs << rank;
  }
  void the_interval_takes_its_ranks_from_the_binomial_distribution() {
    QFETCH(int, pairs);
    QFETCH(int, rank);
    RateRounds rounds{.rate = 1000.0};
    for (int i = 1; i <= pairs; ++i) {
      rounds.bare.push_back(round_of(us, 100 * us));
      rounds.trocar.push_back(round_of(us, i * 100 * us));
    }
    const std::optional<PairRatio> worst = ratio_over_pairs(rounds, 1.0);
    QCOMPARE(worst->interval->first, static_cast<double>(rank));
    QCOMPARE(worst->interval->second, static_cast<double>(pairs + 1 - rank));
  }

  void a_loop_that_was_hardly_late_has_no_ratio() {
    QVERIFY(!ratio_over_pairs({1000.0, {round_of(100, 200)}, {round_of(400, 800)}}, 0.5));
    QVERIFY(!ratio_over_pairs({.rate = 1000.0}, 0.5));
  }

  void rounds_add_up_or_not() {
    LoopRound round = round_of(us, us, 3);
    QVERIFY(round.adds_up());
    round.skipped = 4;
    QVERIFY(!round.adds_up());
    round.skipped = 3;
    round.elapsed += 0.02;
    QVERIFY(!round.adds_up());
    const LoopTotal total = total_of({round_of(us, us, 2), round});
    QVERIFY(!total.adds_up);
    QCOMPARE(total.used, std::int64_t{2000});
    QCOMPARE(total.skipped, std::int64_t{5});
    QVERIFY(std::abs(total.drift - 0.03) < 1e-9);
  }

  void the_text_has_both_loops_the_ratio_and_the_machine_data() {
    QTest::addColumn<QString>("says");
    for (const char* line :
         {"3 rounds of 1 s a rate", "both with a guard spin of 100 µs",
          "1 kHz, a period of 1000 µs, 3 rounds", "lateness [µs]", "Trocar / bare", "1.25",
          "slots missed", "guard spin [% of a processor]",
          "bare loop: elapsed time is 3,000 slots used and 5 slots skipped,", "no drift", "kernel",
          "Linux 1.0", "SCHED_FIFO 80", "locked, 2 MB", "1 ns", "left alone (--hold-latency)",
          "not real-time: something is missing: do this",
          "Lateness is how long after its slot a tick begins."})
      QTest::newRow(line) << line;
  }
  void the_text_has_both_loops_the_ratio_and_the_machine() {
    QFETCH(QString, says);
    const QString text = QString::fromStdString(bench_text(result_of()));
    QVERIFY2(text.contains(says), qPrintable(text));
  }

  void a_loop_that_drifts_is_told() {
    BenchResult result = result_of();
    result.rates[0].trocar[1].elapsed += 1.0;
    QVERIFY(QString::fromStdString(bench_text(result)).contains("DRIFTS"));
    const json report = json::parse(bench_json(result));
    QVERIFY(!report["rates"][0]["trocar"]["adds_up"].get<bool>());
    QVERIFY(report["rates"][0]["bare"]["adds_up"].get<bool>());
  }

  void what_was_not_granted_is_told() {
    BenchResult result = result_of();
    result.grants = {};
    result.timing.hold_latency = true;
    result.shortcomings = {"/dev/cpu_dma_latency is not held"};
    const QString text = QString::fromStdString(bench_text(result));
    for (const char* says : {"not granted: ordinary scheduling", "not locked", "see below"})
      QVERIFY2(text.contains(says), qPrintable(text));
    result.shortcomings.clear();
    QVERIFY(bench_text(result).find("held at 0: no deep sleep") != std::string::npos);
  }

  void the_json_is_for_programs() {
    const json report = json::parse(bench_json(result_of()));
    QCOMPARE(report["rounds"].get<int>(), 3);
    QCOMPARE(report["spin"].get<double>(), 100e-6);
    QVERIFY(report["machine"]["fifo"].get<bool>());
    QCOMPARE(report["machine"]["kernel"].get<std::string>(), std::string("Linux 1.0"));
    const json& rate = report["rates"][0];
    QCOMPARE(rate["rate"].get<double>(), 1000.0);
    QCOMPARE(rate["bare"]["p50"]["rounds"].size(), std::size_t{3});
    QVERIFY(near(rate["trocar"]["p50"]["median"].get<double>(), 20e-6));
    QVERIFY(std::abs(rate["ratio"]["p50"]["median"].get<double>() - 1.25) < 0.1);
    QCOMPARE(rate["trocar"]["skipped"].get<int>(), 2);
    QCOMPARE(rate["bare"]["slots"].get<int>(), 3000);
  }

  void a_rate_without_a_whole_round_is_left_out() {
    BenchResult result = result_of();
    result.rates.push_back({.rate = 4000.0});
    result.interrupted = true;
    QVERIFY(!result.empty());
    QCOMPARE(json::parse(bench_json(result))["rates"].size(), std::size_t{1});
    const QString text = QString::fromStdString(bench_text(result));
    QVERIFY(text.contains("Stopped by the operator") && !text.contains("4 kHz"));
    result.rates.erase(result.rates.begin());
    QVERIFY(result.empty());
  }

  void the_csv_holds_every_sample() {
    const QString text = QString::fromStdString(bench_csv(result_of()));
    const QStringList lines = text.split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.front(), "loop,rate_hz,lower_ns,upper_ns,count");
    QHash<QString, qint64> counts;
    for (const QString& line : lines.mid(1)) {
      const QStringList cells = line.split(',');
      QCOMPARE(cells.size(), 5);
      QCOMPARE(cells[1], "1000");
      QVERIFY(cells[2].toLongLong() <= cells[3].toLongLong());
      counts[cells[0]] += cells[4].toLongLong();
    }
    QCOMPARE(counts, (QHash<QString, qint64>{{"bare", 3000}, {"trocar", 3000}}));
  }
};

QTEST_GUILESS_MAIN(TestBenchResult)
#include "tst_bench_result.moc"
