// SPDX-License-Identifier: Apache-2.0
// Every row of the reference vectors, at the tolerances that they come with.
#include <QTest>

#include "components/kinematics/laparoscope_dynamics.hpp"
#include "components/kinematics/laparoscope_limits.hpp"
#include "tests/support/csv_table.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

const std::string folder = std::string(TROCAR_SOURCE_DIR) + "/tests/data/laparoscope/";

#define VERIFY_BELOW(value, limit)                                                                \
  do {                                                                                            \
    const double measured = (value);                                                              \
    QVERIFY2(                                                                                     \
        measured <= (limit),                                                                      \
        qPrintable(QString("%1: %2 = %3, allowed %4").arg(id, #value).arg(measured).arg(limit))); \
  } while (false)

double largest(const Eigen::MatrixXd& m) {
  return m.cwiseAbs().maxCoeff();
}

}  // namespace

class TestLaparoscopeVectors : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void all_240_rows_are_there() {
    QCOMPARE(vectors_.rows().size(), std::size_t{240});
    QCOMPARE(parts_.rows().size(), std::size_t{240});
    QCOMPARE(dynamics_.rows().size(), std::size_t{240});
    QCOMPARE(edges_.rows().size(), std::size_t{72});
  }

  void forward_kinematics() {
    for (const auto& row : vectors_.rows()) {
      const QString id = QString::fromStdString(row.text("id"));
      const LaparoscopeConfiguration c = assembled(row);
      VERIFY_BELOW(
          largest(c.tool.coordinates() - row.vector({"xd", "yd", "zd", "xt", "yt", "thetat"})),
          1e-12);
      const PoseCoordinates pose = c.tool.pose(), expected = pose_of(row);
      VERIFY_BELOW(largest(pose.tip - expected.tip), 1e-12);
      VERIFY_BELOW(std::abs(pose.alpha - expected.alpha), 1e-12);
      VERIFY_BELOW(std::abs(pose.beta - expected.beta), 1e-12);
      VERIFY_BELOW(std::abs(pose.theta - expected.theta), 1e-12);
      VERIFY_BELOW(largest(c.tool.rotation - row.matrix("R", 3, 3)), 1e-12);
    }
  }

  void inverse_kinematics() {
    for (const auto& row : vectors_.rows()) {
      const QString id = QString::fromStdString(row.text("id"));
      const LaparoscopeModel model(geometry_of(row));
      Vector6d q;
      QCOMPARE(model.inverse(pose_of(row), q), AssemblyStatus::ok);
      VERIFY_BELOW(largest(q - actuators_of(row)), 1e-12);
      QCOMPARE(model.inverse(pose_of(row).tip, row.matrix("R", 3, 3), row.number("theta"), q),
               AssemblyStatus::ok);
      VERIFY_BELOW(largest(q - actuators_of(row)), 2e-12);
    }
  }

  void jacobian() {
    for (const auto& row : vectors_.rows()) {
      const QString id = QString::fromStdString(row.text("id"));
      const LaparoscopeModel model(geometry_of(row));
      VERIFY_BELOW(relative_error(model.rates(assembled(row)).jacobian, row.matrix("J", 6, 6)),
                   1e-10);
    }
  }

  void parts_of_the_jacobian() {
    for (std::size_t i = 0; i < parts_.rows().size(); ++i) {
      const auto& row = parts_.rows()[i];
      const QString id = QString::fromStdString(row.text("id"));
      QCOMPARE(row.text("id"), vectors_.rows()[i].text("id"));
      const LaparoscopeModel model(geometry_of(vectors_.rows()[i]));
      const LaparoscopeConfiguration c = assembled(vectors_.rows()[i]);
      const LaparoscopeRates r = model.rates(c);
      const Eigen::Matrix3d jd = Eigen::Vector3d(1, 1, -1).asDiagonal() * r.delta.jacobian;
      VERIFY_BELOW(relative_error(model.tool().jacobian(c.tool), row.matrix("JR", 6, 6)), 1e-10);
      VERIFY_BELOW(relative_error(jd, row.matrix("JD", 3, 3)), 1e-10);
      VERIFY_BELOW(relative_error(r.rings, row.matrix("JT", 3, 3)), 1e-10);
      VERIFY_BELOW(relative_error(model.tool().pose_rate_jacobian(c.tool), row.matrix("JP", 6, 6)),
                   1e-10);
      VERIFY_BELOW(std::abs(c.tool.engagement - row.number("M")), 1e-12);
      VERIFY_BELOW(std::abs(c.tool.tilt() - row.number("tilt")), 1e-12);
    }
  }

  void gravity() {
    for (const auto& row : vectors_.rows()) {
      const QString id = QString::fromStdString(row.text("id"));
      const LaparoscopeModel model(geometry_of(row));
      const LaparoscopeGravity weight(geometry_of(row), masses_of(row));
      const Eigen::Vector3d g = row.vector({"gx", "gy", "gz"});
      const LaparoscopeConfiguration c = assembled(row);
      VERIFY_BELOW(std::abs(weight.potential(c, g) - row.number("V")), 1e-10);
      VERIFY_BELOW(largest(weight.effort(c, model.rates(c), g) - row.vector("taug", 6)), 1e-10);
    }
  }

  void inertia_bias_and_statics() {
    for (std::size_t i = 0; i < dynamics_.rows().size(); ++i) {
      const auto& row = dynamics_.rows()[i];
      const auto& pose = vectors_.rows()[i];
      const QString id = QString::fromStdString(row.text("id"));
      QCOMPARE(row.text("id"), pose.text("id"));
      LaparoscopeMasses masses = masses_of(pose);
      masses.tool_transverse = row.number("I_tt");
      masses.tool_axial = row.number("I_ta");
      masses.end_effector_spin = row.number("I_ee");
      masses.ring = row.number("I_ring_eff");
      const LaparoscopeDynamics dynamics(geometry_of(pose), masses);
      const LaparoscopeConfiguration c = assembled(pose);
      const LaparoscopeRates r = dynamics.model().rates(c);
      const auto inertia = dynamics.inertia(c, r);
      VERIFY_BELOW(relative_error(inertia.mass, upper_triangle(row)), 1e-9);
      const auto bias = dynamics.bias(c, r, inertia, row.vector("qd", 6));
      VERIFY_BELOW(relative_error(bias.effort, row.vector("c", 6)), 1e-6);
      VERIFY_BELOW(relative_error(static_effort(r, row.vector("F", 6)), row.vector("tau", 6)),
                   1e-10);
    }
  }

  void tool_alone_outside_the_device() {
    for (const auto& row : edges_.rows()) {
      const QString id = QString::fromStdString(row.text("id"));
      const Tool tool(row.number("l"), row.number("zt"), RollModel::gimbal_outer_y);
      const Eigen::VectorXd x = row.vector({"xd", "yd", "zd", "xt", "yt", "thetat"});
      Tool::State s;
      QCOMPARE(tool.forward({x[0], x[1], -x[2]}, x.segment<2>(3), x[5],
                            {std::cos(x[5]), std::sin(x[5])}, s),
               AssemblyStatus::ok);
      const PoseCoordinates pose = s.pose(), expected = pose_of(row);
      VERIFY_BELOW(largest(pose.tip - expected.tip), 1e-12);
      VERIFY_BELOW(std::abs(pose.alpha - expected.alpha), 1e-12);
      VERIFY_BELOW(std::abs(pose.beta - expected.beta), 1e-12);
      VERIFY_BELOW(largest(s.rotation - row.matrix("R", 3, 3)), 1e-12);
      QCOMPARE(tool.inverse(expected, s), AssemblyStatus::ok);
      VERIFY_BELOW(largest(s.coordinates() - x), 1e-12);
    }
  }

 private:
  static LaparoscopeConfiguration assembled(const CsvTable::Row& row) {
    const LaparoscopeModel model(geometry_of(row));
    LaparoscopeConfiguration c;
    if (model.forward(actuators_of(row), c) != AssemblyStatus::ok)
      throw std::runtime_error("not assembled: " + row.text("id"));
    return c;
  }

  static Matrix6d upper_triangle(const CsvTable::Row& row) {
    const std::string prefix = "M";
    Matrix6d m;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j)
        m(i, j) = m(j, i) = row.number(prefix + std::to_string(i + 1) + std::to_string(j + 1));
    return m;
  }

  const CsvTable vectors_{folder + "vectors.csv"};
  const CsvTable parts_{folder + "jacparts.csv"};
  const CsvTable dynamics_{folder + "dyn.csv"};
  const CsvTable edges_{folder + "tool_edge.csv"};
};

QTEST_APPLESS_MAIN(TestLaparoscopeVectors)
#include "tst_laparoscope_vectors.moc"
