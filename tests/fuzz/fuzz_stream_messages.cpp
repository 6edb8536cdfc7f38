// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry: see scripts/dev/fuzz.
#include "tests/fuzz/stream_messages.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  trocar::test::feed_stream_message({data, size});
  return 0;
}
