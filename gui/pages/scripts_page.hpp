// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>

#include "gui/operate/operator.hpp"
#include "gui/operate/scripts.hpp"

namespace trocar::gui {

/// The laws in Lua: their files, what they cost, and reloading them while they run.
class ScriptsPage : public Page {
  Q_OBJECT

 public:
  explicit ScriptsPage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Scripts"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+5"); }
  void refresh() override;
  void set_theme(const Theme&) override {}

 private:
  void build();
  int row() const;

  Operator& operator_;
  ScriptModel scripts_;
  QTableView* table_;
  QPushButton* reload_;
  QPlainTextEdit* verdict_;
};

}  // namespace trocar::gui
