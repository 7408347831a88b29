// SPDX-License-Identifier: Apache-2.0
// Any bytes as a trace, and as a types file: no crash, no broken contract, and the same output for
// the same trace, each line of it ended.
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "line.hpp"
#include "skein/mle_tool/mle.hpp"

namespace {

// The size chooses the options, so that a corpus needs no format of its own.
std::string replay(const std::string& trace) {
  std::istringstream in(trace);
  std::ostringstream out, err;
  skein::mle_tool::MleOptions options;
  options.uav = "marvin";
  options.until = skein::MissionTime::seconds(200);
  if (trace.size() % 2 == 1) options.timeout = skein::Duration::seconds(3);
  if (trace.size() % 3 == 1) options.background = "wait";
  skein::mle_tool::run_mle(options, in, out, err);
  return out.str();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const std::string out = replay(text);
  if (!out.empty() && out.back() != '\n') std::abort();
  if (replay(text) != out) std::abort();
  static_cast<void>(skein::mle_tool::read_types(text));
  return 0;
}
