// SPDX-License-Identifier: Apache-2.0
// Source: OMG RTPS 2.3, 10.2 (encapsulation); CORBA 3.3 part 2, 9.3.
#include "skein/ros2/cdr.hpp"

#include <bit>
#include <cstring>
#include <type_traits>

namespace skein::ros2 {

namespace {

constexpr std::size_t kEncapsulation = 4;

/// Each number at a multiple of its size, counted from behind the encapsulation.
class Writer {
 public:
  Writer() : bytes_{0, 1, 0, 0} {}

  template <class T>
  requires std::is_arithmetic_v<T>
  void put(T value) {
    static_assert(std::endian::native == std::endian::little);
    while ((bytes_.size() - kEncapsulation) % sizeof(T) != 0) bytes_.push_back(0);
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(T));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
  }
  void put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  template <class T, std::size_t N>
  void put(const std::array<T, N>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    for (const T& value : values) put(value);
  }
  template <class T>
  requires requires(const T& message) { message.fields(); }
  void put(const T& message) {
    std::apply([this](const auto&... field) { (put(field), ...); }, message.fields());
  }

  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

}  // namespace

Bytes to_cdr(const Message& message) {
  Writer writer;
  std::visit([&](const auto& one) { writer.put(one); }, message);
  return writer.take();
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
