// SPDX-License-Identifier: Apache-2.0
#include <exception>

#include "cli/commands.hpp"
#include "cli/heap_allocations.hpp"
#include "cli/output.hpp"
#include "cli/usage.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace trocar::cli;
  CLI::App app("Runs haptic devices: a real-time dataflow graph wired in Lua.", "trocar");
  int status = success;
  set_up(app);
  add_run(app, status);
  add_check(app, status, heap_allocations);
  add_test(app, status);
  add_graph(app, status);
  add_list(app, status);
  add_describe(app, status);
  add_info(app, status);
  add_devices(app, status);
  add_doctor(app, status);
  add_emulate(app, status);
  add_kinematics(app, status);
  add_watch(app);
  add_workspace(app, status);
  add_bench(app, status);
  add_completion(app, status);
  add_stubs(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trocar::cli;
  ignore_broken_pipes();
  int status = failed;
  try {
    status = run(argc, argv);
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return finish_output(status);
}
