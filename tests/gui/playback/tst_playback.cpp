// SPDX-License-Identifier: Apache-2.0
// A log in the store as a live run would be, and what plays it.
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <algorithm>
#include <cmath>

#include "gui/app/replay.hpp"
#include "tests/gui/pictures.hpp"
#include "tests/support/script_bench.hpp"

using namespace trocar;
using namespace trocar::gui;

namespace {

constexpr double seconds = 3.0;  // of the recorded run, at 1 kHz

/// A store with a log in it, and its clock.
struct Player {
  explicit Player(LogFeed::Limits limits = {}) : feed(store, limits), clock(store, feed) {}

  bool load(const QString& path) {
    feed.open(path.toStdString());
    return wait();
  }
  bool wait() {
    return QTest::qWaitFor([this] { return feed.state() == LogFeed::State::loaded; }, 20'000);
  }
  std::uint64_t rows() const { return store.tracks().front()->end(); }

  DataStore store;
  LogFeed feed;
  PlaybackClock clock;
};

RunEvent event_at(double time, const char* kind) {
  return {.tick = std::llround(1e3 * time),
          .time = time,
          .thread = "main",
          .kind = kind,
          .source = "device",
          .detail = "a detail",
          .value = 0.0,
          .limit = 0.0};
}

}  // namespace

class TestPlayback : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  QString log_ = folder_.filePath("wall.mcap");

  QByteArray bytes() const {
    QFile file(log_);
    return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
  }
  QString written(const QByteArray& bytes) const {
    QFile file(folder_.filePath("other.mcap"));
    return file.open(QFile::WriteOnly) && file.write(bytes) == bytes.size() ? file.fileName()
                                                                            : QString();
  }

 private Q_SLOTS:
  void initTestCase() {
    const auto outcome =
        test::run_script_file(TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua", {},
                              {.duration = seconds, .record = log_.toStdString()});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
  }

  void the_store_has_every_row_of_the_log() {
    Player player;
    QVERIFY(player.load(log_));
    QCOMPARE(player.rows(), std::uint64_t{3000});
    QCOMPARE(player.feed.summary(), std::string("3.0 s"));
    QCOMPARE(player.feed.problem(), std::string());
    QVERIFY(!player.feed.is_part());
    QCOMPARE(player.feed.whole().to, 2.999);
    const McapReader reader(log_.toStdString());
    const McapChannel& channel = *reader.channel("/main");
    const McapSchema& schema = reader.schemas().at(channel.schema_id);
    const Ros2Decoder decoder(schema.name, schema.data);
    const SignalRef signal = *player.store.find("wall.force.z");
    std::uint64_t row = 0, same = 0;
    reader.messages([&](const McapMessage& message) {
      if (message.channel != channel.id) return;
      same += as_double(decoder.value(message.payload, *decoder.find("wall.force.z"))) ==
              signal.column()[row++];
    });
    QCOMPARE(same, std::uint64_t{3000});
    QVERIFY(player.feed.graph()["nodes"].is_array());
    QCOMPARE(player.store.events().front().kind, std::string("started"));
    QCOMPARE(player.store.events().back().kind, std::string("ended"));
  }

