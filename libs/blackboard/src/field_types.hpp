// SPDX-License-Identifier: Apache-2.0
// The wire types as data: encoding, checks, text and layout interpret these tables instead of being
// compiled for each struct.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "skein/blackboard/wire.hpp"

namespace skein::wire {

struct FieldType;

struct Field {
  const char* name = "";
  std::size_t offset = 0;  ///< [byte] from the start of its record
  const FieldType* type = nullptr;
};

enum class FieldKind : std::uint8_t {
  kBoolean,
  kUnsigned,
  kSigned,
  kReal,
  kText,
  kEnumeration,
  kRecord,
  kSequence
};

/// The type of a field and the access to its values. All void pointers are to values of this type.
struct FieldType {
  FieldKind kind = FieldKind::kRecord;
  std::size_t size = 0;                     ///< [byte] in memory
  std::span<const std::string_view> names;  ///< kEnumeration: of its values, in order
  std::span<const Field> fields;            ///< kRecord: in the order of the IDL
  const FieldType* element = nullptr;       ///< kSequence
  // kSequence, a std::vector: its length, its first element, and a change of its length.
  std::size_t (*count)(const void*) = nullptr;
  const void* (*elements)(const void*) = nullptr;
  void (*resize)(void*, std::size_t) = nullptr;
};

const FieldType& type_of(Slot slot);
const FieldType& type_of_header();

/// The record that the sample holds.
const void* record_of(const Sample& sample);
inline void* record_of(Sample& sample) {
  return const_cast<void*>(record_of(std::as_const(sample)));
}

inline const void* at(const void* start, std::size_t offset) {
  return static_cast<const std::byte*>(start) + offset;
}
inline void* at(void* start, std::size_t offset) { return static_cast<std::byte*>(start) + offset; }

/// The value at `address`, which is of a type that has the size of T.
template <class T>
T loaded(const void* address) {
  T value;
  std::memcpy(&value, address, sizeof(T));
  return value;
}
inline const std::string& text_at(const void* address) {
  return *static_cast<const std::string*>(address);
}

}  // namespace skein::wire
