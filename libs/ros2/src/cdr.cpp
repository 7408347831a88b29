// SPDX-License-Identifier: Apache-2.0
// Messages as CDR, by the writer that the wire of Skein has.
#include "skein/ros2/cdr.hpp"

#include <algorithm>

#include "skein/foundation/cdr_writer.hpp"

namespace skein::ros2 {

namespace {

constexpr std::size_t kEncapsulation = kCdrEncapsulation.size();

}  // namespace

Bytes to_cdr(const Message& message) {
  return std::visit(
      [](const auto& one) {
        CdrWriter counter;
        visit_fields(counter, one);
        Bytes bytes(kEncapsulation + counter.used());
        std::ranges::copy(kCdrEncapsulation, bytes.begin());
        CdrWriter writer{std::span(bytes).subspan(kEncapsulation)};
        visit_fields(writer, one);
        return bytes;
      },
      message);
}

Result<std::string, Failure> text_of(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kHead = kEncapsulation + 4;
  if (bytes.size() < kHead || bytes[0] != 0 || bytes[1] > 1) return failure("not CDR version 1");
  const auto byte = [&](std::size_t at) { return std::uint32_t{bytes[kEncapsulation + at]}; };
  const std::uint32_t size = bytes[1] == 1 ? byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24
                                           : byte(3) | byte(2) << 8 | byte(1) << 16 | byte(0) << 24;
  if (size > kLongestText + 1) return failure("too long");
  if (size > bytes.size() - kHead) return failure("cut short");
  if (size == 0) return std::string();  // as some write an empty text
  if (bytes[kHead + size - 1] != 0) return failure("not terminated");
  const auto* text = reinterpret_cast<const char*>(bytes.data() + kHead);
  return std::string(text, size - 1);
}

}  // namespace skein::ros2
