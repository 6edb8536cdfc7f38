// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>

#include "ball.hpp"
#include "components/register.hpp"
#include "framework/report.hpp"
#include "framework/scripting/script.hpp"

int main(int argc, char** argv) {
  using namespace trocar;
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s SCRIPT\n", argv[0]);
    return 2;
  }
  Registry registry;
  register_components(registry);
  registry.add<lab::Ball>("Ball", "fixtures", "A ball that pushes out what enters it");
  Session session(registry, {.clock = ClockKind::simulated, .duration = 3.0});
  try {
    run_script(session, argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  session.finish();
  std::fputs(report_text(session).c_str(), stdout);
  return session.sound() ? 0 : 1;
}
