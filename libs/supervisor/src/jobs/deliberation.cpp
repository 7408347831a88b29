// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/deliberation.hpp"

#include "skein/foundation/overloaded.hpp"

namespace skein::supervisor {

DeliberationResult deliberate(const DeliberationRequest& request,
                              std::function<bool()> time_is_up) {
  const auto answered =
      Overloaded{[](const InsertionRequest& one) { return DeliberationResult(insert_tasks(one)); },
                 [](const RepairRequest& one) { return DeliberationResult(repair_plan(one)); }};
  if (!time_is_up) return std::visit(answered, request);
  DeliberationRequest timed = request;
  std::visit([&](auto& one) { one.base.budget.time_is_up = std::move(time_is_up); }, timed);
  return std::visit(answered, timed);
}

}  // namespace skein::supervisor
