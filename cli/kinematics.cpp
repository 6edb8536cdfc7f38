// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "cli/commands.hpp"
#include "cli/kinematics_rows.hpp"
#include "cli/output.hpp"
#include "cli/text_table.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

int answer(const KinematicsQuestion& question) {
  if (::isatty(STDIN_FILENO) != 0)
    std::cerr << fmt::format(
        "Reading CSV from the terminal: a header with {}, then a row a line; "
        "Ctrl-D ends.\n",
        join(question.given, ", "));
  std::size_t rows = 0;
  try {
    KinematicsTable table(question, std::cin);
    print(table.header());
    for (std::string line; output_open() && table.next(line); ++rows) print(line);
  } catch (const CsvError& error) {
    complain(fmt::format("kinematics {}: {}{}", question.name, error.what(),
                         rows == 0 ? "" : " (answered before it: " + counted(rows, "row") + ")"));
    return misused;
  }
  return success;
}

std::string example(const std::string& question) {
  if (question == "ik")
    return "  printf 'xe,ye,ze,alpha,beta,theta\\n0,0,0.105,0,0,0\\n' | trocar kinematics ik\n";
  if (question == "dynamics")
    return "  { echo q1,q2,q3,phi1,phi2,phi3,qd1,qd2,qd3,qd4,qd5,qd6,u1\n"
           "    echo -.25,-.25,-.25,0,2.0944,4.1888,0,0,0,0,0,0,5\n"
           "  } | trocar kinematics dynamics\n";
  return "  printf 'q1,q2,q3,phi1,phi2,phi3\\n-.25,-.25,-.25,0,2.0944,4.1888\\n' |\n"
         "    trocar kinematics " +
         question + "\n";
}

/// What a row may bring beside the question's columns.
std::string own_columns(KinematicsOwn own) {
  std::string text = "(l zt r Rb Rp L)";
  if (own == KinematicsOwn::geometry) return text;
  text +=
      ", masses (m_sl m_lk m_pl m_tool\n"
      "s_tool m_ee m_pin) and gravity in N (gx gy gz)";
  if (own == KinematicsOwn::weight) return text;
  return text +
         ", inertias (I_tt I_ta I_ee\n"
         "I_ring_eff), efforts of the actuators (u1 to u6) and a wrench on the tool,\n"
         "its moment about E (F1 to F6). M qdd + c + taug = u + tau, with tau = J^T F";
}

std::string results_of(const KinematicsQuestion& question) {
  if (question.own == KinematicsOwn::motion)
    return "M11 M12 to M66 (upper triangle), c1 to c6, taug1 to taug6,\n"
           "        tau1 to tau6, qdd1 to qdd6";
  return question.results.front() + " to " + question.results.back();
}

std::string footer(const KinematicsQuestion& question) {
  return fmt::format(
      "Input:  {}\n"
      "Output: id, {}, error, limits\n\n"
      "All in SI units: m, rad, kg, N, N m, J; matrices row by row. Without a column id\n"
      "the rows are numbered from 1. Further columns are ignored, but a row may bring a\n"
      "geometry of its own {}.\n"
      "Where such a field is missing or empty, the default holds.\n"
      "What cannot be assembled gives nan and the reason in error; limits names the\n"
      "limits of the device that a row violates, separated by semicolons.\n\n"
      "Example:\n{}",
      join(question.given, ", "), results_of(question), own_columns(question.own),
      example(question.name));
}

}  // namespace

void add_kinematics(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("kinematics", "Kinematics of the laparoscope for tables: CSV in, CSV out");
  command->require_subcommand(1);
  command->footer("Example:\n  trocar kinematics fk < positions.csv > poses.csv");
  for (const KinematicsQuestion& question : kinematics_questions()) {
    CLI::App* sub = command->add_subcommand(question.name, question.doc);
    sub->footer(footer(question));
    sub->callback([&question, &status] { status = answer(question); });
  }
}

}  // namespace trocar::cli
