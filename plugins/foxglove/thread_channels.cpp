// SPDX-License-Identifier: Apache-2.0
#include "plugins/foxglove/thread_channels.hpp"

#include <cstring>

#include "framework/recording/cdr.hpp"
#include "framework/recording/row_sink.hpp"

namespace trocar::foxglove {
namespace {

constexpr std::int64_t preview_window_ns = 33'333'333;
constexpr std::uint32_t most_rows = 500;  // in a batch

std::span<std::byte> bytes_of(QByteArray& bytes) {
  return {reinterpret_cast<std::byte*>(bytes.data()), static_cast<std::size_t>(bytes.size())};
}

}  // namespace

QByteArray data_message(std::uint64_t time_ns, std::span<const std::byte> content) {
  QByteArray message(static_cast<qsizetype>(stream::data_head + content.size()), 0);
  const std::span<std::byte> bytes = bytes_of(message);
  stream::write_data_head(bytes.first<stream::data_head>(), time_ns);
  if (!content.empty())
    std::memcpy(bytes.data() + stream::data_head, content.data(), content.size());
  return message;
}

ThreadChannels::ThreadChannels(const RowLayout& layout, std::uint32_t first_id,
                               std::uint64_t epoch_ns)
    : topic_("/" + layout.name()),
      row_schema_(ros2_schema_text(layout.messages())),
      first_id_(first_id),
      epoch_ns_(epoch_ns),
      preview_(layout, preview_window_ns),
      batch_(layout),
      message_(static_cast<qsizetype>(stream::data_head + cdr_head + layout.size()), 0) {
  message_[static_cast<qsizetype>(stream::data_head) + 1] = 1;  // CDR, little-endian
}

std::vector<stream::Channel> ThreadChannels::channels() const {
  return {
      {row_id(), topic_, "cdr", "trocar/Row", row_schema_, "ros2msg"},
      {preview_id(), topic_ + "/preview", "cdr", "trocar/Preview", preview_.schema(), "ros2msg"},
      {batch_id(), topic_ + "/batch", "cdr", "trocar/Batch", batch_.schema(), "ros2msg"}};
}

void ThreadChannels::row(std::span<const std::byte> row, const Wanted& wanted, const Send& send) {
  if (wanted(row_id())) {
    const std::span<std::byte> bytes = bytes_of(message_);
    stream::write_data_head(bytes.first<stream::data_head>(),
                            epoch_ns_ + static_cast<std::uint64_t>(header_of(row).time));
    std::memcpy(bytes.data() + stream::data_head + cdr_head, row.data(), row.size());
    send(row_id(), message_);
  }
  if (wanted(preview_id()))
    if (const auto full = preview_.add(row)) send_preview(*full, send);
  if (wanted(batch_id())) {
    batch_.add(row);
    if (batch_.count() >= most_rows) send_batch(send);
  }
}

void ThreadChannels::flush(bool ended, const Send& send) {
  if (batch_.count() > 0) send_batch(send);
  if (ended)
    if (const auto rest = preview_.finish()) send_preview(*rest, send);
}

void ThreadChannels::send_preview(std::span<const std::byte> content, const Send& send) {
  QByteArray message =
      data_message(epoch_ns_ + static_cast<std::uint64_t>(preview_.time_ns()), content);
  send(preview_id(), message);
}

void ThreadChannels::send_batch(const Send& send) {
  const std::uint64_t time_ns = epoch_ns_ + static_cast<std::uint64_t>(batch_.time_ns());
  QByteArray message = data_message(time_ns, batch_.take());
  send(batch_id(), message);
}

}  // namespace trocar::foxglove
