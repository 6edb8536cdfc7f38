// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/parameters.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace trocar::gui {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

QString shown(double value) {
  return QString::number(value, 'g', 6);
}

double number_or(const nlohmann::json& json, const char* key, double otherwise) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : otherwise;
}

ParameterView view_of(const nlohmann::json& json) {
  ParameterView view;
  view.name = QString::fromStdString(json.value("name", ""));
  view.text = QString::fromStdString(json.value("text", ""));
  view.unit = QString::fromStdString(json.value("shown_unit", ""));
  view.doc = QString::fromStdString(json.value("doc", ""));
  view.scale = number_or(json, "shown_scale", 1.0);
  view.live = json.value("live", false);
  for (const auto& choice : json.value("choices", nlohmann::json::array()))
    view.choices << QString::fromStdString(choice.get<std::string>());
  const auto numbers = json.value("value", nlohmann::json::array());
  view.is_number = numbers.size() == 1 && numbers[0].is_number();
  if (view.is_number) view.value = view.first = numbers[0].get<double>() / view.scale;
  view.min = number_or(json, "min", -infinite) / view.scale;
  view.max = number_or(json, "max", infinite) / view.scale;
  return view;
}

}  // namespace

/// To a value and back.
class ParameterEdit : public QUndoCommand {
 public:
  ParameterEdit(ParameterModel& model, QString name, double before, double after, int gesture)
      : QUndoCommand(QString("%1 = %2").arg(name, shown(after))),
        model_(model),
        name_(std::move(name)),
        before_(before),
        after_(after),
        gesture_(gesture) {}
  int id() const override { return gesture_ == 0 ? -1 : gesture_; }
  bool mergeWith(const QUndoCommand* newer) override {
    const auto& other = static_cast<const ParameterEdit&>(*newer);
    if (other.name_ != name_) return false;
    after_ = other.after_;
    setText(other.text());
    return true;
  }
  void redo() override { model_.send(name_, after_); }
  void undo() override { model_.send(name_, before_); }

 private:
  ParameterModel& model_;
  QString name_;
  double before_, after_;
  int gesture_;
};

bool ParameterView::bounded() const {
  return std::isfinite(min) && std::isfinite(max);
}

QString ParameterView::range_text() const {
  if (!is_number) return choices.join(", ");
  if (bounded()) return QString("%1 – %2").arg(shown(min), shown(max));
  if (std::isfinite(min)) return QString("≥ %1").arg(shown(min));
  if (std::isfinite(max)) return QString("≤ %1").arg(shown(max));
  return "";
}

QString ParameterView::edit_text() const {
  switch (edit) {
    case Edit::none:
      return changed() ? "changed" : live ? "" : "fixed while it runs";
    case Edit::asked:
      return QString("asked: %1 %2").arg(shown(asked), unit);
    case Edit::accepted:
      return "accepted";
    case Edit::ramped:
      return QString("ramped from tick %1").arg(tick);
    case Edit::refused:
      return "refused: " + trouble;
  }
  return "";
}

ParameterModel::ParameterModel(const Sources& sources, QObject* parent)
    : QAbstractTableModel(parent), sources_(sources), history_(this) {
  if (sources_.live != nullptr)
    connect(sources_.live, &LiveFeed::parameters_known, this, &ParameterModel::load);
  if (sources_.link != nullptr) {
    connect(sources_.link, &StreamClient::parameters, this, &ParameterModel::hear);
    connect(sources_.link, &StreamClient::status, this, &ParameterModel::hear_status);
  }
  connect(&sources_.data, &DataStore::event_added, this, &ParameterModel::hear_event);
  load();
}

/// Anew for each run: what was first is kept while the parameters are the same.
void ParameterModel::load() {
  if (sources_.live == nullptr || !sources_.live->parameters().is_array()) return;
  std::vector<ParameterView> loaded;
  for (const auto& one : sources_.live->parameters()) loaded.push_back(view_of(one));
  beginResetModel();
  for (ParameterView& view : loaded)
    if (const auto row = find(view.name))
      view.first = parameters_[static_cast<std::size_t>(*row)].first;
  parameters_ = std::move(loaded);
  endResetModel();
}

std::optional<int> ParameterModel::find(const QString& wanted) const {
  for (std::size_t i = 0; i < parameters_.size(); ++i)
    if (parameters_[i].name == wanted) return static_cast<int>(i);
  return std::nullopt;
}

bool ParameterModel::may_write() const {
  return sources_.link != nullptr && sources_.link->state() == LinkState::open &&
         sources_.link->may_write();
}

