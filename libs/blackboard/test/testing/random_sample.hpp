// SPDX-License-Identifier: Apache-2.0
// Well-formed samples of every slot, from a seed.
#pragma once

#include <concepts>
#include <string>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/random.hpp"

namespace skein::blackboard::testing {

/// Fills any field of a wire struct with something legal.
class RandomFields {
 public:
  explicit RandomFields(Random& random) : random_(random) {}

  template <class T>
  void operator()(const char*, T& value) {
    fill(value);
  }

 private:
  template <class T>
  requires std::is_integral_v<T>
  void fill(T& value) { value = static_cast<T>(random_.bits()); }
  void fill(bool& value) { value = random_.chance(0.5); }
  template <std::floating_point T>
  void fill(T& value) {
    value = static_cast<T>(random_.normal() * 1e3);
  }
  void fill(std::string& value) {
    static constexpr auto kPieces = std::to_array<std::string_view>(
        {"a", "B", " ", "\"", "\\", "\n", "é", "∀", "🚁", "goto", "{", "0"});
    value.clear();
    for (std::uint64_t n = random_.below(9); n > 0; --n) {
      value += kPieces[random_.below(kPieces.size())];
    }
  }
  template <wire::WireEnum E>
  void fill(E& value) {
    value = static_cast<E>(random_.below(static_cast<std::uint64_t>(E::kCount)));
  }
  template <class T>
  void fill(std::vector<T>& values) {
    values.resize(random_.below(4));
    for (T& value : values) fill(value);
  }
  template <class T>
  requires wire::kIsRecord<T>
  void fill(T& record) { visit_fields(*this, record); }

  Random& random_;
};

template <class T>
T random_value(Random& random) {
  T value;
  RandomFields fields(random);
  visit_fields(fields, value);
  return value;
}

/// Calls `f.template operator()<T>()` for the type of every slot.
template <class F>
void for_each_slot_type(F&& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (f.template operator()<std::variant_alternative_t<I, wire::SampleVariant>>(), ...);
  }
  (std::make_index_sequence<wire::kSlotCount>{});
}

}  // namespace skein::blackboard::testing
