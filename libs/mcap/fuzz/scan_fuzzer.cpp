// SPDX-License-Identifier: Apache-2.0
// Any bytes are read or refused, within the limits.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "skein/mcap/scan.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  skein::mcap::ScanLimits limits;
  limits.chunk = 1 << 20;
  std::uint64_t seen = 0;
  const auto contents = skein::mcap::scan(
      {reinterpret_cast<const char*>(data), size},
      [&](const skein::mcap::Channel&, const skein::mcap::Message& message) {
        seen += message.data.size() < (1U << 20) ? 1 : 0;
      },
      limits);
  if (seen != contents.messages) std::abort();
  if (contents.problems.size() > limits.problems) std::abort();
  if (!contents.complete && contents.problems.empty()) std::abort();
  return 0;
}
