// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/wire_layout.hpp"

#include <utility>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/fingerprint.hpp"

namespace skein::wire {
namespace {

template <class T>
std::string layout_of();

template <WireEnum E>
std::string enumerators() {
  std::string names;
  for (const std::string_view name : names_of(E{}))
    names += (names.empty() ? "" : "|") + std::string(name);
  return "enum(" + names + ")";
}

template <class Record>
std::string fields() {
  const Record record;
  std::string text = "{";
  visit_fields(
      [&]<class Field>(const char* name, const Field&) {
        text += std::string(name) + " " + layout_of<Field>() + "; ";
      },
      record);
  return text + "}";
}

template <class T>
std::string number() {
  const char kind = std::is_floating_point_v<T> ? 'f' : std::is_signed_v<T> ? 'i' : 'u';
  return kind + std::to_string(8 * sizeof(T));
}

template <class T>
std::string layout_of() {
  if constexpr (kIsRecord<T>) {
    return fields<T>();
  } else if constexpr (WireEnum<T>) {
    return enumerators<T>();
  } else if constexpr (std::same_as<T, std::string>) {
    return "string";
  } else if constexpr (std::same_as<T, bool>) {
    return "bool";
  } else if constexpr (std::is_arithmetic_v<T>) {
    return number<T>();
  } else {
    std::string count;  // of an array's elements; a sequence may have any number
    if constexpr (requires { std::tuple_size<T>::value; })
      count = std::to_string(std::tuple_size_v<T>);
    return layout_of<typename T::value_type>() + "[" + count + "]";
  }
}

template <std::size_t... slots>
std::string all(std::index_sequence<slots...>) {
  std::string text;
  ((text += std::string(slot_name(static_cast<Slot>(slots))) + " " +
            layout_of<std::variant_alternative_t<slots, SampleVariant>>() + "\n"),
   ...);
  return text;
}

}  // namespace

std::string layout() { return all(std::make_index_sequence<kSlotCount>{}); }

const std::string& layout_mark() {
  static const std::string mark = fingerprint_text(Fingerprint().put(layout()).value());
  return mark;
}

}  // namespace skein::wire
