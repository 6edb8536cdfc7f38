// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPen>
#include <QWidget>
#include <vector>

#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// The curves of a plot with their newest values, in a line. It is written anew several times a
/// second, for which rich text would be too slow.
class PlotLegend : public QWidget {
  Q_OBJECT

 public:
  struct Entry {
    QPen pen;
    QString name;
    QString value;  // with its unit; "": there is none
    bool operator==(const Entry&) const = default;
  };

  explicit PlotLegend(QWidget* parent = nullptr);

  /// @param notice goes before, in bold
  void show_entries(const QString& notice, std::vector<Entry> entries);
  void set_theme(const Theme& theme);
  QString html() const;  // the same as rich text, for paper
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {1, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Draws, or only measures where there is no painter. @return the width [px]
  int lay_out(QPainter* painter, int x) const;

  Theme theme_ = Theme::light();
  QString notice_;
  std::vector<Entry> entries_;
  int wide_ = 0;  // [px]
};

}  // namespace trocar::gui
