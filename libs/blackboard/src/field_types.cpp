// SPDX-License-Identifier: Apache-2.0
#include "field_types.hpp"

#include <array>
#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace skein::wire {
namespace {

template <class T>
const FieldType& type_of_value();

FieldType plain(FieldKind kind, std::size_t size) {
  FieldType type;
  type.kind = kind;
  type.size = size;
  return type;
}

/// Where each field lies is seen from a value, since no struct of the wire has to be of standard
/// layout.
template <class Record>
std::span<const Field> fields_of() {
  static const std::vector<Field> fields = [] {
    std::vector<Field> all;
    const Record record;
    const auto* const start = reinterpret_cast<const std::byte*>(&record);
    visit_fields(
        [&]<class T>(const char* name, const T& field) {
          const auto offset = reinterpret_cast<const std::byte*>(&field) - start;
          all.push_back({name, static_cast<std::size_t>(offset), &type_of_value<T>()});
        },
        record);
    return all;
  }();
  return fields;
}

template <class Sequence>
FieldType sequence() {
  static_assert(!std::same_as<typename Sequence::value_type, bool>,
                "std::vector<bool> has no elements in memory");
  FieldType type = plain(FieldKind::kSequence, sizeof(Sequence));
  type.element = &type_of_value<typename Sequence::value_type>();
  type.count = [](const void* values) { return static_cast<const Sequence*>(values)->size(); };
  type.elements = [](const void* values) -> const void* {
    return static_cast<const Sequence*>(values)->data();
  };
  type.resize = [](void* values, std::size_t size) {
    static_cast<Sequence*>(values)->resize(size);
  };
  return type;
}

template <class E>
FieldType enumeration() {
  static_assert(sizeof(E) == sizeof(std::uint32_t));
  static constexpr auto kNames = names_of(E{});
  static_assert(kNames.size() == static_cast<std::size_t>(E::kCount));
  FieldType type = plain(FieldKind::kEnumeration, sizeof(E));
  type.names = kNames;
  return type;
}

template <class T>
FieldType described() {
  if constexpr (kIsRecord<T>) {
    FieldType type = plain(FieldKind::kRecord, sizeof(T));
    type.fields = fields_of<T>();
    return type;
  } else if constexpr (WireEnum<T>) {
    return enumeration<T>();
  } else if constexpr (std::same_as<T, std::string>) {
    return plain(FieldKind::kText, sizeof(T));
  } else if constexpr (std::same_as<T, bool>) {
    return plain(FieldKind::kBoolean, sizeof(T));
  } else if constexpr (std::is_floating_point_v<T>) {
    static_assert(std::same_as<T, float> || std::same_as<T, double>);
    return plain(FieldKind::kReal, sizeof(T));
  } else if constexpr (std::is_arithmetic_v<T>) {
    return plain(std::is_signed_v<T> ? FieldKind::kSigned : FieldKind::kUnsigned, sizeof(T));
  } else {
    return sequence<T>();
  }
}

template <class T>
const FieldType& type_of_value() {
  static const FieldType type = described<T>();
  return type;
}

template <std::size_t... slots>
std::array<const FieldType*, kSlotCount> types_of_slots(std::index_sequence<slots...>) {
  return {&type_of_value<std::variant_alternative_t<slots, SampleVariant>>()...};
}

}  // namespace

const FieldType& type_of(Slot slot) {
  static const auto types = types_of_slots(std::make_index_sequence<kSlotCount>{});
  return *types[static_cast<std::size_t>(slot)];
}

const FieldType& type_of_header() { return type_of_value<SampleHeader>(); }

const void* record_of(const Sample& sample) {
  return std::visit([](const auto& record) -> const void* { return &record; }, sample);
}

}  // namespace skein::wire
