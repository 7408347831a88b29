// SPDX-License-Identifier: Apache-2.0
// Requests to a UAV.
#pragma once

#include <cstdint>
#include <variant>

#include "skein/executive/input.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/high_level_task.hpp"

namespace skein::mission {

/// A request to a UAV's executive (T III.2.1, spec 2.3), on board or at the ground, or to its
/// decision node (spec 1.2, 6.2).
using Request = std::variant<executive::Start, executive::Abort, executive::ProcessMessage,
                             executive::UpdateConditions, executive::Suppress, UnitMission,
                             CancelGoals, ChangeDegree, ChangeWorld>;

/// In the order of the alternatives of Request.
enum class RequestKind : std::uint8_t {
  kStart,
  kAbort,
  kProcessMessage,
  kUpdateConditions,
  kSuppress,
  kMission,
  kCancel,
  kDegree,
  kWorld,
};

inline RequestKind kind_of(const Request& request) {
  static_assert(std::variant_size_v<Request> == static_cast<int>(RequestKind::kWorld) + 1);
  return static_cast<RequestKind>(request.index());
}

/// Id of the task or the unit mission that the request refers to; 0: none, or several.
std::uint64_t id_of(const Request& request);

}  // namespace skein::mission
