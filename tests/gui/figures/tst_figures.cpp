// SPDX-License-Identifier: Apache-2.0
// Figures of experiments: their numbers are those that the experiments report, and their files are
// what their endings say.
#include <CLI/CLI.hpp>
#include <QFile>
#include <QImage>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>

#include "framework/report.hpp"
#include "gui/figures/chirp_tracking.hpp"
#include "gui/figures/figure.hpp"
#include "gui/figures/figure_command.hpp"
#include "gui/figures/lateness.hpp"
#include "gui/figures/workspace_section.hpp"
#include "tests/support/script_bench.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::run_script_file;

namespace {

QString script(const char* name) {
  return QString(TROCAR_SOURCE_DIR "/scripts/experiments/") + name + ".lua";
}

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

bool near(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// What the SVG writes as texts; empty when it is not well-formed.
QStringList texts_of_svg(const QByteArray& svg) {
  QXmlStreamReader reader(svg);
  QStringList texts;
  while (!reader.atEnd())
    if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == u"text")
      texts << reader.readElementText().trimmed();
  return reader.hasError() ? QStringList() : texts;
}

}  // namespace

class TestFigures : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  std::string at(const QString& name) const { return folder_.filePath(name).toStdString(); }
  std::string written(const QString& name, const QByteArray& text) const {
    QFile file(folder_.filePath(name));
    return file.open(QFile::WriteOnly) && file.write(text) == text.size() ? at(name) : "";
  }
  /// `trocar-dashboard` with these arguments: its status.
  static int command(std::vector<std::string> arguments) {
    CLI::App app;
    FigureCommand figure;
    figure.add_options(app);
    std::reverse(arguments.begin(), arguments.end());
    app.parse(arguments);
    return figure.run();
  }
  std::string why_not(const std::string& kind, const std::string& in, RowFilter where = {}) const {
    for (const FigureKind& one : figure_kinds()) {
      if (one.name != kind) continue;
      try {
        one.draw(ResultFile(in), {.where = std::move(where), .quantity = ""});
      } catch (const FigureError& error) {
        return error.what();
      }
    }
    return "";
  }

 private Q_SLOTS:
  void initTestCase() {
    const auto outcome = run_script_file(script("table1"), {"seeds=2", "plant=perfect"},
                                         {.duration = {}, .record = at("table1.mcap")});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    written("table1.json", QByteArray::fromStdString(report_json(*outcome.session)));
  }

  void the_fit_of_force_over_deflection_is_that_of_the_report() {
    for (const char* name : {"table1.json", "table1.mcap"}) {
      const ResultFile file(at(name));
      const ForceDeflections all = force_deflections(file, {{"seed", "2"}});
      QCOMPARE(all.source, std::string("table1"));
      QCOMPARE(all.rows, std::size_t{8});
      QCOMPARE(all.curves.size(), std::size_t{4});
      std::size_t found = 0;
      for (const auto& row : file.published().front().second) {
        if (row["seed"].get<double>() != 2.0) continue;
        const ForceDeflection& curve = all.curves[found++];
        QVERIFY(near(curve.slope, row["slope"].get<double>()));
        QVERIFY(near(curve.r2, row["r2"].get<double>()));
        QCOMPARE(curve.reported, row["slope"].get<double>());
        double squares = 0.0;
        for (const double residual : curve.residual) squares += residual * residual;
        QVERIFY(near(curve.rms, std::sqrt(squares / 17.0)));
      }
      QCOMPARE(found, std::size_t{4});
    }
  }

  void what_the_filter_leaves_open_is_as_in_the_first_row() {
    const ForceDeflections all = force_deflections(ResultFile(at("table1.json")), {});
    QCOMPARE(all.shown, (RowFilter{{"compensated", "false"}, {"seed", "1"}}));
    QCOMPARE(all.curves[3].label, std::string("y, 18 N/mm"));
  }

  void the_tracking_of_a_chirp_is_that_of_the_report() {
    const auto outcome =
        run_script_file(script("chirp"), {"seeds=1"}, {.duration = {}, .record = at("chirp.mcap")});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const ResultFile file(at("chirp.mcap"));
    const ChirpTracking chirp = chirp_tracking(file, 1, "");
    const nlohmann::json row = file.published().front().second.front();
    QVERIFY(near(chirp.rms, row["rms"].get<double>()));
    QVERIFY(near(chirp.worst, row["worst"].get<double>()));
    QVERIFY(near(chirp.gain, row["gain"].get<double>()));
    QVERIFY(near(chirp.lag, row["lag"].get<double>()));
    QCOMPARE(chirp.time.front(), 0.5);
    QCOMPARE(command({"--figure", "chirp", at("chirp.mcap"), at("chirp.svg")}), 0);
    const QStringList texts = texts_of_svg(bytes_of(folder_.filePath("chirp.svg")));
    for (const char* text : {"Time [s]", "z [mm]", "Error [mm]", "reference", "tip"})
      QVERIFY2(texts.contains(text), qPrintable(texts.join(" | ")));
    QCOMPARE(command({"--figure", "chirp", at("chirp.mcap"), at("no.png"), "--figure-run", "2"}),
             2);
    QFile::remove(folder_.filePath("chirp.mcap"));  // it is large
  }

  /// In real time, whatever this machine makes of it: the report of the same run says the same.
  void lateness_is_that_of_the_report() {
    const auto outcome =
        run_script_file(TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua", {},
                        {.duration = 0.5, .record = at("late.mcap")}, ClockKind::realtime);
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    const Lateness late = lateness_of(ResultFile(at("late.mcap")), 1, "main");
    const auto report = nlohmann::json::parse(report_json(*outcome.session))["runs"][0]["lateness"];
    QCOMPARE(late.count, report["count"].get<std::size_t>());
    for (const auto& [figure, name] : {std::pair{late.p50, "p50"}, std::pair{late.p99, "p99"},
                                       std::pair{late.p999, "p999"}, std::pair{late.max, "max"}})
      QVERIFY2(near(figure, report[name].get<double>()), name);
    std::size_t ticks = 0;
    for (const Lateness::Bin& bin : late.bins) ticks += bin.count;
    QCOMPARE(ticks, late.count);
    QCOMPARE(command({"--figure", "lateness", at("late.mcap"), at("late.pdf")}), 0);
  }

  void sections_of_a_workspace_are_cells_of_the_map() {
    QByteArray map = "x,y,z,filled,condition_median\n";
    for (const double z : {0.03, 0.05})
      for (const double y : {-0.01, 0.01})
        for (const double x : {-0.03, -0.01, 0.01})
          map += QString("%1,%2,%3,%4,%5\n")
                     .arg(x)
                     .arg(y)
                     .arg(z)
                     .arg(z > 0.04 ? 1.0 : 0.5)
                     .arg(x < -0.02 ? QString("nan") : QString::number(100 * (x + y + z)))
                     .toUtf8();
    const ResultFile file(written("map.csv", map));
    const WorkspaceSections all = workspace_sections(file, "condition_median");
    QVERIFY(near(all.edge, 0.02));
    QCOMPARE(all.side.at, 0.01);  // of those beside zero
    QCOMPARE(all.top.at, 0.05);   // where most is reached
    QCOMPARE(all.side.cells.size(), std::size_t{6});
    QCOMPARE(all.top.cells.size(), std::size_t{6});
    QVERIFY(std::isnan(all.side.cells.front().value));
    QVERIFY(near(all.least, 3.0));
    QVERIFY(near(all.greatest, 7.0));
    QCOMPARE(quantity_text("continuous_force_least"), std::string("Continuous force, least [N]"));
    QCOMPARE(command({"--figure", "workspace", at("map.csv"), at("map.svg"), "--quantity",
                      "condition_median"}),
             0);
    const QStringList texts = texts_of_svg(bytes_of(folder_.filePath("map.svg")));
    QVERIFY2(texts.contains("Condition, median"), qPrintable(texts.join(" | ")));
  }

  void a_fit_in_words() {
    const std::string in =
        written("line.json",
                R"({"published": {"spring": [{"x": [0, 0.001, 0.002], "force": [1, 3, 5]}]}})");
    const ForceDeflections all = force_deflections(ResultFile(in), {});
    QCOMPARE(fit_text(all.curves.front()),
             std::string("1: slope 2.000 ± 0.000 N/mm, intercept 1.000 N, R² 1.00000, residual "
                         "0.000 N RMS, 3 readings"));
  }

  void a_file_that_does_not_carry_a_figure_says_what_is_needed_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("says");
    QTest::newRow("a report of another experiment")
        << "a.json" << QByteArray(R"({"published": {"chirp": [{"rms": 1}]}})") << "force-deflection"
        << "published in it: chirp (1 row)";
    QTest::newRow("a report without results")
        << "b.json" << QByteArray(R"({"runs": []})") << "force-deflection"
        << "needs published rows with the lists x [m] and force [N]";
    QTest::newRow("no JSON") << "c.json" << QByteArray("{") << "force-deflection"
                             << "is not a report";
    QTest::newRow("another file") << "d.txt" << QByteArray("1") << "force-deflection"
                                  << "neither a log (.mcap) nor a report (.json)";
    QTest::newRow("a line through one point")
        << "e.json" << QByteArray(R"({"published": {"s": [{"x": [1], "force": [1]}]}})")
        << "force-deflection"
        << "as many rows";
    QTest::newRow("lists of different lengths")
        << "f.json" << QByteArray(R"({"published": {"s": [{"x": [1, 2], "force": [1, 2, 3]}]}})")
        << "force-deflection"
        << "rows";
    QTest::newRow("a report where a log is needed")
        << "g.json" << QByteArray(R"({"published": {}})") << "lateness"
        << "needs the rows of a log (.mcap)";
    QTest::newRow("a report without the rows of a chirp")
        << "h.json" << QByteArray(R"({"published": {}})") << "chirp"
        << "a ChirpMotion whose offset goes to a PoseSpring";
    QTest::newRow("a table of something else") << "i.csv" << QByteArray("x,y\n1,2\n") << "workspace"
                                               << "there is no column z";
    QTest::newRow("a table with a word in it")
        << "j.csv" << QByteArray("x,y\n1,two\n") << "workspace"
        << "line 2: \"two\" in column y is no number";
    QTest::newRow("a table with a line too long")
        << "k.csv" << QByteArray("x,y\n1,2,3\n") << "workspace"
        << "line 2 has 3 cells, the first line names 2 columns";
    QTest::newRow("a map without the column")
        << "l.csv" << QByteArray("x,y,z,filled,continuous_force_leest\n1,1,1,1,1\n") << "workspace"
        << "did you mean \"continuous_force_leest\"?";
  }
  void a_file_that_does_not_carry_a_figure_says_what_is_needed() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(QString, kind);
    QFETCH(QString, says);
    const QString why = QString::fromStdString(why_not(kind.toStdString(), written(name, content)));
    QVERIFY2(why.contains(says), qPrintable(why));
  }

  void exit_statuses_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::newRow("a figure") << QStringList{"force-deflection", "table1.json", "ok.png"} << 0;
    QTest::newRow("a kind that there is not")
        << QStringList{"force-deflect", "table1.json", "no.png"} << 2;
    QTest::newRow("a file of another kind")
        << QStringList{"force-deflection", "table1.json", "no.gif"} << 2;
    QTest::newRow("a file that is not there")
        << QStringList{"force-deflection", "nothing.json", "no.png"} << 1;
    QTest::newRow("a folder that is not there")
        << QStringList{"force-deflection", "table1.json", "no/no.svg"} << 1;
    QTest::newRow("no row fits") << QStringList{"force-deflection", "table1.json", "no.png",
                                                "--where", "seed=7"}
                                 << 2;
    QTest::newRow("a filter without a value")
        << QStringList{"force-deflection", "table1.json", "no.png", "--where", "seed"} << 2;
  }
  void exit_statuses() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    std::vector<std::string> all = {"--figure", arguments[0].toStdString(), at(arguments[1]),
                                    at(arguments[2])};
    for (const QString& option : arguments.mid(3)) all.push_back(option.toStdString());
    QCOMPARE(command(all), status);
    QVERIFY(!QFile::exists(folder_.filePath("no.png")));
  }

  void files_are_what_their_endings_say() {
    for (const char* ending : {"png", "svg", "pdf"})
      for (const char* name : {"one.", "two."})
        QCOMPARE(command({"--figure", "force-deflection", at("table1.json"),
                          at(QString(name) + ending)}),
                 0);
    QImage image;
    QVERIFY(image.loadFromData(bytes_of(folder_.filePath("one.png")), "PNG"));
    QCOMPARE(image.width(), 1339);  // 85 mm at 400 dpi
    QCOMPARE(image.dotsPerMeterX(), 15748);
    QCOMPARE(image.pixelColor(2, 2), QColor(Qt::white));
    const QStringList texts = texts_of_svg(bytes_of(folder_.filePath("one.svg")));
    for (const char* text : {"Force [N]", "Deflection [mm]", "Residual [N]"})
      QVERIFY2(texts.contains(text), qPrintable(texts.join(" | ")));
    const auto all = force_deflections(ResultFile(at("table1.json")), {});
    const QString slope = QString::number(1e-3 * all.curves[0].slope, 'f', 2);
    QVERIFY(texts.filter("x, 5 N/mm: F = " + slope + " N/mm x").size() == 1);
    const QByteArray pdf = bytes_of(folder_.filePath("one.pdf"));
    QVERIFY(pdf.startsWith("%PDF-1."));
    QVERIFY(pdf.contains("/MediaBox [0 0 241"));  // 85 mm in points
    QVERIFY(!pdf.contains("/Subtype /Image"));
    for (const char* ending : {"png", "svg"})
      QCOMPARE(bytes_of(folder_.filePath(QString("one.") + ending)),
               bytes_of(folder_.filePath(QString("two.") + ending)));
  }
};

QTEST_MAIN(TestFigures)
#include "tst_figures.moc"
