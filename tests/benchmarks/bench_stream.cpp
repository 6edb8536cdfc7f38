// SPDX-License-Identifier: Apache-2.0
// Whether the live stream keeps up, and whether the loop feels it:
//
//   bench_stream rate [SECONDS [CLIENTS]]       100 numbers at 10 kHz, 60 s to 3 clients by default
//   bench_stream influence [ROUNDS [SECONDS]]   the loop's lateness with no client, one, and ten of
//                                               which five are stopped, in turn
//
// Clients are processes of their own, which take the rows in batches. Exit status of rate: 0 when
// no client missed a row, else 1.
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkRequest>
#include <QUrl>
#include <QWebSocket>
#include <QWebSocketHandshakeOptions>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "framework/run.hpp"
#include "framework/stream/client_message.hpp"
#include "plugins/foxglove/foxglove_service.hpp"
#include "tests/benchmarks/numbers.hpp"

using namespace trocar;
using trocar::bench::Numbers;

namespace {

/// Counts the rows of all batches until the server is gone, and prints rows and gaps.
int be_client(const char* url, int count, char** arguments) {
  QCoreApplication application(count, arguments);
  QWebSocket socket;
  std::uint64_t rows = 0, gaps = 0;
  std::int64_t next = -1;
  QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket, [&](const QString& text) {
    const QJsonObject message = QJsonDocument::fromJson(text.toUtf8()).object();
    for (const QJsonValue& channel : message["channels"].toArray())
      if (channel["topic"] == "/main/batch")
        socket.sendTextMessage(QString::fromStdString(stream::subscribe_text(
            {.subscriptions = {
                 {.id = 1, .channel = static_cast<std::uint32_t>(channel["id"].toInt())}}})));
  });
  QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket,
                   [&](const QByteArray& bytes) {
                     if (bytes[0] != 1) return;
                     std::uint32_t batch = 0;
                     std::int64_t tick = 0;
                     std::memcpy(&batch, bytes.data() + 17, sizeof batch);
                     std::memcpy(&tick, bytes.data() + 25, sizeof tick);
                     if (next >= 0 && tick > next) gaps += static_cast<std::uint64_t>(tick - next);
                     next = tick + batch;
                     rows += batch;
                   });
  QObject::connect(&socket, &QWebSocket::disconnected, &application, &QCoreApplication::quit);
  QWebSocketHandshakeOptions options;
  options.setSubprotocols({"foxglove.sdk.v1"});
  socket.open(QNetworkRequest(QUrl(url)), options);
  QCoreApplication::exec();
  fmt::print("{} {}\n", rows, gaps);
  return 0;
}

struct Client {
  pid_t process = 0;
  int answer = -1;
};

Client start_client(const std::string& url) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  std::string words[] = {self, "--client", url};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  Client client;
  if (posix_spawn(&client.process, self.c_str(), &actions, nullptr, arguments, environ) != 0)
    std::abort();
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  client.answer = ends[0];
  return client;
}

/// Rows and gaps that it counted.
std::pair<long, long> end_client(const Client& client) {
  kill(client.process, SIGCONT);
  std::string text(64, '\0');
  const ssize_t size = read(client.answer, text.data(), text.size());
  close(client.answer);
  waitpid(client.process, nullptr, 0);
  std::istringstream words(text.substr(0, static_cast<std::size_t>(std::max<ssize_t>(size, 0))));
  long rows = 0, gaps = -1;
  words >> rows >> gaps;
  return {rows, gaps};
}

/// [s] of processor that the thread of that name has used.
double processor_time(const std::string& name) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string own, field;
    std::ifstream(entry.path() / "comm") >> own;
    if (own != name) continue;
    std::ifstream stat(entry.path() / "stat");
    double user = 0.0, system = 0.0;
    for (int i = 1; i < 14; ++i) stat >> field;
    stat >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  }
  return 0.0;
}

struct Round {
  RunResult result;
  std::vector<std::pair<long, long>> clients;
  double server = 0.0;  // [s]
};

