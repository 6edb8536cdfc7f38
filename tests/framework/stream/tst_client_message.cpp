// SPDX-License-Identifier: Apache-2.0
// What clients say: read as they mean it, or refused with the reason.
#include "framework/stream/client_message.hpp"

#include <QTest>

using namespace trocar::stream;

namespace {

std::span<const std::byte> bytes_of(const QByteArray& bytes) {
  return {reinterpret_cast<const std::byte*>(bytes.data()), static_cast<std::size_t>(bytes.size())};
}

}  // namespace

class TestClientMessage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_a_client_writes_is_read() {
    const auto subscribe = std::get<Subscribe>(parse_client_text(
        subscribe_text({.subscriptions = {{.id = 3, .channel = 7}, {.id = 4, .channel = 8}}})));
    QCOMPARE(subscribe.subscriptions.size(), std::size_t{2});
    QCOMPARE(subscribe.subscriptions[1].id, 4u);
    QCOMPARE(subscribe.subscriptions[1].channel, 8u);
    QCOMPARE(std::get<Unsubscribe>(parse_client_text(unsubscribe_text({.ids = {5, 6}}))).ids,
             (std::vector<std::uint32_t>{5, 6}));
    const auto get = std::get<GetParameters>(
        parse_client_text(get_parameters_text({.names = {"wall.stiffness"}, .id = "a"})));
    QCOMPARE(get.names, std::vector<std::string>{"wall.stiffness"});
    QCOMPARE(get.id, "a");
    const auto set = std::get<SetParameters>(parse_client_text(set_parameters_text(
        {.values =
             {{"a", 1.5}, {"b", true}, {"c", std::string("2 N/mm")}, {"d", std::vector{1.0, 2.0}}},
         .id = "x"})));
    QCOMPARE(set.values.size(), std::size_t{4});
    QCOMPARE(std::get<double>(set.values[0].value), 1.5);
    QCOMPARE(std::get<bool>(set.values[1].value), true);
    QCOMPARE(std::get<std::string>(set.values[2].value), "2 N/mm");
    QCOMPARE(std::get<std::vector<double>>(set.values[3].value), (std::vector{1.0, 2.0}));
    for (const bool on : {true, false}) {
      QCOMPARE(std::get<WatchParameters>(
                   parse_client_text(watch_parameters_text({.names = {"a"}, .on = on})))
                   .on,
               on);
      QCOMPARE(std::get<WatchGraph>(parse_client_text(watch_graph_text({on}))).on, on);
    }
    const auto call = std::get<CallService>(parse_client_bytes(
        call_bytes({.service = 2, .call = 9, .encoding = "json", .payload = "{\"on\":true}"})));
    QCOMPARE(call.service, 2u);
    QCOMPARE(call.call, 9u);
    QCOMPARE(call.encoding, "json");
    QCOMPARE(call.payload, "{\"on\":true}");
  }

  void what_is_not_offered_is_named() {
    for (const char* op : {"advertise", "unadvertise", "fetchAsset"})
      QCOMPARE(
          std::get<NotOffered>(parse_client_text(QString("{\"op\":\"%1\"}").arg(op).toStdString()))
              .op,
          op);
    QCOMPARE(std::get<NotOffered>(parse_client_bytes(bytes_of(QByteArray("\1\0\0\0\0", 5)))).op,
             "message data");
  }

  void what_is_wrong_is_said_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("why");
    const auto row = [](const char* name, const QByteArray& text, const char* why) {
      QTest::newRow(name) << text << QString(why);
    };
    row("nothing", "", "not JSON");
    row("half", "{\"op\":\"subscr", "not JSON");
    row("no object", "[1]", "a JSON object");
    row("no op", "{}", "\"op\" is missing");
    row("op of a number", "{\"op\":1}", "\"op\" needs a text");
    row("unknown op", "{\"op\":\"dance\"}", "\"op\" = \"dance\" is not known");
    row("no list", "{\"op\":\"subscribe\",\"subscriptions\":3}", "\"subscriptions\" needs a list");
    row("no objects", "{\"op\":\"subscribe\",\"subscriptions\":[3]}", "a list of objects");
    row("negative", "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":-1,\"channelId\":1}]}",
        "\"id\" needs a whole number");
    row("too large", "{\"op\":\"unsubscribe\",\"subscriptionIds\":[4294967296]}", "32 bits");
    row("names", "{\"op\":\"getParameters\",\"parameterNames\":[1]}", "needs a text");
    row("no value", "{\"op\":\"setParameters\",\"parameters\":[{\"name\":\"a\"}]}",
        "\"value\" is missing");
    row("table", "{\"op\":\"setParameters\",\"parameters\":[{\"name\":\"a\",\"value\":{}}]}",
        "\"value\" needs a number");
    row("mixed", "{\"op\":\"setParameters\",\"parameters\":[{\"name\":\"a\",\"value\":[1,\"b\"]}]}",
        "not of numbers");
    row("deep", QByteArray(100'000, '['), "not JSON");
  }
  void what_is_wrong_is_said() {
    QFETCH(QByteArray, text);
    QFETCH(QString, why);
    QString said;
    try {
      parse_client_text(text.toStdString());
    } catch (const std::invalid_argument& error) {
      said = error.what();
    }
    QVERIFY2(said.contains(why), qPrintable(said));
  }

  void calls_that_are_cut_short_are_refused() {
    const std::vector<std::byte> whole =
        call_bytes({.service = 2, .call = 9, .encoding = "json", .payload = ""});
    for (std::size_t size = 0; size < whole.size(); ++size) {
      bool refused = false;
      try {
        parse_client_bytes(std::span(whole).first(size));
      } catch (const std::invalid_argument&) {
        refused = true;
      }
      QVERIFY2(refused, qPrintable(QString::number(size)));
    }
  }
};

QTEST_GUILESS_MAIN(TestClientMessage)
#include "tst_client_message.moc"
