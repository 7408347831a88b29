// SPDX-License-Identifier: Apache-2.0
#include "routes.hpp"

#include <array>

namespace skein::decision_node {

namespace {

using mission::RequestKind;

constexpr const char* kAtDegree1 = "at degree 1 the ground station runs the plan";

// Missions have a least degree too, with reasons of their own: see Deliberation.
constexpr std::array<Route, 9> kRoutes{{
    {RequestKind::kStart, Addressee::kExecution, 2, kAtDegree1},
    {RequestKind::kAbort, Addressee::kExecution, 2, kAtDegree1},
    {RequestKind::kProcessMessage, Addressee::kExecution, 2, kAtDegree1},
    {RequestKind::kUpdateConditions, Addressee::kExecution, 2, kAtDegree1},
    {RequestKind::kSuppress, Addressee::kExecution, 2, kAtDegree1},
    {RequestKind::kMission, Addressee::kDeliberation, 1, ""},
    {RequestKind::kCancel, Addressee::kDeliberation, 1, ""},
    {RequestKind::kDegree, Addressee::kAutonomy, 1, ""},
    {RequestKind::kWorld, Addressee::kDeliberation, 1, ""},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kRoutes.size(); ++i) {
    if (static_cast<std::size_t>(kRoutes[i].kind) != i) return false;
  }
  return kRoutes.size() == std::variant_size_v<mission::Request>;
}
static_assert(in_order());

}  // namespace

const Route& route_of(RequestKind kind) { return kRoutes[static_cast<std::size_t>(kind)]; }

}  // namespace skein::decision_node
