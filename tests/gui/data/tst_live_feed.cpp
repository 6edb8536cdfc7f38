// SPDX-License-Identifier: Apache-2.0
// What a client of the dashboard's own makes of a stream, over real sockets.
#include "gui/data/live_feed.hpp"

#include <QSignalSpy>
#include <cmath>

#include "tests/support/stream_rig.hpp"

using namespace trocar;
using trocar::test::StreamRig;

namespace {

struct Looker {
  explicit Looker(const StreamRig& rig) { client.open(QUrl(rig.url())); }
  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 10'000); }
  bool has_rows(std::uint64_t count) {
    return wait([&] { return !store.tracks().empty() && store.tracks()[0]->end() == count; });
  }

  gui::StreamClient client;
  gui::DataStore store;
  gui::LiveFeed feed{client, store};
};

}  // namespace

class TestLiveFeed : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void every_row_is_in_the_store() {
    StreamRig rig;
    Looker looker(rig);
    QVERIFY(looker.wait([&] { return looker.feed.state().clients == 1; }));
    rig.begin();
    QVERIFY(looker.wait([&] { return looker.feed.state().running; }));
    rig.feed(0, 3000);
    rig.end();
    QVERIFY(looker.has_rows(3000));
    const gui::Track& track = *looker.store.track("main");
    QCOMPARE(track.missing(), std::uint64_t{0});
    QCOMPARE(track.tick(2999), 2999);
    QCOMPARE(track.time(1500), 1.5);
    QCOMPARE(track.at(1.4995), std::uint64_t{1500});
    for (const RowSignal& signal : rig.layouts.front().signals()) {
      const auto found = looker.store.find(signal.name);
      QVERIFY2(found, signal.name.c_str());
      QCOMPARE(found->info().unit, signal.unit.symbol);
      if (signal.scalar != Scalar::real) continue;
      const std::vector<std::byte> row = rig.row(1234);
      double value;
      std::memcpy(&value, row.data() + signal.row_offset, sizeof value);
      QCOMPARE(found->column()[1234], value);
    }
  }

  void what_is_behind_the_views_end_is_not_shown() {
    StreamRig rig;
    Looker looker(rig);
    rig.begin();
    QVERIFY(looker.wait([&] { return looker.feed.state().running; }));
    rig.feed(0, 3000);
    rig.end();
    QVERIFY(looker.has_rows(3000));
    const gui::SignalRef tick = *looker.store.find("tick");
    for (const double time : {0.0, 1.2, 1.2004, 2.999, 9.0}) {
      looker.store.set_view_end(time);
      QCOMPARE(looker.store.now(), time);
      QCOMPARE(tick.last(), std::min(std::floor(time * 1e3 + 1e-6), 2999.0));
      QCOMPARE(tick.track->view_end(), static_cast<std::uint64_t>(tick.last()) + 1);
    }
    looker.store.set_view_end(-1.0);
    QVERIFY(std::isnan(tick.last()));
    QCOMPARE(looker.store.events_shown(), std::size_t{0});
    looker.store.set_view_end(std::nullopt);
    QCOMPARE(looker.store.now(), 2.999);
    QCOMPARE(tick.last(), 2999.0);
  }

  void another_run_is_another_store() {
    StreamRig rig;
    Looker looker(rig);
    QSignalSpy runs(&looker.store, &gui::DataStore::run_began);
    rig.begin();
    QVERIFY(looker.wait([&] { return looker.feed.state().running; }));
    rig.feed(0, 100);
    rig.end();
    QVERIFY(looker.has_rows(100));
    rig.begin();
    QVERIFY(looker.wait([&] { return runs.size() == 2; }));
    QVERIFY(looker.wait([&] { return looker.feed.state().run == 2; }));
    rig.feed(0, 50);
    rig.end();
    QVERIFY(looker.has_rows(50));
  }

  void events_are_told_and_calls_are_answered() {
    StreamRig rig;
    Looker looker(rig);
    rig.run();
    QVERIFY(looker.wait([&] { return looker.client.offers("annotate"); }));
    QVERIFY(looker.wait([&] { return looker.feed.parameters().is_array(); }));
    bool answered = false;
    looker.client.call(
        "annotate", {{"text", "a remark"}},
        [&](const nlohmann::json&, const std::string& trouble) { answered = trouble.empty(); });
    QVERIFY(looker.wait([&] { return answered; }));
    QVERIFY(looker.wait([&] {
      const auto& events = looker.store.events();
      return std::any_of(events.begin(), events.end(), [](const gui::RunEvent& event) {
        return event.kind == "annotated" && event.detail == "a remark";
      });
    }));
    std::string trouble;
    looker.client.call("annotate", nlohmann::json::object(),
                       [&](const nlohmann::json&, const std::string& why) { trouble = why; });
    QVERIFY(looker.wait([&] { return !trouble.empty(); }));
    QVERIFY(trouble.find("\"text\" is missing") != std::string::npos);
    looker.client.call("end");
    QVERIFY(looker.wait([&] { return !looker.feed.state().running; }));
  }

  void a_broken_connection_is_made_anew() {
    gui::StreamClient client;
    quint16 port = 0;
    {
      StreamRig rig;
      port = static_cast<quint16>(QUrl(rig.url()).port());
      client.open(QUrl(rig.url()));
      QVERIFY(QTest::qWaitFor([&] { return client.state() == gui::LinkState::open; }, 10'000));
      QVERIFY(QTest::qWaitFor([&] { return client.round_trip_ms() >= 0; }, 10'000));
    }
    QVERIFY(QTest::qWaitFor([&] { return client.state() == gui::LinkState::connecting; }, 10'000));
    QVERIFY(!client.why().empty());
    std::string trouble;
    client.call("stop", {}, [&](const nlohmann::json&, const std::string& why) { trouble = why; });
    QCOMPARE(trouble, std::string("there is no connection"));
    StreamRig rig({{"address", "127.0.0.1:" + std::to_string(port)}});
    QVERIFY(QTest::qWaitFor([&] { return client.state() == gui::LinkState::open; }, 10'000));
  }
};

QTEST_GUILESS_MAIN(TestLiveFeed)
#include "tst_live_feed.moc"
