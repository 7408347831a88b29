// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/refinement.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::refiners {

std::string_view to_text(RefusalKind kind) {
  switch (kind) {
    case RefusalKind::kBadQuery:
      return "bad-query";
    case RefusalKind::kBlocked:
      return "blocked";
    case RefusalKind::kUnreachable:
      return "unreachable";
    case RefusalKind::kBeyondVehicle:
      return "beyond-vehicle";
    case RefusalKind::kNoContact:
      return "no-contact";
    case RefusalKind::kNotPerceivable:
      return "not-perceivable";
    case RefusalKind::kBudgetExhausted:
      return "budget-exhausted";
  }
  SKEIN_ENSURES(false);
}

}  // namespace skein::refiners
