// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace trocar {

/// How a value goes from one thread to another. Inside a thread a connection is a pointer and needs
/// no choice.
struct Connection {
  enum class Kind {
    latest,  // the newest value, again and again
    queue    // each value once, in order, one for each step of the reader
  };
  Kind kind = Kind::latest;
  double stale = std::numeric_limits<double>::infinity();  // [s] of age that is a fault
  std::size_t size = 64;                                   // of a queue
};

inline const char* to_string(Connection::Kind kind) {
  return kind == Connection::Kind::latest ? "latest" : "queue";
}

/// What an input knows of the value that it reads.
struct SampleInfo {
  std::int64_t tick = -1;  // of the thread that it comes from; -1 until the first has arrived
  double age = 0.0;        // [s] between its tick and the one that reads it
  bool valid = true;       // it arrived, is not stale, and is computed from sound values
  bool fresh = true;       // not read before
};

}  // namespace trocar
