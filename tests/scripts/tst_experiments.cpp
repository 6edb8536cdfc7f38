// SPDX-License-Identifier: Apache-2.0
// The paper's experiments, on few devices: the figures that docs/experiments.md shows for more of
// them keep within their bounds, and each imperfection moves them as theory says.
#include <QDir>
#include <QRegularExpression>
#include <QSet>
#include <cmath>

#include "tests/support/script_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

QString script(const char* name) {
  return QString(TROCAR_SOURCE_DIR "/scripts/experiments/") + name + ".lua";
}

const Literal* entry(const Literal& row, std::string_view key) {
  for (const auto& [name, value] : *row.as<Literal::Table>())
    if (name == key) return &value;
  return nullptr;
}

/// The rows of one name that an experiment published.
class Rows {
 public:
  Rows() = default;
  Rows(const ScriptOutcome& outcome, std::string_view name) {
    for (const Published& one : outcome.session->published())
      if (one.name == name) rows_.push_back(one.row);
  }
  Rows where(std::string_view key, const Literal& value) const {
    Rows chosen;
    for (const Literal& row : rows_)
      if (entry(row, key) != nullptr && entry(row, key)->text() == value.text())
        chosen.rows_.push_back(row);
    return chosen;
  }
  std::vector<double> numbers(std::string_view key) const {
    std::vector<double> all;
    for (const Literal& row : rows_) all.push_back(*entry(row, key)->as<double>());
    return all;
  }
  double mean(std::string_view key) const {
    double sum = 0.0;
    for (const double value : numbers(key)) sum += value;
    return sum / static_cast<double>(rows_.size());
  }
  std::size_t size() const { return rows_.size(); }
  const Literal& first() const { return rows_.front(); }

 private:
  std::vector<Literal> rows_;
};

/// Rows of Table I: axis and desired stiffness [N/m].
struct Case {
  const char* axis;
  double desired;
};
constexpr Case cases[] = {{"x", 5e3}, {"x", 15e3}, {"y", 6e3}, {"y", 18e3}};

Rows of(const Rows& rows, const Case& one) {
  return rows.where("axis", {std::string(one.axis)}).where("desired", {one.desired});
}

/// Of the mean over devices.
double standard_error(const Rows& rows) {
  const std::vector<double> errors = rows.numbers("error");
  double squares = 0.0;
  for (const double error : errors) squares += std::pow(error - rows.mean("error"), 2);
  const auto n = static_cast<double>(errors.size());
  return std::sqrt(squares / (n - 1.0) / n);
}

QString text(const Case& one, double value) {
  return QString("%1 at %2 N/m: %3").arg(one.axis).arg(one.desired).arg(value, 0, 'g', 6);
}

}  // namespace

