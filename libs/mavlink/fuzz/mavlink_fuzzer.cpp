// SPDX-License-Identifier: Apache-2.0
// A stream in one piece and byte by byte gives the same frames; each has a message, and what we
// make of that reads the same again.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "skein/mavlink/parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace mavlink = skein::mavlink;
  mavlink::Parser whole, slow;
  const auto frames = whole.take({data, size});
  std::vector<mavlink::Frame> slowly;
  for (std::size_t i = 0; i < size; ++i) {
    for (mavlink::Frame& one : slow.take({data + i, 1})) slowly.push_back(std::move(one));
  }
  if (frames != slowly) std::abort();
  for (const mavlink::Frame& one : frames) {
    const auto message = mavlink::to_message(one);
    if (!message) std::abort();
    const mavlink::Frame again = mavlink::to_frame(*message, one.from, one.sequence);
    const auto read = mavlink::to_message(again);
    if (!read || mavlink::to_frame(*read, one.from, one.sequence) != again) std::abort();
  }
  return 0;
}
