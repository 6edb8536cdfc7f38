// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include "gui/analysis/trigger.hpp"

namespace trocar::gui {

/// What a trigger looks for, and what it does now.
class TriggerBar : public QWidget {
  Q_OBJECT

 public:
  explicit TriggerBar(const DataStore& store, QWidget* parent = nullptr);

  /// That can be looked at; what was chosen stays.
  void show_names(const std::vector<std::string>& names);
  void show_settings(const TriggerSettings& settings);
  TriggerSettings settings() const;
  void show_state(const Trigger& trigger);

 Q_SIGNALS:
  void changed();  // by the user
  void arm();

 private:
  QDoubleSpinBox* number(const char* name, const QString& what, double low, double high);
  QComboBox* choice(const char* name, const QString& what);
  void show_unit();
  double scale() const;

  const DataStore& data_;
  QComboBox *signal_, *when_, *mode_;
  QDoubleSpinBox *level_, *hysteresis_, *before_, *after_;
  QPushButton* arm_;
  QLabel* state_;
  bool showing_ = false;
};

}  // namespace trocar::gui
