// SPDX-License-Identifier: Apache-2.0
#include "team_needs.hpp"

#include "skein/foundation/overloaded.hpp"

namespace skein::translation {

using interaction::Relation;
using interaction::Requirement;

static_assert(static_cast<int>(wire::TeamNeedForm::kNeedLess) == static_cast<int>(Relation::kLess));
static_assert(static_cast<int>(wire::TeamNeedForm::kNeedGreater) ==
              static_cast<int>(Relation::kGreater));

wire::TeamNeed to_wire(const Requirement& need) {
  wire::TeamNeed result;
  result.capability = need.capability;
  std::visit(Overloaded{[&](std::monostate) { result.form = wire::TeamNeedForm::kNeedAny; },
                        [&](const std::string& value) {
                          result.form = wire::TeamNeedForm::kNeedValue;
                          result.value = value;
                        },
                        [&](const Requirement::Bound& bound) {
                          result.form = static_cast<wire::TeamNeedForm>(bound.relation);
                          result.figure = bound.value;
                        }},
             need.value);
  return result;
}

Requirement from_wire(const wire::TeamNeed& need) {
  Requirement result{need.capability, std::monostate()};
  if (need.form == wire::TeamNeedForm::kNeedValue) {
    result.value = need.value;
  } else if (need.form != wire::TeamNeedForm::kNeedAny) {
    result.value = Requirement::Bound{static_cast<Relation>(need.form), need.figure};
  }
  return result;
}

}  // namespace skein::translation
