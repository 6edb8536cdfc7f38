// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/foxglove_service.hpp"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <stdexcept>

#include "framework/text.hpp"
#include "framework/time_source.hpp"
#include "plugins/foxglove/server.hpp"

namespace trocar::foxglove {
namespace {

constexpr std::int64_t look_interval_ns = 5'000'000;

void rest() {
  MonotonicTime().sleep_until(monotonic_ns() + look_interval_ns);
}

/// Qt's event loop needs an application; where the program has none, this thread makes it.
class Application {
 public:
  Application() {
    if (QCoreApplication::instance() == nullptr) own_.emplace(count_, arguments_);
  }

 private:
  int count_ = 1;
  char name_[7] = "trocar";
  char* arguments_[2] = {name_, nullptr};
  std::optional<QCoreApplication> own_;
};

}  // namespace

FoxgloveService::FoxgloveService(const ServiceType::Settings& settings) {
  for (const auto& [key, value] : settings)
    if (key == "address")
      endpoint_ = parse_endpoint(value);
    else if (key == "token")
      token_ = value;
    else if (key == "wait")
      wait_ = value == "true";
    else
      throw std::invalid_argument(fmt::format("foxglove has no setting \"{}\"{}", key,
                                              suggestion(key, {"address", "token", "wait"})));
  if (token_.empty()) token_ = random_token();
  thread_.emplace("foxglove", [this](const StopFlag& stop) { serve(stop); });
  std::optional<Listening> listening;
  while (!(listening = listening_.take())) rest();
  if (!listening->trouble.empty()) throw std::runtime_error(listening->trouble);
  endpoint_ = listening->endpoint;
}

FoxgloveService::~FoxgloveService() = default;

void FoxgloveService::serve(const StopFlag& stop) {
  const Application application;
  QEventLoop loop;  // first: it makes what timers and sockets of this thread need
  Server server(tap_, desk_, calls_, recording_, token_);
  try {
    listening_.put({server.listen(endpoint_), ""});
  } catch (const std::exception& error) {
    listening_.put({endpoint_, error.what()});
    return;
  }
  QTimer end;
  QObject::connect(&end, &QTimer::timeout, &end, [&] {
    if (stop.raised()) loop.quit();
  });
  end.start(std::chrono::milliseconds(20));
  loop.exec();
  server.poll();  // what a run left behind
  QCoreApplication::processEvents();
}

std::string FoxgloveService::greeting() const {
  std::string text = fmt::format("serving {}", endpoint_.url());
  if (!endpoint_.loopback())
    text += fmt::format(
        "\n  anybody who reaches it may look, and stop; to change anything, add ?token={}", token_);
  else
    text += fmt::format("  (pages of a browser change things with ?token={})", token_);
  if (wait_) text += "\n  waiting for a client to call start";
  return text;
}

void FoxgloveService::prepare(const ServiceRun& run) {
  tap_.prepare(run);
  calls_.set_graph(run.graph);
  while (wait_ && !calls_.started() && (run.stop == nullptr || !run.stop->raised())) rest();
}

ServiceType foxglove_service() {
  return {"foxglove", "Live stream for dashboards: Foxglove, Lichtblick, PlotJuggler",
          [](const ServiceType::Settings& settings) {
            return std::make_unique<FoxgloveService>(settings);
          }};
}

}  // namespace trocar::foxglove
