// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/declare_number.hpp"
#include "components/devices/report_channel.hpp"

namespace trocar {

/// The way between the simulated device and the host as parameters.
struct LinkParameters {
  explicit LinkParameters(ParameterSet* set) : owner(set) {}
  /// @param period [s] of the reports
  /// @throw std::invalid_argument for a jitter longer than that.
  ReportSettings reports(double period) const;

  ParameterSet* owner;
  Parameter<double> delay =
      number("delay", "", "1", "0", "2", "[ticks] until a command acts, parts of a tick included");
  Parameter<double> report_jitter = number("report_jitter", "s", "0 ms", "0 ms", "10 ms",
                                           "by which a position may be sampled before its tick");
  Parameter<double> report_loss =
      number("report_loss", "%", "0 %", "0 %", "50 %", "of the reports, never to arrive");
  Parameter<double> report_loss_run =
      number("report_loss_run", "", "1", "1", "1000", "mean number of reports lost in a row");
  Parameter<double> report_stale = number("report_stale", "s", "5 ms", "0.1 ms", "1 s",
                                          "age beyond which a position is not trusted any more");

 private:
  Parameter<double> number(const char* name, const char* unit, const char* initial, const char* min,
                           const char* max, const char* doc) {
    return declare_number(owner, name, {unit, initial, min, max, doc});
  }
};

}  // namespace trocar
