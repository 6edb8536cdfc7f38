// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include "gui/window/page.hpp"

namespace trocar::gui {

/// What is being recorded, by the run itself or by a client, and what was lost.
class RecordingControl : public QObject {
  Q_OBJECT

 public:
  explicit RecordingControl(const Sources& sources, QObject* parent = nullptr);

  bool recording() const;
  /// The trial has holes, or its recording failed: it stays so until the next one begins.
  bool incomplete() const { return incomplete_; }
  /// Why it failed; "" when it did not.
  const QString& trouble() const { return trouble_; }
  QString trial() const;  // its file
  /// A client records it, not the run itself: it can be ended.
  bool can_end() const;
  /// Rows that are in no file: those that the writer was too slow for, and all since it failed.
  std::int64_t lost() const;
  /// "REC 02:14 lost 0", "not recording", "RECORDING FAILED".
  QString text() const;
  /// Of a recording that failed, for a banner: why, and what it cost. "" when none did.
  QString failure() const;

  /// @param file "" for a name by the date
  void start(const QString& file = {});
  void stop();

 Q_SIGNALS:
  void changed();

 private:
  void hear();
  void hear_status(const stream::Status& status);
  void fail(const QString& why);
  std::uint64_t rows_seen() const;

  Sources sources_;
  QString trouble_;
  bool incomplete_ = false;
  double began_ = 0.0;              // [s] of the run
  std::string file_;                // as the runtime says
  std::string trial_;               // the newest that was recorded
  std::string log_trouble_;         // of the run's own log, as heard last
  std::int64_t missed_ = 0;         // of that
  std::uint64_t seen_at_good_ = 0;  // rows, when it was last heard to be written
};

}  // namespace trocar::gui
