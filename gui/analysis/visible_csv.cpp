// SPDX-License-Identifier: Apache-2.0
#include "gui/analysis/visible_csv.hpp"

#include <fmt/format.h>

#include <QSaveFile>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace trocar::gui {
namespace {

/// Where the rows of a thread stand.
struct Reader {
  const Track* track = nullptr;
  std::uint64_t row = 0, end = 0;

  bool done() const { return row >= end; }
  double time() const { return track->time(row); }
};

std::vector<SignalRef> known(const DataStore& data, const std::vector<std::string>& names) {
  std::vector<SignalRef> found;
  for (const std::string& name : names)
    if (const auto signal = data.find(name)) found.push_back(*signal);
  return found;
}

std::vector<Reader> readers_of(const std::vector<SignalRef>& columns, double begin, double end) {
  std::vector<Reader> readers;
  for (const SignalRef& column : columns) {
    const auto same = [&](const Reader& reader) { return reader.track == column.track; };
    if (std::any_of(readers.begin(), readers.end(), same)) continue;
    readers.push_back({column.track, column.track->at(begin),
                       column.track->at(std::nextafter(end, std::numeric_limits<double>::max()))});
  }
  return readers;
}

}  // namespace

std::string csv_of(const DataStore& data, const std::vector<std::string>& names, double begin,
                   double end) {
  const std::vector<SignalRef> columns = known(data, names);
  std::string text = "time [s]";
  for (const SignalRef& column : columns)
    text += fmt::format(",{} [{}]", column.info().name, column.info().unit);
  text += '\n';
  std::vector<Reader> readers = readers_of(columns, begin, end);
  for (;;) {
    double time = std::numeric_limits<double>::infinity();
    for (const Reader& reader : readers)
      if (!reader.done()) time = std::min(time, reader.time());
    if (!std::isfinite(time)) return text;
    fmt::format_to(std::back_inserter(text), "{}", time);
    for (const SignalRef& column : columns) {
      const auto reader = std::find_if(readers.begin(), readers.end(), [&](const Reader& one) {
        return one.track == column.track;
      });
      text += ',';
      if (!reader->done() && reader->time() == time)
        fmt::format_to(std::back_inserter(text), "{}", column.column()[reader->row]);
    }
    text += '\n';
    for (Reader& reader : readers)
      if (!reader.done() && reader.time() == time) ++reader.row;
  }
}

void write_csv(const QString& path, const DataStore& data, const std::vector<std::string>& names,
               double begin, double end) {
  if (known(data, names).empty())
    throw std::runtime_error("no signal of this run is shown, so there is nothing to write");
  QSaveFile file(path);
  const std::string text = csv_of(data, names, begin, end);
  if (!file.open(QFile::WriteOnly) ||
      file.write(text.data(), static_cast<qint64>(text.size())) < 0 || !file.commit())
    throw std::runtime_error(QString("%1: %2").arg(path, file.errorString()).toStdString());
}

}  // namespace trocar::gui
