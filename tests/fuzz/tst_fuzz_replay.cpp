// SPDX-License-Identifier: Apache-2.0
// The kept inputs of scripts/dev/fuzz, and fixed mutations of them, without libFuzzer.
#include <QDir>
#include <QTest>
#include <random>
#include <vector>

#include "components/devices/hid/state_report.hpp"
#include "tests/fuzz/hid_reports.hpp"
#include "tests/fuzz/stream_messages.hpp"

using namespace trocar::test;

namespace {

using Input = std::vector<std::uint8_t>;

std::vector<Input> kept(const QStringList& names = {QStringLiteral("*")},
                        const QString& target = QStringLiteral("hid_reports")) {
  std::vector<Input> inputs;
  const QDir folder(QStringLiteral(TROCAR_SOURCE_DIR "/tests/data/fuzz/") + target);
  for (const QString& name : folder.entryList(names, QDir::Files, QDir::Name)) {
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QByteArray bytes = file.readAll();
    inputs.emplace_back(bytes.begin(), bytes.end());
  }
  return inputs;
}

}  // namespace

class TestFuzzReplay : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_kept_inputs_hold_every_promise_and_reach_every_state() {
    FuzzReach all;
    for (const Input& input : kept()) {
      const FuzzReach reach = feed_hid_reports(input);
      all.states += reach.states;
      all.pages += reach.pages;
      all.commands += reach.commands;
      all.refused_reports += reach.refused_reports;
      all.refused_commands += reach.refused_commands;
      all.device_states |= reach.device_states;
    }
    QVERIFY(all.states > 0);
    QVERIFY(all.pages > 0);
    QVERIFY(all.commands > 0);
    QVERIFY(all.refused_reports > 0);
    QVERIFY(all.refused_commands > 0);
    QCOMPARE(all.device_states, 0x1Fu);
  }

  void messages_of_stream_clients_hold_every_promise() {
    std::vector<Input> seeds = kept({QStringLiteral("seed_*")}, QStringLiteral("stream_messages"));
    QVERIFY(seeds.size() >= 10);
    for (const Input& seed : seeds) QVERIFY(feed_stream_message(seed));
    std::mt19937 random(7);
    int taken = 0, refused = 0;
    for (int i = 0; i < 50'000; ++i) {
      Input input = seeds[random() % seeds.size()];
      for (auto k = 1 + random() % 3; k > 0; --k)
        input[random() % input.size()] = static_cast<std::uint8_t>(random());
      input.resize(input.size() - random() % 2 * (random() % input.size()));
      ++(feed_stream_message(input) ? taken : refused);
    }
    QVERIFY(taken > 1000 && refused > 1000);
  }

  void so_do_mutations_of_the_seeds() {
    const std::vector<Input> seeds = kept({QStringLiteral("seed_*")});
    QVERIFY(seeds.size() >= 8);
    std::mt19937 random(20);
    for (int i = 0; i < 20'000; ++i) {
      Input input = seeds[random() % seeds.size()];
      for (auto k = random() % 6; k > 0; --k)
        input[random() % input.size()] = static_cast<std::uint8_t>(random());
      if (random() % 4 == 0) input.resize(random() % input.size());
      feed_hid_reports(input);
    }
  }
};

QTEST_APPLESS_MAIN(TestFuzzReplay)
#include "tst_fuzz_replay.moc"
