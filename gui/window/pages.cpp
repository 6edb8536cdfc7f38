// SPDX-License-Identifier: Apache-2.0
#include "gui/window/pages.hpp"

#include "gui/pages/alarms_page.hpp"
#include "gui/pages/device_page.hpp"
#include "gui/pages/graph_page.hpp"
#include "gui/pages/operate_page.hpp"
#include "gui/pages/parameters_page.hpp"
#include "gui/pages/plots_page.hpp"
#include "gui/pages/scripts_page.hpp"
#include "gui/pages/timing_page.hpp"

namespace trocar::gui {

void add_pages(MainWindow& window, Operator& operators) {
  window.add_page(new OperatePage(operators));
  window.add_page(new PlotsPage(operators));
  window.add_page(new ParametersPage(operators));
  window.add_page(new AlarmsPage(operators));
  window.add_page(new ScriptsPage(operators));
  window.add_page(new DevicePage(operators));
  window.add_page(new GraphPage(operators));
  window.add_page(new TimingPage(operators));
}

}  // namespace trocar::gui
