// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/request.hpp"

#include "skein/foundation/overloaded.hpp"

namespace skein::mission {

std::uint64_t id_of(const Request& request) {
  return std::visit(
      Overloaded{[](const executive::Start& it) { return it.task.id.value(); },
                 [](const executive::ProcessMessage&) -> std::uint64_t { return 0; },
                 [](const UnitMission& it) -> std::uint64_t { return it.id.value(); },
                 [](const CancelGoals& it) -> std::uint64_t { return it.mission.value(); },
                 [](const ChangeDegree&) -> std::uint64_t { return 0; },
                 [](const ChangeWorld&) -> std::uint64_t { return 0; },
                 [](const auto& it) { return it.id.value(); }},
      request);
}

}  // namespace skein::mission
