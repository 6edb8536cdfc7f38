// SPDX-License-Identifier: Apache-2.0
// Whether what a graph costs grows with its size, and no faster:
//
//   bench_scale [N...]      components; 100, 1000 and 10,000 by default, in ascending order
//
// For each kind of graph and each size, microseconds and bytes for each component. A column that
// stays the same from line to line grows linearly.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <vector>

#include "components/register.hpp"
#include "framework/graph_json.hpp"
#include "framework/graph_picture.hpp"
#include "framework/scripting/script.hpp"
#include "tests/benchmarks/scale_shapes.hpp"

using namespace trocar;
using namespace trocar::bench;

namespace {

namespace fs = std::filesystem;

double processor_time() {  // [us] of all threads, so that what else the machine does counts little
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

double wall_time() {  // [us]; for what is too short for the above
  return static_cast<double>(monotonic_ns()) * 1e-3;
}

/// The shortest of several times that it took [us].
double best_of(int times, const std::function<void()>& work, double (*now)() = processor_time) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < times; ++i) {
    const double begin = now();
    work();
    best = std::min(best, now() - begin);
  }
  return best;
}

double heap_in_use() {  // [B]
  return static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd);
}

double most_memory() {  // [MB] that was resident so far
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1e-3;
}

/// A file that is gone when it is not needed any more.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name) : path(fs::temp_directory_path() / name) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { fs::remove(path); }
  const fs::path path;
};

class ScriptFile : public TemporaryFile {
 public:
  explicit ScriptFile(const std::string& text) : TemporaryFile("bench_scale.lua") {
    std::ofstream(path) << text;
  }
};

Registry all_types() {
  Registry types;
  register_components(types);
  return types;
}

/// The graph once more, by the functions that scripts and programs call.
void build_again(const Graph& graph, Graph& copy) {
  for (NodeId id = 0; id < graph.size(); ++id) {
    const Graph::Node& node = graph.node(id);
    const std::size_t dot = node.name.rfind('.');
    const std::string scope = dot == std::string::npos ? "" : node.name.substr(0, dot);
    copy.add(node.type == nullptr ? "Constant" : node.type->name,
             dot == std::string::npos ? node.name : node.name.substr(dot + 1), node.where, scope);
  }
  for (const Graph::Link& link : graph.links()) copy.link(link.from, link.to, link.where);
  for (const Graph::Wire& wire : graph.wires()) copy.connect(wire.from, wire.to, wire.where);
}

/// Without timing, without rows: what the graph itself costs. [us]
double time_of_a_tick(const WiredGraph& wired) {
  double total = 0.0;
  for (const RateGroup& group : wired.groups()) {
    Executor executor(group, {.timing = false});
    executor.start();
    Slot slot;
    const auto tick = [&] {
      executor.tick(slot, true);
      ++slot.index;
    };
    tick();
    total += best_of(50, tick, wall_time);
  }
  return total;
}

/// Of the rows of all threads. [us]
double time_of_a_row(const WiredGraph& wired, const std::vector<RowLayout>& layouts) {
  double total = 0.0;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const RateGroup& group = wired.groups()[i];
    const std::vector<std::int64_t> times(group.schedule().size());
    std::vector<std::byte> row(layouts[i].size());
    total += best_of(
        50, [&] { layouts[i].capture({}, times, group.memory(), row); }, wall_time);
  }
  return total;
}

