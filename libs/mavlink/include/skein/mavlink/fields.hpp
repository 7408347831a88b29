// SPDX-License-Identifier: Apache-2.0
// What a message type says of its fields, and what follows from that: size, checksum, encoding.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "skein/mavlink/checksum.hpp"

namespace skein::mavlink {

/// A member of a message, as the definitions of MAVLink name it.
template <class Message, class Value>
struct Field {
  std::string_view name;
  Value Message::*member;
  bool is_extension = false;  ///< came after the message was first published
};
template <class Message, class Value>
constexpr Field<Message, Value> field(std::string_view name, Value Message::*member) {
  return {name, member, false};
}
template <class Message, class Value>
constexpr Field<Message, Value> extension(std::string_view name, Value Message::*member) {
  return {name, member, true};
}

template <class Value>
struct ValueTraits {
  using Element = Value;
  static constexpr std::size_t kCount = 1;
  static constexpr bool kIsArray = false;
};
template <class Value, std::size_t count>
struct ValueTraits<std::array<Value, count>> {
  using Element = Value;
  static constexpr std::size_t kCount = count;
  static constexpr bool kIsArray = true;
};

/// As the definitions write it.
template <class Element>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<Element, float>) return "float";
  if constexpr (std::is_same_v<Element, char>) return "char";
  if constexpr (std::is_same_v<Element, std::uint8_t>) return "uint8_t";
  if constexpr (std::is_same_v<Element, std::int8_t>) return "int8_t";
  if constexpr (std::is_same_v<Element, std::uint16_t>) return "uint16_t";
  if constexpr (std::is_same_v<Element, std::int16_t>) return "int16_t";
  if constexpr (std::is_same_v<Element, std::uint32_t>) return "uint32_t";
  if constexpr (std::is_same_v<Element, std::int32_t>) return "int32_t";
}

/// What goes over the wire of one message type.
struct Layout {
  std::uint8_t length = 0;     ///< of the payload, extensions included [bytes]
  std::uint8_t crc_extra = 0;  ///< tells definitions apart that differ
  bool is_ordered = true;      ///< fields stand in the order of the wire
};

/// Computed from the fields, which are listed in the order of the wire: largest elements first,
/// extensions last. Source: mavlink.io/en/guide/serialization.html#crc_extra.
template <class Message>
constexpr Layout layout_of() {
  Layout layout;
  Checksum crc;
  crc.add(Message::kName);
  crc.add(" ");
  std::size_t last = 8;
  std::size_t length = 0;
  const auto take = [&]<class Value>(const Field<Message, Value>& one) {
    using Traits = ValueTraits<Value>;
    constexpr std::size_t kSize = sizeof(typename Traits::Element);
    length += kSize * Traits::kCount;
    if (one.is_extension) return;
    layout.is_ordered = layout.is_ordered && kSize <= last;
    last = kSize;
    crc.add(type_name<typename Traits::Element>());
    crc.add(" ");
    crc.add(one.name);
    crc.add(" ");
    if (Traits::kIsArray) crc.add(static_cast<std::uint8_t>(Traits::kCount));
  };
  std::apply([&](const auto&... one) { (take(one), ...); }, Message::fields());
  layout.length = static_cast<std::uint8_t>(length);
  layout.crc_extra = static_cast<std::uint8_t>((crc.value() & 0xffU) ^ (crc.value() >> 8U));
  return layout;
}

/// Calls visit(name, value) for each field, in the order of the wire.
template <class Message, class Visit>
void visit_fields(Message& message, Visit&& visit) {
  std::apply([&](const auto&... one) { (visit(one.name, message.*(one.member)), ...); },
             std::remove_const_t<Message>::fields());
}

}  // namespace skein::mavlink
