// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gui/playback/log_feed.hpp"
#include "gui/window/page.hpp"
#include "tests/support/script_bench.hpp"

namespace trocar::test {

/// The log of a script as a dashboard sees it.
class LogRig {
 public:
  explicit LogRig(const QByteArray& script, const QStringList& settings = {}, double seconds = 0.02,
                  ClockKind clock = ClockKind::simulated) {
    const std::string path = folder_.filePath("run.mcap").toStdString();
    findings =
        run_script_text(script, settings, {.duration = seconds, .record = path}, clock).findings;
    if (!findings.isEmpty()) return;
    feed.open(path);
    if (!QTest::qWaitFor([this] { return feed.state() == gui::LogFeed::State::loaded; }, 20'000))
      findings << "the log does not load";
  }

  gui::Sources sources() { return {.data = store, .log = &feed}; }

  QStringList findings;
  gui::DataStore store;
  gui::LogFeed feed{store};

 private:
  QTemporaryDir folder_;
};

}  // namespace trocar::test
