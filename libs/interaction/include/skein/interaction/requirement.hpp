// SPDX-License-Identifier: Apache-2.0
// What is asked of a UAV.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/config/reader.hpp"

namespace skein::interaction {

enum class Relation : std::uint8_t { kLess, kAtMost, kEqual, kAtLeast, kGreater };
/// "<", "≤", "=", "≥", ">".
std::string_view to_text(Relation relation);

/// What a UAV must have to play a role, or for a task: a capability (`hovering`), one with a value
/// (`camera: visible`), or a figure (`endurance >= 900`). Source: T def. V.1.
struct Requirement {
  struct Bound {
    Relation relation = Relation::kAtLeast;
    double value = 0;
    bool operator==(const Bound&) const = default;
  };
  std::string capability;
  std::variant<std::monostate, std::string, Bound> value;
  bool operator==(const Requirement&) const = default;
};

using Requirements = std::vector<Requirement>;

/// A list of `hovering`, `{camera: visible}` and `endurance >= 900`; what is no condition is
/// reported.
std::vector<Requirement> read_requirements(const config::Reader& reader);

}  // namespace skein::interaction
