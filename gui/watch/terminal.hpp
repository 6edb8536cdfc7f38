// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QSocketNotifier>
#include <cstddef>
#include <memory>

namespace trocar::gui {

/// The terminal, while one lives: keys come without Enter and are not shown, and a screen of its
/// own is drawn on. Where standard input or output is none, there are no keys, or no screen.
class Terminal : public QObject {
  Q_OBJECT

 public:
  Terminal();
  ~Terminal() override;

  bool has_screen() const { return has_screen_; }
  std::size_t width() const;   // [characters]
  std::size_t height() const;  // [lines]

 Q_SIGNALS:
  void key(char which);

 private:
  std::unique_ptr<QSocketNotifier> keys_;
  bool has_screen_ = false;
};

/// Gives the terminal back as it was; may be called from a signal handler.
void restore_terminal();

}  // namespace trocar::gui
