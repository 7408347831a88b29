// SPDX-License-Identifier: Apache-2.0
// The fields of a wire struct, told once and visited by what treats all of them alike; and what
// enumerations of the wire have in common.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

/// Plain C++ images of the IDL types, with the same fields in the same order, written by
/// idl/generate_wire.py. They are what crosses a channel, not what decisions are made of: the shell
/// of each node converts.
/// Conventions of all of them: positions are metres in the scenario's local frame, east north up;
/// angles are radians counter-clockwise from east; times are nanoseconds of mission time.
namespace skein::wire {

inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
/// Of an instant that may be absent: it is.
inline constexpr std::int64_t kNoInstant = std::numeric_limits<std::int64_t>::min();

/// Every enumeration of the wire names its first value past the end, `kCount`: a value at or above
/// it is malformed. `names_of(E)` gives the names of the others, in order.
template <class E>
concept WireEnum = std::is_enum_v<E> && requires {
  E::kCount;
};

/// The name of an enumerator; "?" if out of range.
template <WireEnum E>
constexpr std::string_view name_of(E value) {
  return value < E::kCount ? names_of(value)[static_cast<std::size_t>(value)] : "?";
}

/// A struct declared with SKEIN_WIRE_FIELDS.
template <class T>
inline constexpr bool kIsRecord = false;

/// Two structs that only differ in how a field is reached, as in what the IDL compilers generate:
/// by an accessor `field()`, as a member, or (the header, which is a base in the IDL) as the base
/// itself, which is the member `parent` in C.
#define SKEIN_WIRE_PAIR(field)                   \
  if constexpr (requires { other.field(); })     \
    visitor(#field, self.field, other.field());  \
  else if constexpr (requires { other.field; })  \
    visitor(#field, self.field, other.field);    \
  else if constexpr (requires { other.parent; }) \
    visitor(#field, self.field, other.parent);   \
  else                                           \
    visitor(#field, self.field, other);

#define SKEIN_WIRE_VISIT(field) visitor(#field, self.field);

#define SKEIN_WIRE_PARENS ()
#define SKEIN_WIRE_EXPAND(...) \
  SKEIN_WIRE_EXPAND2(SKEIN_WIRE_EXPAND2(SKEIN_WIRE_EXPAND2(__VA_ARGS__)))
#define SKEIN_WIRE_EXPAND2(...) \
  SKEIN_WIRE_EXPAND1(SKEIN_WIRE_EXPAND1(SKEIN_WIRE_EXPAND1(__VA_ARGS__)))
#define SKEIN_WIRE_EXPAND1(...) \
  SKEIN_WIRE_EXPAND0(SKEIN_WIRE_EXPAND0(SKEIN_WIRE_EXPAND0(__VA_ARGS__)))
#define SKEIN_WIRE_EXPAND0(...) __VA_ARGS__
#define SKEIN_WIRE_EACH(macro, ...) \
  __VA_OPT__(SKEIN_WIRE_EXPAND(SKEIN_WIRE_EACH_STEP(macro, __VA_ARGS__)))
#define SKEIN_WIRE_EACH_STEP(macro, first, ...) \
  macro(first) __VA_OPT__(SKEIN_WIRE_EACH_AGAIN SKEIN_WIRE_PARENS(macro, __VA_ARGS__))
#define SKEIN_WIRE_EACH_AGAIN() SKEIN_WIRE_EACH_STEP

/// Declares the fields of `Type` in the order of its IDL definition. Gives
/// - `visit_fields(v, object)`: `v("name", object.name)` for each field, const or not;
/// - `visit_pairs(v, object, other)`: `v("name", object.name, other's name)` for each field, where
///   `other` is the struct that an IDL compiler made of the same definition.
#define SKEIN_WIRE_FIELDS(Type, ...)                                        \
  template <>                                                               \
  inline constexpr bool kIsRecord<Type> = true;                             \
  template <class Visitor, class Self>                                      \
  requires std::same_as<std::remove_const_t<Self>, Type>                    \
  constexpr void visit_fields(Visitor&& visitor, Self& self) {              \
    SKEIN_WIRE_EACH(SKEIN_WIRE_VISIT, __VA_ARGS__)                          \
  }                                                                         \
  template <class Visitor, class Self, class Other>                         \
  requires std::same_as<std::remove_const_t<Self>, Type>                    \
  constexpr void visit_pairs(Visitor&& visitor, Self& self, Other& other) { \
    SKEIN_WIRE_EACH(SKEIN_WIRE_PAIR, __VA_ARGS__)                           \
  }

}  // namespace skein::wire