Round run_round(double seconds, double rate, int clients, int stopped) {
  Registry types;
  types.add<Numbers>("Numbers", "bench", "100 numbers that change");
  Graph graph(types);
  graph.add("Numbers", "numbers", {"bench_stream", 1});
  Round round;
  std::vector<Client> all;
  {
    foxglove::FoxgloveService service(ServiceType::Settings{{"address", "127.0.0.1:0"}});
    for (int i = 0; i < clients; ++i) all.push_back(start_client(service.endpoint().url()));
    RunOptions options;
    options.duration = seconds + 1.0;
    options.wiring.rate = rate;
    options.sinks = {&service.rows()};
    bool asleep = false;
    options.operator_input = [&](RunControl& control) {
      if (!std::exchange(asleep, control.time() > 0.5))
        for (int i = 0; asleep && i < stopped; ++i)
          kill(all[static_cast<std::size_t>(i)].process, SIGSTOP);
      return service.operate(control);
    };
    usleep(500'000);  // the clients connect
    service.prepare({});
    round.result = run(graph, options);
    usleep(300'000);
    round.server = processor_time("foxglove");
  }
  for (const Client& client : all) round.clients.push_back(end_client(client));
  return round;
}

int measure_rate(double seconds, int clients) {
  constexpr double rate = 1e4;
  const Round round = run_round(seconds, rate, clients, 0);
  const LoopStatistics& loop = round.result.main().loop;
  fmt::print("100 numbers at {:g} Hz for {:g} s: {} rows, {} slots skipped\n", rate,
             round.result.duration, loop.rows, loop.skipped);
  bool sound = round.result.missed.empty() && loop.rows_lost == 0;
  for (const auto& [rows, gaps] : round.clients) {
    const long lost = gaps - static_cast<long>(loop.skipped);
    fmt::print("  a client received {} rows, {} of them lost\n", rows, std::max(lost, 0L));
    sound = sound && lost <= 0 && rows > 0;
  }
  for (const ReaderLoss& loss : round.result.missed) fmt::print("  {}\n", loss.text());
  fmt::print("  the server's thread used {:.1f} % of a processor\n",
             100.0 * round.server / round.result.wall_time);
  return sound ? 0 : 1;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

int measure_influence(int rounds, double seconds) {
  constexpr double rate = 1e3;
  struct Case {
    const char* name;
    int clients, stopped;
    std::vector<double> p50{}, p99{};  // ratios to the round without a client
  };
  std::vector<Case> cases = {
      {"no client, again", 0, 0}, {"1 client", 1, 0}, {"10 clients, 5 of them stopped", 10, 5}};
  const auto lateness = [&](int clients, int stopped) {
    const Round round = run_round(seconds, rate, clients, stopped);
    const TimingHistogram& all = round.result.main().loop.lateness;
    return std::pair(static_cast<double>(all.percentile(0.5)),
                     static_cast<double>(all.percentile(0.99)));
  };
  for (int i = 0; i < rounds; ++i) {
    const auto [p50, p99] = lateness(0, 0);
    fmt::print("round {:2}: none {:5.1f} / {:6.1f} µs", i + 1, p50 * 1e-3, p99 * 1e-3);
    for (Case& one : cases) {
      const auto with = lateness(one.clients, one.stopped);
      one.p50.push_back(with.first / p50);
      one.p99.push_back(with.second / p99);
      fmt::print(", {}: {:.2f} / {:.2f}", one.name, one.p50.back(), one.p99.back());
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  fmt::print(
      "\nratios of the loop's lateness to that without a client: median (least to greatest)\n");
  for (const Case& one : cases) {
    const auto [low50, high50] = std::minmax_element(one.p50.begin(), one.p50.end());
    const auto [low99, high99] = std::minmax_element(one.p99.begin(), one.p99.end());
    fmt::print("  {:30} p50 {:.2f} ({:.2f} to {:.2f})   p99 {:.2f} ({:.2f} to {:.2f})\n", one.name,
               median(one.p50), *low50, *high50, median(one.p99), *low99, *high99);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const auto number = [&](int i, double otherwise) {
    return argc > i ? std::atof(argv[i]) : otherwise;
  };
  if (what == "--client" && argc == 3) return be_client(argv[2], argc, argv);
  if (what == "rate") return measure_rate(number(2, 60.0), static_cast<int>(number(3, 3.0)));
  if (what == "influence")
    return measure_influence(static_cast<int>(number(2, 10.0)), number(3, 5.0));
  std::fputs("usage: bench_stream rate [SECONDS [CLIENTS]] | influence [ROUNDS [SECONDS]]\n",
             stderr);
  return 2;
}
