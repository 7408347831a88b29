// SPDX-License-Identifier: Apache-2.0
// Encoder for OMG CDR version 1, little-endian. Source: OMG RTPS 2.3, 10.2 (encapsulation); CORBA
// 3.3 part 2, 9.3.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "skein/foundation/contract.hpp"

namespace skein {

/// The encapsulation header in front of the values: CDR, little-endian.
inline constexpr std::array<std::uint8_t, 4> kCdrEncapsulation{0, 1, 0, 0};

template <class T>
concept CdrScalar = std::is_arithmetic_v<T> && !std::same_as<T, bool>;

/// The value with its bytes in reverse order.
template <CdrScalar T>
T byte_reversed(T value) {
  auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(value);
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  return std::bit_cast<T>(bytes);
}

/// Writes values one after the other, behind the encapsulation header, each aligned to its size;
/// made without a buffer it only counts bytes. A record is a type for which
/// `visit_fields(visitor, record)` calls `visitor(name, field)` for each of its fields.
/// Enumerations are numbers of 32 bits, sequences have their count in front, arrays do not.
class CdrWriter {
 public:
  CdrWriter() = default;
  /// Writes into `out`. Precondition: `out` has room for all values that follow.
  explicit CdrWriter(std::span<std::uint8_t> out) : out_(out), writes_(true) {}
  std::size_t used() const { return used_; }  ///< [byte]

  template <class T>
  void operator()(const char*, const T& value) {
    put(value);
  }

 private:
  template <CdrScalar T>
  void put(T value) {
    align(sizeof(T));
    if constexpr (std::endian::native == std::endian::big) value = byte_reversed(value);
    raw(&value, sizeof(T));
  }
  void put(bool value) { put(static_cast<std::uint8_t>(value ? 1 : 0)); }
  template <class E>
  requires std::is_enum_v<E>
  void put(E value) { put(static_cast<std::uint32_t>(value)); }
  void put(const std::string& value) {
    put(static_cast<std::uint32_t>(value.size() + 1));
    raw(value.c_str(), value.size() + 1);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    for (const T& value : values) put(value);
  }
  template <class T, std::size_t N>
  void put(const std::array<T, N>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  requires requires(CdrWriter& writer, const T& record) { visit_fields(writer, record); }
  void put(const T& record) { visit_fields(*this, record); }

  void align(std::size_t size) {
    static constexpr std::array<std::uint8_t, 8> kPadding{};
    raw(kPadding.data(), (size - used_ % size) % size);
  }
  void raw(const void* data, std::size_t size) {
    if (writes_ && size > 0) {
      SKEIN_EXPECTS(used_ + size <= out_.size());
      std::memcpy(out_.data() + used_, data, size);
    }
    used_ += size;
  }

  std::span<std::uint8_t> out_;
  std::size_t used_ = 0;  ///< bytes behind the encapsulation header, where alignment begins
  bool writes_ = false;
};

}  // namespace skein
