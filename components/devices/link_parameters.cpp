// SPDX-License-Identifier: Apache-2.0
#include "components/devices/link_parameters.hpp"

#include <stdexcept>

namespace trocar {

ReportSettings LinkParameters::reports(double period) const {
  if (*report_jitter > period)
    throw std::invalid_argument("report_jitter = " + report_jitter.text() + ": at most a tick, " +
                                format_quantity(period, parse_unit("ms")) +
                                " here; reports that come later are lost, see report_loss");
  return {.jitter = *report_jitter / period, .loss = *report_loss, .loss_run = *report_loss_run};
}

}  // namespace trocar
