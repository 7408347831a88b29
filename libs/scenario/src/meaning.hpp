// SPDX-License-Identifier: Apache-2.0
// The fingerprint of everything that a value says.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "skein/config/value.hpp"
#include "skein/foundation/fields.hpp"
#include "skein/foundation/fingerprint.hpp"
#include "skein/functional/parameters.hpp"
#include "skein/team/roster.hpp"
#include "skein/world/world_file.hpp"

namespace skein::scenario {

/// Puts values into a fingerprint: numbers, texts, times, ids, vectors, lists, maps, options,
/// variants, and structs of these with all of their fields. What is none of them does not compile.
class Meaning {
 public:
  template <class... Values>
  Meaning& all(const Values&... values) {
    (put(values), ...);
    return *this;
  }
  /// A list whose order says nothing, by the names of its members.
  template <class Named>
  Meaning& by_name(std::vector<Named> list) {
    std::ranges::sort(list, {}, &Named::name);
    put(list);
    return *this;
  }
  std::uint64_t value() const { return print_.value(); }

 private:
  template <class T>
  static constexpr bool kIsNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;
  template <class T>
  static constexpr bool kIsTime = requires(const T& one) {
    one.count();
  };
  template <class T>
  static constexpr bool kIsId = requires(const T& one) {
    one.value();
  };
  template <class T>
  static constexpr bool kIsVector = requires(const T& one) {
    T::SizeAtCompileTime;
  };

  /// To 32 binary digits: what a reader computes (the height of the ground under a place) may
  /// differ in the last ones from processor to processor. Likewise what should be zero.
  static double rounded(double value) {
    constexpr int kDigits = 32;
    constexpr double kNothing = 1e-12;
    if (!std::isfinite(value)) return value;
    if (std::abs(value) < kNothing) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, kDigits)), exponent - kDigits);
  }

  // Where something stood in a file.
  void put(const world::Mark& /*mark*/) {}
  void put(const functional::Parameters& parameters) { by_name(parameters.all()); }
  void put(const team::Roster& roster) { put(roster.names()); }
  void put(const std::string& text) { print_.put(std::string_view(text)); }
  void put(std::string_view text) { print_.put(text); }

  // A table that is interpreted elsewhere: the order of its keys says nothing, that of lists does.
  void put(const config::Value& value) {
    put(value.kind);
    put(value.scalar);
    put(value.items);
    std::vector<const config::Entry*> entries;
    for (const config::Entry& entry : value.entries) entries.push_back(&entry);
    std::ranges::sort(entries, {}, [](const config::Entry* entry) { return entry->key; });
    put(entries.size());
    for (const config::Entry* entry : entries) all(entry->key, entry->value);
  }

  template <class T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class T>
  void put(const std::shared_ptr<T>& value) {
    put(value != nullptr);
    if (value) put(*value);
  }
  template <class... Ts>
  void put(const std::variant<Ts...>& value) {
    put(value.index());
    std::visit([this](const auto& one) { put(one); }, value);
  }
  template <class A, class B>
  void put(const std::pair<A, B>& value) {
    all(value.first, value.second);
  }

  template <class T>
  void put(const T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      print_.put(rounded(static_cast<double>(value)));
    } else if constexpr (kIsNumber<T>) {
      print_.put(static_cast<std::uint64_t>(value));
    } else if constexpr (kIsTime<T> && !std::ranges::range<T>) {
      put(value.count());
    } else if constexpr (kIsVector<T>) {
      for (int i = 0; i < value.size(); ++i) put(value(i));
    } else if constexpr (std::ranges::range<T>) {
      put(static_cast<std::uint64_t>(std::ranges::distance(value)));
      for (const auto& one : value) put(one);
    } else if constexpr (kIsId<T>) {
      put(value.value());
    } else {
      for_each_field(value, [this](const auto& field) { put(field); });
    }
  }

  Fingerprint print_;
};

}  // namespace skein::scenario
