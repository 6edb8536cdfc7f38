// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/plot_legend.hpp"

#include <QPainter>
#include <algorithm>

namespace trocar::gui {
namespace {

constexpr int mark_width = 18, gap = 4, between = 12;  // [px]
constexpr const char* nothing = "no value";

}  // namespace

PlotLegend::PlotLegend(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
}

void PlotLegend::show_entries(const QString& notice, std::vector<Entry> entries) {
  if (notice == notice_ && entries == entries_) return;
  notice_ = notice;
  entries_ = std::move(entries);
  const int before = wide_;
  wide_ = lay_out(nullptr, 0);
  // Room that numbers have taken once they keep: the layout does not follow each digit.
  if (wide_ > before || wide_ < before - 10 * between)
    updateGeometry();
  else
    wide_ = before;
  update();
}

void PlotLegend::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

QSize PlotLegend::sizeHint() const {
  return {wide_, fontMetrics().height() + 2};
}

int PlotLegend::lay_out(QPainter* painter, int x) const {
  const int begin = x, base = fontMetrics().ascent() + 1;
  QFont bold = font();
  bold.setBold(true);
  const QFontMetrics plain_metrics = fontMetrics(), bold_metrics(bold);
  const auto write = [&](const QString& text, const QFont& in, const QFontMetrics& metrics,
                         const QColor& colour) {
    if (painter != nullptr) {
      painter->setFont(in);
      painter->setPen(colour);
      painter->drawText(x, base, text);
    }
    x += metrics.horizontalAdvance(text);
  };
  if (!notice_.isEmpty()) {
    write(notice_, bold, bold_metrics, theme_.text);
    x += between;
  }
  for (const Entry& entry : entries_) {
    if (painter != nullptr) {
      QPen pen = entry.pen;
      pen.setWidth(3);
      pen.setCapStyle(Qt::FlatCap);
      painter->setPen(pen);
      const int middle = height() / 2;
      painter->drawLine(x, middle, x + mark_width, middle);
    }
    x += mark_width + gap;
    write(entry.name, font(), plain_metrics, theme_.text);
    x += gap;
    if (entry.value.isEmpty())
      write(nothing, font(), plain_metrics, theme_.muted);
    else
      write(entry.value, bold, bold_metrics, theme_.text);
    x += between;
  }
  return std::max(0, x - begin - between);
}

/// At the right; where there is too little room the end is cut.
void PlotLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  lay_out(&painter, std::max(0, width() - lay_out(nullptr, 0)));
}

QString PlotLegend::html() const {
  QString text = notice_.isEmpty() ? QString() : "<b>" + notice_.toHtmlEscaped() + "</b>";
  for (const Entry& entry : entries_) {
    static const QStringList marks = {"▬", "▬ ▬", "▪▪▪"};
    const int style = entry.pen.style() == Qt::SolidLine  ? 0
                      : entry.pen.style() == Qt::DashLine ? 1
                                                          : 2;
    text += QString("&nbsp;&nbsp;<span style='color:%1'>%2</span> %3 ")
                .arg(entry.pen.color().name(), marks[style], entry.name.toHtmlEscaped());
    text += entry.value.isEmpty() ? QString(nothing)
                                  : QString("<b>%1</b>").arg(entry.value.toHtmlEscaped());
  }
  return text;
}

}  // namespace trocar::gui
