// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <istream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/csv.hpp"
#include "components/kinematics/laparoscope_geometry.hpp"
#include "components/kinematics/matrices.hpp"

namespace trocar::cli {

/// What the row of a table of poses is about.
struct KinematicsRow {
  Vector6d given;     // q, or the pose coordinates (xe, ye, ze, alpha, beta, theta)
  Vector6d velocity;  // q'
  LaparoscopeGeometry geometry;
  LaparoscopeMasses masses;
  Eigen::Vector3d gravity;  // [m/s^2]
  Vector6d effort;          // of the actuators [N, N m]
  Vector6d wrench;          // on the tool: (force; moment about E) [N, N m]
};

/// What was computed of a row.
struct KinematicsResult {
  std::vector<double> values;  // as many as the question has results; all NaN with an error
  std::string error;           // why it cannot be assembled
  std::string limits;          // violated, separated by ';'
};

/// Which columns of its own, beside those of the question, a row may bring.
enum class KinematicsOwn {
  geometry,
  weight,  // also masses and gravity
  motion   // also inertias, efforts and a wrench
};

/// One of the questions that `trocar kinematics` answers row by row.
struct KinematicsQuestion {
  std::string name;                  // "fk"
  std::string doc;                   // one line
  std::vector<std::string> given;    // columns that the input must have: six, or twelve with q'
  std::vector<std::string> results;  // columns of the output
  KinematicsOwn own = KinematicsOwn::geometry;
  KinematicsResult (*answer)(const KinematicsRow& row) = nullptr;  // may throw invalid_argument
};

/// fk, ik, jacobian, gravity and dynamics.
std::span<const KinematicsQuestion> kinematics_questions();

/// Answers `question` for each row of a CSV text. Columns are named as in
/// tests/data/laparoscope/README.md; those not needed are ignored. A row may bring geometry,
/// masses, gravity and loads of its own: where such a column is missing, or its field is empty, the
/// default holds. Without a column `id` the rows are numbered from 1.
class KinematicsTable {
 public:
  /// @throw CsvError when the header is wrong.
  KinematicsTable(const KinematicsQuestion& question, std::istream& input);

  std::string header() const;
  /// Moves to the next row and answers it as a line of CSV; false behind the last row.
  /// @throw CsvError with line and column for a row that cannot be read.
  bool next(std::string& line);
  std::size_t rows() const { return rows_; }  // answered so far

 private:
  void find_columns();
  KinematicsRow read() const;

  const KinematicsQuestion& question_;
  CsvReader csv_;
  std::vector<std::size_t> given_;
  std::size_t rows_ = 0;
};

}  // namespace trocar::cli
