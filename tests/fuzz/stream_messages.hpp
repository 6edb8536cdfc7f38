// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace trocar::test {

/// Feeds one input to what parses a stream's messages, and aborts when a promise is broken. The
/// first byte's lowest bit chooses between a text and a binary message, the next between what a
/// client and what a server says; the rest is the message.
///
/// Promises: it is taken, or refused by std::invalid_argument; what is taken reads the same again
/// when it is written anew, where we write such messages.
///
/// @return whether it was taken
bool feed_stream_message(std::span<const std::uint8_t> input);

}  // namespace trocar::test
