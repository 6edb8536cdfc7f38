// SPDX-License-Identifier: Apache-2.0
// Laws that mean harm: tests/data/hostile. Each ends with a fault that says why, within its limits;
// nobody else's tick is touched, and no file is.
#include <QDir>

#include "framework/clock.hpp"
#include "framework/scripting/lua_law.hpp"
#include "tests/support/law_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

const QDir folder(TROCAR_SOURCE_DIR "/tests/data/hostile");

QByteArray text_of(const QString& name) {
  QFile file(folder.filePath(name));
  return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

/// What its first line expects: texts, one of which is said.
QStringList expected(const QByteArray& text) {
  return QString::fromUtf8(text).section('\n', 0, 0).section("expect: ", 1).split('|');
}

/// A law alone, with memory for its ports.
struct Alone {
  Alone(const lua::LawFile& file, const lua::LoopLimits& limits)
      : law(file, limits, 1,
            {.inputs = {bytes(input), bytes(input)},
             .outputs = {bytes(output)},
             .parameters = {}}) {}
  static std::byte* bytes(Vector3& vector) { return reinterpret_cast<std::byte*>(&vector); }
  Vector3 input;
  Vector3 output;
  lua::LuaLaw law;
};

}  // namespace

class TestHostileLaws : public QObject {
  Q_OBJECT

  static void rows() {
    QTest::addColumn<QString>("name");
    for (const QString& name : folder.entryList({"*.lua"})) QTest::newRow(qPrintable(name)) << name;
  }

 private Q_SLOTS:
  void there_are_many() { QVERIFY(folder.entryList({"*.lua"}).size() >= 40); }

  void the_fault_is_named_and_the_others_go_on_data() { rows(); }
  void the_fault_is_named_and_the_others_go_on() {
    QFETCH(QString, name);
    const QByteArray law = text_of(name);
    const LawOutcome outcome =
        run_law(law,
                law_scene +
                    "trocar.LuaFixture { file = \"law.lua\", at = laparoscope.tip }\n"
                    "local run = trocar.run { duration = \"0.4 s\" }\n"
                    "assert(math.abs(run:at(sine.value, \"0.35 s\") + 1) < 1e-6)\n",
                {}, {.duration = 0.4});
    QCOMPARE(outcome.said.size(), 1);
    const QString said = outcome.said.front();
    QVERIFY2(said.startsWith("law.lua:"), qPrintable(said));
    const QStringList any = expected(law);
    QVERIFY2(
        std::any_of(any.begin(), any.end(), [&](const QString& e) { return said.contains(e); }),
        qPrintable(said));
    QCOMPARE(outcome.run().threads.front().loop.ticks, 400);
    QCOMPARE(outcome.run().faults.front().component, std::string("law"));
    QVERIFY(!QFile::exists("hostile"));
  }

  /// In real time: the shortest of some, since what else the machine does only ever adds.
  void it_ends_within_its_deadline_and_2_ms_data() { rows(); }
  void it_ends_within_its_deadline_and_2_ms() {
    QFETCH(QString, name);
    constexpr std::int64_t deadline_ns = 200'000;
    Findings findings;
    const auto file = lua::read_law(lua::LawKind::fixture, "law.lua", "law.lua",
                                    text_of(name).toStdString(), findings);
    QVERIFY(file);
    std::int64_t shortest = std::numeric_limits<std::int64_t>::max();
    for (int i = 0; i < 7; ++i) {
      // Time alone ends it here: instructions are not the limit.
      Alone alone(*file, {.instructions = 1'000'000'000, .deadline_ns = deadline_ns});
      std::int64_t longest = 0;
      for (int tick = 0; tick < 400; ++tick) {
        const std::int64_t begin = monotonic_ns();
        const bool right = alone.law.step({tick, tick * 1'000'000, tick * 1e-3, 1e-3});
        longest = std::max(longest, monotonic_ns() - begin);
        if (!right) break;
        alone.law.use_slack();
      }
      shortest = std::min(shortest, longest);
    }
    qInfo("%s: %.2f ms", qPrintable(name), static_cast<double>(shortest) * 1e-6);
    QVERIFY2(shortest < deadline_ns + 2'000'000, qPrintable(QString::number(shortest)));
  }
};

QTEST_GUILESS_MAIN(TestHostileLaws)
#include "tst_hostile_laws.moc"