/// One line of the table.
void measure(const ScaleShape& shape, int size, int times) {
  const Registry types = all_types();
  const ScriptFile script(shape.script(size));
  const double empty = heap_in_use();
  SessionOptions options;
  options.clock = ClockKind::simulated;
  options.check_only = true;
  std::unique_ptr<Session> session;
  const double checked = best_of(times, [&] {
    session = std::make_unique<Session>(types, options);
    run_script(*session, script.path.string());
  });
  const Graph& graph = session->graph();
  const double described = heap_in_use();
  const double built = best_of(times, [&] {
    Graph copy(types);
    build_again(graph, copy);
  });
  std::unique_ptr<WiredGraph> wired;
  const double wiring = best_of(times, [&] {
    wired.reset();
    wired = wire(graph, {});
  });
  const double complete = heap_in_use();
  std::vector<RowLayout> layouts;
  const double laid_out = best_of(times, [&] { layouts = layouts_of(*wired); });
  const double schema = best_of(times, [&] {
    for (const RowLayout& layout : layouts) ros2_schema_text(layout.messages());
  });
  const double json = best_of(times, [&] { graph_json(graph, wired.get()); });
  const double picture = best_of(times, [&] { picture_of(graph, *wired); });
  std::size_t components = 0;
  for (const RateGroup& group : wired->groups()) components += group.schedule().size();
  const auto each = [&](double total) { return total / static_cast<double>(components); };
  fmt::print(
      "{:12} {:6} {:7.1f} {:7.1f} {:7.1f} {:7.2f} {:7.1f} {:7.1f} {:8.2f} {:7.1f} {:6.1f} {:8.0f} "
      "{:8.0f} {:7.0f}\n",
      shape.name, components, each(checked - wiring), each(built), each(wiring), each(laid_out),
      each(schema), each(json), each(picture), 1e3 * each(time_of_a_tick(*wired)),
      1e3 * each(time_of_a_row(*wired, layouts)), each(described - empty),
      each(complete - described), most_memory());
}

/// As many numbers, each named in the script, into a log in virtual time.
void measure_record(int numbers, int times) {
  std::string text;
  for (int i = 0; i < numbers; ++i)
    text += fmt::format("trocar.Sine {{ name = \"sine{}\", amplitude = \"1 N\" }}\n", i);
  text += "local wanted = {}\n";
  text += fmt::format("for i = 0, {} do wanted[#wanted + 1] = \"sine\" .. i end\n", numbers - 1);
  const TemporaryFile log("bench_scale.mcap");
  text += fmt::format("trocar.Logger {{ file = \"{}\", signals = wanted }}\n", log.path.string());
  const ScriptFile script(text);
  const Registry types = all_types();
  constexpr int ticks = 1000;
  const auto run_for = [&](double duration) {
    return best_of(times, [&] {
      SessionOptions options;
      options.clock = ClockKind::simulated;
      options.duration = duration;
      Session session(types, options);
      run_script(session, script.path.string());
      session.finish();
      if (!session.sound()) fmt::print("something was lost\n");
    });
  };
  const double begin = run_for(1e-3);
  const double rows = run_for(1e-3 * (ticks + 1)) - begin;
  fmt::print("{:6} numbers: {:8.1f} us each to begin, {:6.1f} ns each in a tick, {:.0f} MB\n",
             numbers, begin / numbers, 1e3 * rows / ticks / numbers, most_memory());
}

/// In a process of its own, so that its memory is its own.
bool apart(const std::function<void()>& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    work();
    std::fflush(stdout);
    _exit(0);
  }
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  if (sizes.empty()) sizes = {100, 1000, 10'000};
  if (std::any_of(sizes.begin(), sizes.end(), [](int size) { return size < 10; })) {
    std::fputs("usage: bench_scale [N...], each at least 10\n", stderr);
    return 2;
  }
  std::sort(sizes.begin(), sizes.end());
  fmt::print(
      "                     ------------------- us for each component --------------------- --- ns "
      "------ ----- bytes ----- MB\n"
      "graph          size  script   graph    wire  layout  schema    json  picture    tick    row "
      " described    wired    peak\n");
  bool done = true;
  for (const ScaleShape& shape : scale_shapes())
    for (const int size : sizes)
      done = apart([&] { measure(shape, size, size > 1000 ? 3 : 7); }) && done;
  for (const int size : sizes) done = apart([&] { measure_record(size, 3); }) && done;
  return done ? 0 : 1;
}
