// SPDX-License-Identifier: Apache-2.0
// Strong integer identifiers: two kinds of id never mix.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <string>

namespace skein {

/// An identifier distinguished by its tag: `using TaskId = Id<struct TaskIdTag, std::uint64_t>`.
/// Ordered by value; the default is zero, a value like any other.
template <class Tag, class Representation = std::uint32_t>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(Representation value) : value_(value) {}
  constexpr Representation value() const { return value_; }
  constexpr auto operator<=>(const Id&) const = default;

 private:
  Representation value_ = 0;
};

template <class Tag, class Representation>
std::string to_text(Id<Tag, Representation> id) {
  return std::to_string(id.value());
}

}  // namespace skein

template <class Tag, class Representation>
struct std::hash<skein::Id<Tag, Representation>> {
  std::size_t operator()(skein::Id<Tag, Representation> id) const noexcept {
    return std::hash<Representation>{}(id.value());
  }
};
