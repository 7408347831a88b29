// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/deliberation.hpp"

#include "skein/foundation/overloaded.hpp"

namespace skein::supervisor {

DeliberationResult deliberate(const DeliberationRequest& request) {
  return std::visit(
      Overloaded{[](const InsertionRequest& one) { return DeliberationResult(insert_tasks(one)); },
                 [](const RepairRequest& one) { return DeliberationResult(repair_plan(one)); }},
      request);
}

}  // namespace skein::supervisor