class TestExperiments : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  QString identified_ = folder_.filePath("identified.lua");
  Rows found_;

 private Q_SLOTS:
  void initTestCase() {
    const ScriptOutcome outcome = run_script_file(
        script("identify"), {"training=2", "seeds=1", "file=" + identified_}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    found_ = Rows(outcome, "identify");
    QVERIFY(QFile::exists(identified_));
  }

  /// What it reads: files that it requires, one by another. Only instrument.lua reads the truth.
  void the_identifier_never_reads_what_only_a_simulation_knows() {
    QStringList open = {"identify"};
    QSet<QString> read;
    const QRegularExpression required("require\\s*\\(?\\s*\"([^\"]+)\"");
    while (!open.isEmpty()) {
      const QString name = open.takeFirst();
      if (read.contains(name)) continue;
      read.insert(name);
      QFile file(script(qPrintable(name)));
      QVERIFY2(file.open(QFile::ReadOnly), qPrintable(name));
      const QString content = QString::fromUtf8(file.readAll());
      QVERIFY2(!content.contains("truth"), qPrintable(name));
      for (auto match = required.globalMatch(content); match.hasNext();)
        open << match.next().captured(1);
    }
    QVERIFY(read.contains("identification") && !read.contains("instrument"));
  }

  /// The drives give 0.9655 ± 0.004; friction and delay are those that docs/mathematics.md lists.
  void identification_finds_the_device() {
    QCOMPARE(found_.size(), std::size_t{1});
    const Literal& row = found_.first();
    for (std::size_t i = 0; i < 6; ++i) {
      const double gain = *(*entry(row, "gain")->as<Literal::List>())[i].as<double>();
      QVERIFY2(std::abs(gain - 0.9655) < 0.012, qPrintable(QString::number(gain)));
      const double dry = *(*entry(row, "dry")->as<Literal::List>())[i].as<double>();
      const double nominal = i < 3 ? 0.35 : 0.013;
      QVERIFY2(std::abs(dry - nominal) < 0.15 * nominal, qPrintable(QString::number(dry)));
    }
    QVERIFY(std::abs(found_.mean("delay") - 0.25e-3) < 0.05e-3);
    QVERIFY2(found_.mean("residual_after") < 0.25 * found_.mean("residual_before"),
             qPrintable(QString::number(found_.mean("residual_after"))));
  }

  void table1_open_loop_and_compensated() {
    const ScriptOutcome outcome = run_script_file(
        script("table1"), {"seeds=3", "identified=" + identified_}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Rows all(outcome, "table1");
    QCOMPARE(all.size(), std::size_t{24});
    for (const Case& one : cases) {
      const Rows open = of(all.where("compensated", {false}), one);
      const Rows compensated = of(all.where("compensated", {true}), one);
      QVERIFY2(open.mean("error") > 0.0 && open.mean("error") < 0.06,
               qPrintable(text(one, open.mean("error"))));
      QVERIFY2(open.mean("r2") >= 0.97, qPrintable(text(one, open.mean("r2"))));
      // Three devices tell the mean to within twice its standard error.
      QVERIFY2(std::abs(compensated.mean("error")) <= 0.01 + 2.0 * standard_error(compensated),
               qPrintable(text(one, compensated.mean("error"))));
      QVERIFY2(compensated.mean("r2") >= 0.999, qPrintable(text(one, compensated.mean("r2"))));
      QVERIFY2(std::abs(compensated.mean("hysteresis")) < 0.5 * open.mean("hysteresis"),
               qPrintable(text(one, compensated.mean("hysteresis"))));
      for (const double slope : open.numbers("slope"))
        QVERIFY(std::abs(slope / one.desired - 1.0) < 0.1);
    }
  }

  /// Without --set identified the table identifies by itself.
  void table1_alone() {
    const ScriptOutcome outcome =
        run_script_file(script("table1"), {"seeds=1", "training=1"}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Rows all(outcome, "table1");
    QCOMPARE(all.where("compensated", {true}).size(), std::size_t{4});
    for (const Case& one : cases)
      QVERIFY(of(all.where("compensated", {true}), one).mean("r2") >= 0.999);
  }

  void a_perfect_plant_renders_what_was_asked_for() {
    const ScriptOutcome outcome = run_script_file(
        script("table1"), {"seeds=1", "plant=perfect", "readings=1000"}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Rows all(outcome, "table1");
    QCOMPARE(all.size(), std::size_t{4});
    for (const Case& one : cases) {
      QVERIFY2(std::abs(of(all, one).mean("error")) <= 0.002,
               qPrintable(text(one, of(all, one).mean("error"))));
      QVERIFY2(of(all, one).mean("r2") >= 0.9999, qPrintable(text(one, of(all, one).mean("r2"))));
    }
  }

  void each_imperfection_moves_the_figures_as_theory_says() {
    const ScriptOutcome outcome =
        run_script_file(script("ablation"), {"seeds=2"}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Rows all(outcome, "ablation");
    const auto without = [&](const Case& one, const char* what) {
      return of(all.where("without", {std::string(what)}), one);
    };
    for (const Case& one : cases) {
      const Rows base = without(one, "none is off");
      const double error = base.mean("error");
      // The slope is in proportion to the drives' gain, 0.9655 ± 0.004 each.
      QVERIFY2(std::abs(error - without(one, "drive gain").mean("error") - 0.0345) < 0.01,
               qPrintable(text(one, error - without(one, "drive gain").mean("error"))));
      // Friction is the hysteresis: at most 2 f_s / K, and makes the slope too high. At the tip
      // f_c = 0.62 N, and f_s = 1.2 f_c by Stribeck's effect.
      const double gap = base.mean("hysteresis");
      QVERIFY2(gap < 2.0 * 1.2 * 0.62 / one.desired * 1.05 && gap > 1.0 * 0.62 / one.desired,
               qPrintable(text(one, gap)));
      const double coulomb = without(one, "Stribeck").mean("hysteresis");
      QVERIFY2(coulomb < 2.0 * 0.62 / one.desired * 1.05 && coulomb < gap,
               qPrintable(text(one, coulomb)));
      // The transmissions, 3000 N/mm at the tip, are in series with the rendered spring.
      const double yielded = without(one, "compliance").mean("moved");
      QVERIFY2(std::abs(yielded - one.desired / 3e6) < 0.001, qPrintable(text(one, yielded)));
      QVERIFY(std::abs(without(one, "friction").mean("hysteresis")) < 0.05 * gap);
      QVERIFY(without(one, "friction").mean("r2") > base.mean("r2"));
      QVERIFY(without(one, "friction").mean("error") > error);
      // Ripple is relative to the effort and of either sign: at most 0.7 % through each axis, whose
      // shares at the tip are up to the lever l/M = 1.76.
      const double rippled = without(one, "force ripple").mean("moved");
      QVERIFY2(rippled > 0.0005 && rippled < 1.76 * 0.007, qPrintable(text(one, rippled)));
      // These are offsets, which a slope does not see.
      for (const char* small :
           {"quantisation", "homing error", "weight error", "cogging", "gain drift"})
        QVERIFY2(without(one, small).mean("moved") < 0.005,
                 qPrintable(text(one, without(one, small).mean("moved")) + " " + small));
      QVERIFY(std::abs(without(one, "all are off").mean("error")) < 0.002);
    }
    const double soft = without(cases[0], "none is off").mean("hysteresis");
    const double stiff = without(cases[1], "none is off").mean("hysteresis");
    QVERIFY2(std::abs(soft / stiff - 3.0) < 0.5, qPrintable(QString::number(soft / stiff)));
  }

  void chirp() {
    const ScriptOutcome outcome = run_script_file(
        script("chirp"), {"seeds=1", "identified=" + identified_}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Rows all(outcome, "chirp");
    const Rows open = all.where("compensated", {false}), fed = all.where("compensated", {true});
    QVERIFY2(open.mean("of_amplitude") <= 0.01,
             qPrintable(QString::number(open.mean("of_amplitude"))));
    QVERIFY2(fed.mean("of_amplitude") <= 0.001,
             qPrintable(QString::number(fed.mean("of_amplitude"))));
    QVERIFY(std::abs(fed.mean("lag")) < 0.5e-3 && open.mean("lag") > fed.mean("lag"));
    QVERIFY(std::abs(open.mean("of_range") - 0.5 * open.mean("of_amplitude")) < 1e-12);
  }

  void transparency() {
    const ScriptOutcome outcome = run_script_file(
        script("transparency"), {"seeds=1", "identified=" + identified_}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Rows all(outcome, "transparency");
    const Rows built = all.where("compensated", {false}), helped = all.where("compensated", {true});
    double sum = 0.0;
    const double mass[] = {1.38, 1.38, 1.21};     // at the neutral pose, the tool not tilting [kg]
    const double viscous[] = {14.6, 14.6, 24.0};  // [N s/m]
    const double dry[] = {0.62, 0.62, 1.05};      // [N]
    const char* names[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
      const Rows plain = built.where("axis", {std::string(names[i])});
      const double expected = dry[i] + 0.05 * viscous[i];
      QVERIFY2(std::abs(plain.mean("drag_005") - expected) < 0.1 * expected,
               qPrintable(QString("%1: %2 N").arg(names[i]).arg(plain.mean("drag_005"))));
      QVERIFY2(std::abs(plain.mean("mass") - mass[i]) < 0.1 * mass[i],
               qPrintable(QString("%1: %2 kg").arg(names[i]).arg(plain.mean("mass"))));
      const double drag = helped.where("axis", {std::string(names[i])}).mean("drag_005");
      QVERIFY2(drag > 0.0 && drag <= 0.2, qPrintable(QString("%1: %2 N").arg(names[i]).arg(drag)));
      sum += drag;
    }
    QVERIFY(sum < 0.6);
    const Rows drift(outcome, "drift");
    QVERIFY(drift.where("friction", {true}).mean("worst") < 1e-4);
    QVERIFY(drift.where("friction", {false}).where("compensated", {true}).mean("mean") <
            0.5 * drift.where("friction", {false}).where("compensated", {false}).mean("mean"));
  }

  void workspace() {
    const ScriptOutcome outcome = run_script_file(script("workspace"), {}, {.duration = {}});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Rows whole(outcome, "workspace"), translations(outcome, "translation"),
        depths(outcome, "depth");
    QVERIFY(std::abs(whole.mean("volume") - 3508e-6) < 10e-6);
    QVERIFY(whole.mean("standard_error") <= 0.01 * whole.mean("volume"));
    constexpr double degree = M_PI / 180.0;
    QVERIFY(std::abs(whole.mean("roll") - 480.0 * degree) < 1e-6);
    QVERIFY(whole.mean("yaw") > 44.9 * degree && whole.mean("pitch") > 44.9 * degree);
    const std::vector<double> insertion = translations.numbers("insertion");
    const double known[] = {119.5, 97.5, 75.0, 62.5, 49.5};  // mathematics: a grid of 0.5 mm
    for (std::size_t i = 0; i < 5; ++i)
      QVERIFY2(std::abs(1e3 * insertion[i] - known[i]) <= 0.8,
               qPrintable(QString::number(insertion[i])));
    QVERIFY(std::abs(translations.numbers("roll")[4] - 198.0 * degree) < 0.5 * degree);
    const std::vector<double> tilt = depths.numbers("tilt");
    QVERIFY(tilt[0] >= 44.5 * degree && std::abs(tilt[1] - 40.5 * degree) < degree &&
            std::abs(tilt[2] - 26.0 * degree) < degree);
  }
};

QTEST_GUILESS_MAIN(TestExperiments)
#include "tst_experiments.moc"