  void a_log_is_loaded_in_slices() {
    constexpr std::size_t slice = 100, chunk = 520;  // rows: a chunk is of half a second
    Player player({.slice = slice});
    std::uint64_t before = 0, most = 0;
    int slices = 0;
    bool alive = false;  // others have their turn in between
    connect(&player.feed, &LogFeed::advanced, &player.feed, [&] {
      most = std::max(most, player.rows() - before);
      before = player.rows();
      ++slices;
    });
    player.feed.open(log_.toStdString());
    QCOMPARE(player.rows(), std::uint64_t{0});
    QTimer::singleShot(0, &player.feed,
                       [&] { alive = player.feed.state() == LogFeed::State::loading; });
    double progress = -1.0;
    QVERIFY(QTest::qWaitFor(
        [&] {
          const bool grows = player.feed.progress() >= progress;
          progress = player.feed.progress();
          return grows && player.feed.state() == LogFeed::State::loaded;
        },
        20'000));
    QVERIFY(alive);
    QCOMPARE(progress, 1.0);
    QVERIFY2(most <= slice + chunk, qPrintable(QString::number(most)));
    QVERIFY(slices >= 6);
    QCOMPARE(player.rows(), std::uint64_t{3000});
  }

  void loading_is_cancelled() {
    Player player({.slice = 100});
    player.feed.open(log_.toStdString());
    QVERIFY(QTest::qWaitFor([&] { return player.rows() > 0; }, 20'000));
    player.feed.cancel();
    const std::uint64_t rows = player.rows();
    QVERIFY(rows < 3000);
    QCoreApplication::processEvents();
    QCOMPARE(player.rows(), rows);
    QVERIFY(player.feed.summary().ends_with("loading was cancelled"));
  }

  void of_what_is_too_large_the_part_around_a_time_is_loaded() {
    const auto whole = runs_of(McapReader(log_.toStdString())).front().memory();
    const std::size_t limit = whole / 3;
    Player player({.memory = limit});
    QVERIFY(player.load(log_));
    QVERIFY(player.feed.is_part());
    QVERIFY(player.rows() > 900 && player.rows() < 1001);
    QCOMPARE(player.feed.loaded().from, 0.0);
    QVERIFY(player.feed.summary().find(" s of 3.0 s; no more than ") != std::string::npos);
    const std::size_t events = player.store.events().size();
    QVERIFY(events >= 2);  // those at the end, too
    player.clock.seek(2.0);
    QCOMPARE(player.feed.state(), LogFeed::State::loading);
    QVERIFY(player.wait());
    QVERIFY(player.feed.loaded().holds(2.0));
    QVERIFY(player.rows() > 900 && player.rows() < 1001);
    QCOMPARE(player.store.events().size(), events);
    QCOMPARE(player.store.find("tick")->last(), 2000.0);
    player.clock.seek(2.1);  // is there
    QCOMPARE(player.feed.state(), LogFeed::State::loaded);
    player.clock.seek(99.0);
    QVERIFY(player.wait());
    QCOMPARE(player.store.newest(), 2.999);
  }

  void a_log_that_was_cut_off_is_read_as_far_as_it_goes_data() {
    QTest::addColumn<double>("share");
    QTest::addColumn<bool>("has_rows");
    QTest::newRow("in its last chunk") << 0.9 << true;
    QTest::newRow("in the middle") << 0.5 << true;
    QTest::newRow("before a chunk was whole") << 0.02 << false;
  }
  void a_log_that_was_cut_off_is_read_as_far_as_it_goes() {
    QFETCH(double, share);
    QFETCH(bool, has_rows);
    const QByteArray all = bytes();
    const QString path =
        written(all.left(static_cast<qsizetype>(share * static_cast<double>(all.size()))));
    Player player;
    QVERIFY(player.load(path));
    QCOMPARE(player.rows() > 400, has_rows);
    QVERIFY(player.rows() < 3000);
    QVERIFY(player.feed.problem().find("cut off") != std::string::npos);
    QCOMPARE(player.feed.whole().to, player.store.newest());
  }

  void a_damaged_chunk_ends_the_reading_with_its_reason() {
    QByteArray all = bytes();
    all[all.size() / 2] = static_cast<char>(all[all.size() / 2] + 1);
    Player player;
    QVERIFY(player.load(written(all)));
    QVERIFY(player.rows() > 400 && player.rows() < 3000);
    QVERIFY2(player.feed.problem().find("checksum") != std::string::npos,
             player.feed.problem().c_str());
  }

  void what_is_no_log_is_refused_and_what_was_open_stays() {
    Player player;
    QVERIFY(player.load(log_));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                             player.feed.open(written("nothing").toStdString()));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, player.feed.open("/nowhere.mcap"));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, player.feed.choose(2));
    QCOMPARE(player.rows(), std::uint64_t{3000});
  }

  void a_run_of_several_is_chosen() {
    const QString path = folder_.filePath("two.mcap");
    const auto outcome = test::run_script_text(
        "local laparoscope = trocar.Laparoscope {}\n"
        "trocar.run { duration = '1 s' }\ntrocar.run { duration = '2 s' }\n",
        {}, {.record = path.toStdString()});
    QVERIFY2(outcome.findings.isEmpty(), qPrintable(outcome.findings.join('\n')));
    Player player;
    QVERIFY(player.load(path));
    QCOMPARE(player.feed.runs().size(), std::size_t{2});
    QCOMPARE(player.rows(), std::uint64_t{1000});
    player.clock.seek(0.5);
    QSignalSpy opened(&player.feed, &LogFeed::opened);
    player.feed.choose(2);
    QVERIFY(player.wait());
    QCOMPARE(opened.size(), 1);
    QCOMPARE(player.rows(), std::uint64_t{2000});
    QCOMPARE(player.clock.now(), 0.0);
    QCOMPARE(player.feed.summary(), std::string("run 2 of 2: 2.0 s"));
  }

  void the_clock_moves_data() {
    QTest::addColumn<std::function<void(Player&)>>("does");
    QTest::addColumn<double>("now");
    using Does = std::function<void(Player&)>;
    const auto row = [](const char* name, double now, const Does& does) {
      QTest::newRow(name) << does << now;
    };
    row("a second is a second", 1.5, [](Player& p) { p.clock.advance(0.5); });
    row("slowly", 1.05, [](Player& p) {
      p.clock.set_speed(0.1);
      p.clock.advance(0.5);
    });
    row("quickly, to the end and no farther", 2.999, [](Player& p) {
      p.clock.set_speed(10.0);
      p.clock.advance(0.5);
    });
    row("a speed that there is not is the nearest", 1.2, [](Player& p) {
      p.clock.set_speed(2.3);
      p.clock.advance(0.1);
    });
    row("a tick forward", 1.001, [](Player& p) { p.clock.step(1); });
    row("a tick back", 0.999, [](Player& p) { p.clock.step(-1); });
    row("ticks back stop at the first", 0.0, [](Player& p) { p.clock.step(-5000); });
    row("sought before the start", 0.0, [](Player& p) { p.clock.seek(-1.0); });
    row("round a loop", 1.1, [](Player& p) {
      p.clock.set_loop(LogFeed::Span{0.9, 1.3});
      p.clock.advance(0.5);
    });
    row("a loop that is turned round is none", 1.5, [](Player& p) {
      p.clock.set_loop(LogFeed::Span{1.3, 0.9});
      p.clock.advance(0.5);
    });
    row("to the fault ahead", 2.0, [](Player& p) { p.clock.jump_to_event(1); });
    row("to the remark behind", 0.7, [](Player& p) { p.clock.jump_to_event(-1); });
    row("beyond the last event stays", 2.0, [](Player& p) {
      p.clock.jump_to_event(1);
      p.clock.jump_to_event(1);
    });
  }
  void the_clock_moves() {
    QFETCH(std::function<void(Player&)>, does);
    QFETCH(double, now);
    Player player;
    QVERIFY(player.load(log_));
    for (const auto& [time, kind] : {std::pair{0.2, "fault"}, std::pair{0.7, "annotated"},
                                     std::pair{0.8, "gate"}, std::pair{2.0, "fault"}})
      player.store.add_event(event_at(time, kind));
    player.clock.seek(1.0);
    does(player);
    QVERIFY2(std::abs(player.clock.now() - now) < 1e-9,
             qPrintable(QString::number(player.clock.now(), 'g', 12)));
    QCOMPARE(player.store.now(), player.clock.now());
  }

  void playing_goes_on_by_itself_and_ends_with_the_log() {
    Player player;
    QVERIFY(player.load(log_));
    player.clock.set_speed(10.0);
    player.clock.play();
    QVERIFY(player.clock.is_playing());
    QVERIFY(QTest::qWaitFor([&] { return !player.clock.is_playing(); }, 20'000));
    QCOMPARE(player.clock.now(), player.feed.whole().to);
    player.clock.play();
    QCOMPARE(player.clock.now(), 0.0);
  }

  void the_time_line_obeys_mouse_and_keys() {
    Player player;
    TimeLine line(player.store, player.feed, player.clock);
    line.resize(624, 44);
    QVERIFY(player.load(log_));
    QCOMPARE(line.maximum(), 29990);
    QCOMPARE(line.time_at(line.x_of(1.5)), 1.5);
    QTest::mouseClick(&line, Qt::LeftButton, {}, QPoint(312, 18));
    QVERIFY(std::abs(player.clock.now() - 1.4995) < 3e-3);
    player.clock.seek(1.0);
    const std::pair<int, double> keys[] = {{Qt::Key_Right, 1.001},     {Qt::Key_Left, 1.0},
                                           {Qt::Key_PageDown, 1.2999}, {Qt::Key_PageUp, 1.0},
                                           {Qt::Key_End, 2.999},       {Qt::Key_Home, 0.0}};
    for (const auto& [key, now] : keys) {
      QTest::keyClick(&line, static_cast<Qt::Key>(key));
      QVERIFY2(std::abs(player.clock.now() - now) < 1e-9, qPrintable(QString::number(key, 16)));
    }
    QTest::keyClick(&line, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(player.clock.now(), 1.0);
    line.setValue(15000);  // as a screen reader does
    QCOMPARE(player.clock.now(), 1.5);
    QCOMPARE(line.accessibleDescription(), QString("1.500 s of 2.999 s"));
  }

  void the_window_of_a_live_run_shows_a_replay() {
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, Replay("/nowhere.mcap"));
    Replay replay(log_.toStdString());
    QVERIFY(QTest::qWaitFor([&] { return replay.feed().state() == LogFeed::State::loaded; }));
    replay.clock().seek(2.0);
    replay.window().show();
    replay.window().set_theme(Theme::dark_one());
    const int dash = trocar::test::longest_dash(replay.window(), Theme::dark_one().replay);
    QVERIFY2(dash > 2 && dash < 12, qPrintable(QString::number(dash)));  // dotted
    QVERIFY(replay.window().windowTitle().startsWith("REPLAY – wall.mcap"));
    const QString mark = replay.window().findChild<Readout*>("mark")->whole_text();
    QVERIFY2(QRegularExpression("^wall\\.mcap   \\S+\\.lua [0-9a-f]{8}$").match(mark).hasMatch(),
             qPrintable(mark));
    QVERIFY(replay.window().findChild<TimeLine*>("time_line")->isVisible());
    for (std::size_t page = 0; page < replay.window().pages().size(); ++page) {
      replay.window().show_page(static_cast<int>(page));
      replay.window().refresh();
    }
  }

  void a_picture_shows_where_playback_stands() {
    Player player;
    TimeLine line(player.store, player.feed, player.clock);
    line.resize(624, 44);
    QVERIFY(player.load(log_));
    player.clock.seek(1.5);
    const QImage picture = line.grab().toImage();
    const auto colour = [&](double time) {
      return picture.pixelColor(static_cast<int>(line.x_of(time)), 19);
    };
    QCOMPARE(colour(0.5), Theme::light().accent);
    QCOMPARE(colour(1.5), Theme::light().accent);
    QCOMPARE(colour(2.5), Theme::light().grid);
  }

  void the_bar_does_what_its_buttons_say() {
    Player player({.slice = 100});
    PlaybackBar bar(player.store, player.feed, player.clock);
    const auto button = [&](const char* name) { return bar.findChild<QPushButton*>(name); };
    player.feed.open(log_.toStdString());
    QVERIFY(!button("playback_cancel")->isHidden());
    QVERIFY(player.wait());
    QVERIFY(button("playback_cancel")->isHidden());
    QVERIFY(bar.findChild<QLabel*>("playback_problem")->isHidden());
    button("playback_forward")->click();
    QCOMPARE(player.clock.now(), 0.001);
    player.clock.seek(1.0);
    button("playback_loop_from")->click();
    player.clock.seek(2.0);
    button("playback_loop_to")->click();
    QCOMPARE(player.clock.loop()->from, 1.0);
    QCOMPARE(player.clock.loop()->to, 2.0);
    button("playback_no_loop")->click();
    QVERIFY(!player.clock.loop());
    button("playback_play")->click();
    QCOMPARE(button("playback_play")->text(), QString("Hold"));
    button("playback_play")->click();
    QVERIFY(!player.clock.is_playing());
    QByteArray cut = bytes();
    player.feed.open(written(cut.left(cut.size() / 2)).toStdString());
    QVERIFY(player.wait());
    QVERIFY(bar.findChild<QLabel*>("playback_problem")->text().contains("cut off"));
    for (const QWidget* widget : bar.findChildren<QWidget*>())
      if (widget->focusPolicy() != Qt::NoFocus && !widget->parentWidget()->inherits("QComboBox"))
        QVERIFY2(!widget->objectName().isEmpty() && !widget->accessibleName().isEmpty(),
                 widget->metaObject()->className());
  }
};

QTEST_MAIN(TestPlayback)
#include "tst_playback.moc"
