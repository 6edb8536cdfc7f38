// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry: see scripts/dev/fuzz.
#include "tests/fuzz/hid_reports.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  trocar::test::feed_hid_reports({data, size});
  return 0;
}