QString ParameterModel::ask(int row, double wanted, int gesture) {
  const ParameterView& view = parameters_[static_cast<std::size_t>(row)];
  if (!may_write()) return "this client only looks: the token is missing";
  if (!view.live || !view.is_number) return view.name + " cannot be changed while it runs";
  if (!(wanted >= view.min && wanted <= view.max))
    return QString("%1 = %2 %3 is outside of %4 %3")
        .arg(view.name, shown(wanted), view.unit, view.range_text());
  const double before = view.edit == ParameterView::Edit::asked ? view.asked : view.value;
  if (wanted == before) return "";
  history_.push(new ParameterEdit(*this, view.name, before, wanted, gesture));
  return "";
}

void ParameterModel::send(const QString& wanted, double asked) {
  const auto row = find(wanted);
  if (!row || sources_.link == nullptr) return;
  ParameterView& view = parameters_[static_cast<std::size_t>(*row)];
  view.edit = ParameterView::Edit::asked;
  view.asked = asked;
  view.trouble.clear();
  touch(*row);
  sources_.link->set_parameter(wanted.toStdString(), asked * view.scale);
}

void ParameterModel::hear(const std::vector<stream::NamedValue>& values) {
  for (const stream::NamedValue& one : values) {
    const auto row = find(QString::fromStdString(one.name));
    const auto* number = std::get_if<double>(&one.value);
    if (!row || number == nullptr) continue;
    ParameterView& view = parameters_[static_cast<std::size_t>(*row)];
    view.value = *number / view.scale;
    if (view.edit == ParameterView::Edit::asked &&
        std::abs(view.value - view.asked) <= 1e-9 * std::abs(view.asked))
      view.edit = ParameterView::Edit::accepted;
    touch(*row);
  }
}

void ParameterModel::hear_event(const RunEvent& event) {
  if (event.kind != "edit" && event.kind != "edit refused") return;
  const std::string key = event.source + "." + event.detail.substr(0, event.detail.find(':'));
  const auto row = find(QString::fromStdString(key));
  if (!row) return;
  ParameterView& view = parameters_[static_cast<std::size_t>(*row)];
  view.tick = event.tick;
  view.edit = event.kind == "edit" ? ParameterView::Edit::ramped : ParameterView::Edit::refused;
  const auto colon = event.detail.find(": ");
  view.trouble =
      colon == std::string::npos ? "" : QString::fromStdString(event.detail.substr(colon + 2));
  touch(*row);
}

/// What is refused names its parameter; where it does not, it is that which was asked alone.
void ParameterModel::hear_status(const stream::Status& status) {
  if (status.level != stream::StatusLevel::error) return;
  const QString why = QString::fromStdString(status.text);
  std::vector<std::size_t> asked, named;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (parameters_[i].edit != ParameterView::Edit::asked) continue;
    asked.push_back(i);
    if (why.contains(parameters_[i].name)) named.push_back(i);
  }
  if (named.empty() && asked.size() == 1) named = asked;
  for (const std::size_t i : named) {
    parameters_[i].edit = ParameterView::Edit::refused;
    parameters_[i].trouble = why;
    touch(static_cast<int>(i));
  }
}

void ParameterModel::touch(int row) {
  Q_EMIT dataChanged(index(row, 0), index(row, columns - 1));
}

int ParameterModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(parameters_.size());
}

int ParameterModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant ParameterModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const ParameterView& view = parameters_[static_cast<std::size_t>(index.row())];
  if (role == Qt::ToolTipRole) return view.doc;
  if (role == live_role) return view.live && view.is_number;
  if (role == Qt::EditRole && index.column() == value) return view.value;
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case name:
      return view.name;
    case value:
      return view.is_number ? shown(view.value) : view.text;
    case unit:
      return view.unit;
    case range:
      return view.range_text();
    case first:
      return view.is_number ? shown(view.first) : QString();
    case state:
      return view.edit_text();
    default:
      return {};
  }
}

bool ParameterModel::setData(const QModelIndex& index, const QVariant& given, int role) {
  bool is_number = false;
  const double wanted = given.toDouble(&is_number);
  return role == Qt::EditRole && index.column() == value && is_number &&
         ask(index.row(), wanted).isEmpty();
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (!index.isValid() || index.row() >= rowCount()) return flags;
  const ParameterView& view = parameters_[static_cast<std::size_t>(index.row())];
  if (index.column() == value && view.live && view.is_number && may_write())
    flags |= Qt::ItemIsEditable;
  return flags;
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const {
  static const char* const names[] = {"parameter", "value", "unit", "range", "at first", "state"};
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section >= columns) return {};
  return QString(names[section]);
}

}  // namespace trocar::gui
