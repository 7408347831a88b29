// SPDX-License-Identifier: Apache-2.0
// Any bytes as a trace, and as a types file: no crash, no broken contract.
#include <cstdint>
#include <sstream>
#include <string>

#include "skein/mle_tool/mle.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(data, data + size));
  std::ostringstream out, err;
  skein::mle_tool::MleOptions options;
  options.uav = "marvin";
  options.until = skein::MissionTime::seconds(1e6);
  if (size % 2 == 1) options.timeout = skein::Duration::seconds(3);
  if (size % 3 == 1) options.background = "wait";
  skein::mle_tool::run_mle(options, in, out, err);
  return 0;
}
