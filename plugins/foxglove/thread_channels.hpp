// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <functional>

#include "framework/stream/batch.hpp"
#include "framework/stream/preview.hpp"
#include "framework/stream/server_message.hpp"

namespace trocar::foxglove {

/// The channels of one thread's rows: each row, previews, and batches.
class ThreadChannels {
 public:
  using Send = std::function<void(std::uint32_t channel, QByteArray& message)>;
  using Wanted = std::function<bool(std::uint32_t channel)>;

  /// @param first_id of three that are free
  ThreadChannels(const RowLayout& layout, std::uint32_t first_id, std::uint64_t epoch_ns);

  std::vector<stream::Channel> channels() const;
  /// Sends what is wanted of a row.
  void row(std::span<const std::byte> row, const Wanted& wanted, const Send& send);
  /// Sends the rows that were gathered for a batch; of a run that has ended, the last preview.
  void flush(bool ended, const Send& send);

 private:
  std::uint32_t row_id() const { return first_id_; }
  std::uint32_t preview_id() const { return first_id_ + 1; }
  std::uint32_t batch_id() const { return first_id_ + 2; }
  void send_preview(std::span<const std::byte> message, const Send& send);
  void send_batch(const Send& send);

  std::string topic_;
  std::string row_schema_;
  std::uint32_t first_id_;
  std::uint64_t epoch_ns_;
  stream::Preview preview_;
  stream::Batch batch_;
  QByteArray message_;
};

/// A message of data with room for a subscription's number.
QByteArray data_message(std::uint64_t time_ns, std::span<const std::byte> content);

}  // namespace trocar::foxglove
