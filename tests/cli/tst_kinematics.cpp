// SPDX-License-Identifier: Apache-2.0
// `trocar kinematics` as a user runs it: CSV in, CSV out.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/trocar_process.hpp"
#include "tests/support/csv_table.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar::test;

namespace {

const std::string vectors_path =
    std::string(TROCAR_SOURCE_DIR) + "/tests/data/laparoscope/vectors.csv";

const std::string dynamics_path =
    std::string(TROCAR_SOURCE_DIR) + "/tests/data/laparoscope/dyn.csv";

const QByteArray straight = "q1,q2,q3,phi1,phi2,phi3\n-.25,-.25,-.25,0,2.0943951,4.1887902\n";

QByteArray read_file(const std::string& path) {
  QFile file(QString::fromStdString(path));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::vector<std::string> matrix(const std::string& name, int size) {
  std::vector<std::string> names;
  for (int i = 1; i <= size; ++i)
    for (int j = 1; j <= size; ++j) names.push_back(name + std::to_string(i) + std::to_string(j));
  return names;
}

/// What the library says is violated.
QString limits_of(const CsvTable::Row& row) {
  const trocar::LaparoscopeModel model(geometry_of(row));
  trocar::LaparoscopeConfiguration c;
  if (model.forward(actuators_of(row), c) != trocar::AssemblyStatus::ok) return "not assembled";
  const trocar::LimitSet violated = violated_limits(trocar::LaparoscopeLimits(), c);
  QStringList names;
  for (unsigned i = 0; i < trocar::LimitSet::count; ++i)
    if (violated.has(i)) names << trocar::LimitSet::name(i);
  return names.join(';');
}

/// The rows of the poses and those of the dynamics side by side.
QByteArray joined_vectors() {
  const QList<QByteArray> poses = read_file(vectors_path).trimmed().split('\n');
  const QList<QByteArray> motions = read_file(dynamics_path).trimmed().split('\n');
  QByteArray joined;
  for (qsizetype i = 0; i < std::min(poses.size(), motions.size()); ++i)
    joined += poses[i].trimmed() + motions[i].trimmed().mid(motions[i].indexOf(',')) + '\n';
  return joined;
}

/// Largest difference over the largest expected number.
double relative_difference(const CsvTable::Row& got, const CsvTable::Row& expected,
                           const std::vector<std::string>& columns) {
  return relative_error(got.vector(columns), expected.vector(columns));
}

std::vector<std::string> six(const std::string& name) {
  std::vector<std::string> names;
  for (int i = 1; i <= 6; ++i) names.push_back(name + std::to_string(i));
  return names;
}

std::vector<std::string> upper_triangle(const std::string& name) {
  std::vector<std::string> names;
  for (int i = 1; i <= 6; ++i)
    for (int j = i; j <= 6; ++j) names.push_back(name + std::to_string(i) + std::to_string(j));
  return names;
}

QByteArray cell(const QByteArray& out, const QByteArray& column, int row = 1) {
  const QList<QByteArray> lines = out.split('\n');
  const auto at = lines.at(0).split(',').indexOf(column);
  return at < 0 || row >= lines.size() ? "?" : lines.at(row).split(',').value(at);
}

}  // namespace

class TestKinematics : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  CsvTable table(const QByteArray& csv) {
    const QString path = folder_.filePath("out.csv");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(csv) != csv.size()) qFatal("no disk");
    file.close();
    return CsvTable(path.toStdString());
  }

 private Q_SLOTS:
  void every_row_of_the_vectors_data() {
    QTest::addColumn<QString>("question");
    QTest::addColumn<QStringList>("columns");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<bool>("relative");  // to the largest of the row
    const auto list = [](const std::vector<std::string>& names) {
      QStringList strings;
      for (const std::string& name : names) strings << QString::fromStdString(name);
      return strings;
    };
    const QStringList six_dof = {"xd", "yd", "zd", "xt", "yt", "thetat"};
    QTest::newRow("fk") << "fk"
                        << six_dof + QStringList{"xe", "ye", "ze", "alpha", "beta", "theta"} +
                               list(matrix("R", 3))
                        << 1e-12 << false;
    QTest::newRow("ik") << "ik" << QStringList{"q1", "q2", "q3", "phi1", "phi2", "phi3"} + six_dof
                        << 1e-12 << false;
    QTest::newRow("jacobian") << "jacobian" << list(matrix("J", 6)) << 1e-10 << true;
    QTest::newRow("gravity") << "gravity" << QStringList{"V",     "taug1", "taug2", "taug3",
                                                         "taug4", "taug5", "taug6"}
                             << 1e-10 << false;
  }
  void every_row_of_the_vectors() {
    QFETCH(QString, question);
    QFETCH(QStringList, columns);
    QFETCH(double, tolerance);
    QFETCH(bool, relative);
    const Ran ran = run_trocar({"kinematics", question}, read_file(vectors_path));
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.status, 0);
    QCOMPARE(ran.out.left(ran.out.indexOf('\n')),
             ("id," + columns.join(',') + ",error,limits").toUtf8());
    const CsvTable reference(vectors_path);
    // A last column that is empty is no cell to CsvTable.
    const CsvTable result = table(QByteArray(ran.out).replace(",,\n", ",-,-\n"));
    QCOMPARE(result.rows().size(), reference.rows().size());
    for (std::size_t i = 0; i < result.rows().size(); ++i) {
      const auto& expected = reference.rows()[i];
      const auto& got = result.rows()[i];
      QCOMPARE(got.text("id"), expected.text("id"));
      QVERIFY(got.text("error") == "-" || got.text("error").empty());
      QCOMPARE(QString::fromStdString(got.text("limits")).remove('-'), limits_of(expected));
      double largest = relative ? 0.0 : 1.0;
      for (const QString& column : columns)
        if (relative) largest = std::max(largest, std::abs(expected.number(column.toStdString())));
      for (const QString& column : columns) {
        const std::string name = column.toStdString();
        const double error = std::abs(got.number(name) - expected.number(name)) / largest;
        QVERIFY2(error <= tolerance,
                 qPrintable(QString("%1 of %2 is off by %3")
                                .arg(column, QString::fromStdString(got.text("id")))
                                .arg(error)));
      }
    }
  }

  void dynamics_of_every_row_of_the_vectors() {
    const QByteArray input = joined_vectors();
    const Ran ran = run_trocar({"kinematics", "dynamics"}, input);
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.status, 0);
    const CsvTable poses(vectors_path), motions(dynamics_path);
    const CsvTable result = table(QByteArray(ran.out).replace(",,\n", ",-,-\n"));
    QCOMPARE(result.rows().size(), motions.rows().size());
    for (std::size_t i = 0; i < result.rows().size(); ++i) {
      const auto &got = result.rows()[i], &expected = motions.rows()[i];
      QCOMPARE(got.text("id"), expected.text("id"));
      const auto verify = [&](const char* what, double error, double tolerance) {
        QVERIFY2(error <= tolerance, qPrintable(QString("%1 of %2 is off by %3")
                                                    .arg(what, expected.text("id").c_str())
                                                    .arg(error)));
      };
      verify("M", relative_difference(got, expected, upper_triangle("M")), 1e-9);
      verify("c", relative_difference(got, expected, six("c")), 1e-6);
      verify("tau", relative_difference(got, expected, six("tau")), 1e-10);
      verify("taug",
             (got.vector(six("taug")) - poses.rows()[i].vector(six("taug"))).cwiseAbs().maxCoeff(),
             1e-10);
      // No efforts in the files, so that the rest of the equation has to vanish.
      trocar::Matrix6d m;
      for (int r = 0; r < 6; ++r)
        for (int c = r; c < 6; ++c)
          m(r, c) = m(c, r) = expected.number("M" + std::to_string(r + 1) + std::to_string(c + 1));
      const Eigen::VectorXd loads = expected.vector(six("tau")) - expected.vector(six("c")) -
                                    poses.rows()[i].vector(six("taug"));
      verify("qdd", relative_error(m * got.vector(six("qdd")), loads), 1e-6);
    }
  }

  void the_weight_that_is_held_does_not_accelerate() {
    const QByteArray header = "q1,q2,q3,phi1,phi2,phi3,qd1,qd2,qd3,qd4,qd5,qd6";
    const QByteArray state = "-.27,-.25,-.24,.1,2.0943951,4.1887902,0,0,0,0,0,0";
    const Ran free = run_trocar({"kinematics", "dynamics"}, header + "\n" + state + "\n");
    QByteArray efforts;
    for (const char* axis : {"taug1", "taug2", "taug3", "taug4", "taug5", "taug6"})
      efforts += "," + cell(free.out, axis);
    const Ran held = run_trocar({"kinematics", "dynamics"},
                                header + ",u1,u2,u3,u4,u5,u6\n" + state + efforts + "\n");
    QVERIFY(std::abs(cell(free.out, "qdd1").toDouble()) > 1.0);
    for (const char* axis : {"qdd1", "qdd2", "qdd3", "qdd4", "qdd5", "qdd6"})
      QVERIFY(std::abs(cell(held.out, axis).toDouble()) < 1e-9);
  }

  void what_dynamics_cannot_answer_has_its_reason_data() {
    QTest::addColumn<QByteArray>("columns");
    QTest::addColumn<QByteArray>("fields");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("an inertia below zero")
        << QByteArray("I_tt") << QByteArray("-1")
        << QByteArray("I_tt: masses: tool_transverse = -1: needs a value of at least 0");
    QTest::newRow("a gravity that is none")
        << QByteArray("gz") << QByteArray("nan") << QByteArray("\"gx, gy, gz: gravity must be");
    QTest::newRow("nothing that moves has inertia")
        << QByteArray("m_sl,m_lk,m_pl,m_tool,m_ee,I_tt,I_ta,I_ee,I_ring_eff")
        << QByteArray("0,0,0,0,0,0,0,0,0") << QByteArray("the mass matrix is singular");
  }
  void what_dynamics_cannot_answer_has_its_reason() {
    QFETCH(QByteArray, columns);
    QFETCH(QByteArray, fields);
    QFETCH(QByteArray, reason);
    const Ran ran = run_trocar({"kinematics", "dynamics"},
                               columns + ",q1,q2,q3,phi1,phi2,phi3,qd1,qd2,qd3,qd4,qd5,qd6\n" +
                                   fields + ",-.25,-.25,-.25,0,2.0943951,4.1887902,0,0,0,0,0,0\n");
    QCOMPARE(ran.status, 0);
    QCOMPARE(cell(ran.out, "qdd6"), QByteArray("nan"));
    QVERIFY2(ran.out.contains(reason), ran.out);
  }

  void what_fk_says_ik_takes_back() {
    const Ran pose = run_trocar({"kinematics", "fk"}, straight);
    const Ran back = run_trocar({"kinematics", "ik"}, pose.out);
    QCOMPARE(back.status, 0);
    QVERIFY(std::abs(cell(back.out, "q1").toDouble() + 0.25) < 1e-12);
    QVERIFY(std::abs(cell(back.out, "phi3").toDouble() - 4.1887902) < 1e-12);
  }

  void a_row_that_can_be_read_gets_an_answer_data() {
    QTest::addColumn<QString>("question");
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<QByteArray>("column");
    QTest::addColumn<QByteArray>("expected");
    const QByteArray header = "q1,q2,q3,phi1,phi2,phi3";
    const QByteArray q = "-.25,-.25,-.25,0,2.0943951,4.1887902";
    const QByteArray pose = "xe,ye,ze,alpha,beta,theta\n";
    QTest::newRow("rows without id are numbered")
        << "fk" << straight << QByteArray("id") << QByteArray("1");
    QTest::newRow("an empty id stays empty") << "fk"
                                             << "id," + header + "\n," + q + "\n"
                                             << QByteArray("id") << QByteArray();
    QTest::newRow("inside all limits") << "fk" << straight << QByteArray("limits") << QByteArray();
    QTest::newRow("three limits at once")
        << "fk" << header + "\n-.18,-.18,-.25,0,2.0943951,4.1887902\n"
        << QByteArray("limits") << QByteArray("slider_1_high;slider_2_high;tilt");
    QTest::newRow("a ring past its travel, computed all the same")
        << "jacobian" << header + "\n-.25,-.25,-.25,5,7.0943951,9.1887902\n"
        << QByteArray("limits") << QByteArray("ring_1_high;ring_2_high;ring_3_high");
    QTest::newRow("out of reach") << "ik" << pose + "0.5,0,0.1,0,0,0\n"
                                  << QByteArray("error") << QByteArray("delta links cannot reach");
    QTest::newRow("out of reach gives nan") << "ik" << pose + "0.5,0,0.1,0,0,0\n"
                                            << QByteArray("phi2") << QByteArray("nan");
    QTest::newRow("nan in, a reason out")
        << "fk" << header + "\nnan,-.25,-.25,0,0,0\n"
        << QByteArray("error") << QByteArray("a coordinate is not a finite number");
    QTest::newRow("a field in quotes")
        << "fk" << header + "\n\"-.25\",-.25,-.25,0,\"2.0943951\",4.1887902\n"
        << QByteArray("error") << QByteArray();
    QTest::newRow("lines of Windows") << "fk" << QByteArray(straight).replace("\n", "\r\n")
                                      << QByteArray("theta") << QByteArray("0");
    QTest::newRow("empty lines") << "fk"
                                 << "\n \n" + QByteArray(straight).replace("\n", "\n\n")
                                 << QByteArray("theta") << QByteArray("0");
    QTest::newRow("a byte order mark")
        << "fk"
        << "\xef\xbb\xbf" + straight << QByteArray("theta") << QByteArray("0");
    QTest::newRow("blanks around fields")
        << "fk" << QByteArray(straight).replace(",", " , ").replace("\n", " \n")
        << QByteArray("theta") << QByteArray("0");
    QTest::newRow("a plus sign") << "fk" << QByteArray(straight).replace(",0,", ",+0,")
                                 << QByteArray("theta") << QByteArray("0");
    QTest::newRow("no line end at the end")
        << "fk" << straight.chopped(1) << QByteArray("theta") << QByteArray("0");
    QTest::newRow("an empty field of its own geometry takes the default")
        << "fk"
        << "l," + header + "\n," + q + "\n"
        << QByteArray("theta") << QByteArray("0");
    QTest::newRow("a column that is not needed may hold anything")
        << "fk"
        << "m_sl,note," + header + "\nheavy,\"a, b\"," + q + "\n"
        << QByteArray("theta") << QByteArray("0");
    QTest::newRow("no gravity, no effort") << "gravity"
                                           << "gx,gy,gz," + header + "\n0,0,0," + q + "\n"
                                           << QByteArray("taug1") << QByteArray("-0");
  }
  void a_row_that_can_be_read_gets_an_answer() {
    QFETCH(QString, question);
    QFETCH(QByteArray, input);
    QFETCH(QByteArray, column);
    QFETCH(QByteArray, expected);
    const Ran ran = run_trocar({"kinematics", question}, input);
    QVERIFY2(ran.err.isEmpty(), ran.err);
    QCOMPARE(ran.status, 0);
    if (column == "theta")  // of the straight position, to rounding
      QVERIFY2(std::abs(cell(ran.out, column).toDouble()) < 1e-7, ran.out);
    else if (column == "taug1")
      QCOMPARE(cell(ran.out, column).toDouble(), 0.0);
    else
      QCOMPARE(cell(ran.out, column), expected);
  }

  void a_geometry_that_cannot_be_is_an_error_of_its_row() {
    const QByteArray q = "-.25,-.25,-.25,0,2.0943951,4.1887902";
    const Ran ran = run_trocar({"kinematics", "fk"},
                               "id,Rb,q1,q2,q3,phi1,phi2,phi3\na,.04," + q + "\nb,.14," + q + "\n");
    QCOMPARE(ran.status, 0);
    const QList<QByteArray> lines = ran.out.split('\n');
    QVERIFY2(lines.at(1).startsWith("a,nan,nan"), ran.out);
    QVERIFY2(lines.at(1).contains("\"Rb: geometry: base_radius = 0.04: must exceed"), ran.out);
    QVERIFY2(lines.at(2).startsWith("b,") && !lines.at(2).contains("nan"), ran.out);
  }

  void malformed_input_is_refused_data() {
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<QByteArrayList>("parts");  // of the message
    const QByteArray header = "id,q1,q2,q3,phi1,phi2,phi3\n";
    const QByteArray good = "a,-.25,-.25,-.25,0,2.0943951,4.1887902\n";
    QTest::newRow("nothing at all") << QByteArray() << QByteArrayList{"line 1: the input is empty"};
    QTest::newRow("a missing column")
        << QByteArray("q1,q2,q3,phi1,phi2\n")
        << QByteArrayList{"line 1: the header lacks the column \"phi3\"", "fk needs q1, q2"};
    QTest::newRow("a misspelt column")
        << QByteArray("q1,q2,q3,ph1,phi2,phi3\n")
        << QByteArrayList{"\"phi1\" (is it what the header calls \"ph1\"?)"};
    QTest::newRow("a column that stands twice")
        << QByteArray("q1,q1,q2,q3,phi1,phi2,phi3\n")
        << QByteArrayList{"line 1: column \"q1\" stands twice"};
    QTest::newRow("semicolons") << QByteArray("q1;q2;q3;phi1;phi2;phi3\n")
                                << QByteArrayList{"line 1: the header has no comma"};
    QTest::newRow("no number") << header + good + "b,-.25,abc,-.25,0,0,0\n"
                               << QByteArrayList{"line 3: column \"q2\": \"abc\" is no number",
                                                 "(answered before it: 1 row)"};
    QTest::newRow("a number with a tail")
        << header + "a,-.25,1.5m,0,0,0,0\n"
        << QByteArrayList{"line 2: column \"q2\": \"1.5m\" is no number"};
    QTest::newRow("an empty field") << header + "a,-.25,,0,0,0,0\n"
                                    << QByteArrayList{"line 2: column \"q2\": the field is empty"};
    QTest::newRow("a number too large")
        << header + "a,1e999,0,0,0,0,0\n"
        << QByteArrayList{"line 2: column \"q1\": \"1e999\" is beyond"};
    QTest::newRow("too few fields")
        << header + "\na,1,2\n"
        << QByteArrayList{"line 3: the row has 3 fields, the header has 7"};
    QTest::newRow("too many fields") << header + "a,1,2,3,4,5,6,7\n"
                                     << QByteArrayList{"line 2: the row has 8 fields"};
    QTest::newRow("blanks inside quotes belong to the field")
        << header + "a,\" 1 \",0,0,0,0,0\n"
        << QByteArrayList{"line 2: column \"q1\": \" 1 \" is no number"};
    QTest::newRow("an open quote")
        << header + "\"a,1,2,3,4,5,6\n" + good << QByteArrayList{"line 2: a quote is not closed"};
    QTest::newRow("text behind a quote")
        << header + "\"a\"b,1,2,3,4,5,6\n"
        << QByteArrayList{"line 2: field 1: text follows the closing quote"};
    QTest::newRow("control characters do not reach the terminal")
        << header + "a,\x1b[2J,0,0,0,0,0\n"
        << QByteArrayList{"\"\\x1b[2J\" is no number"};
  }
  void malformed_input_is_refused() {
    QFETCH(QByteArray, input);
    QFETCH(QByteArrayList, parts);
    const Ran ran = run_trocar({"kinematics", "fk"}, input);
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.startsWith("trocar: kinematics fk: line "), ran.err);
    for (const QByteArray& part : parts) QVERIFY2(ran.err.contains(part), ran.err);
    QVERIFY(ran.out.isEmpty() || ran.out.endsWith('\n'));
  }
};

QTEST_GUILESS_MAIN(TestKinematics)
#include "tst_kinematics.moc"
