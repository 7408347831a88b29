// SPDX-License-Identifier: Apache-2.0
// Functions of the host about what is left of a task that was begun.
#include <algorithm>

#include "planning/host_services.hpp"
#include "planning/terms.hpp"

namespace skein::supervisor {

using htn::kNil;
using htn::Term;
using htn::TermStore;
using world::Vector3;

using Value = Result<Term, Failure>;

/// (compute-rest FROM ZONE DEVICE BEFORE (LOC…) WHEN): the motion along what is left of a way over
/// the zone that was flown with the device BEFORE; nil, without a sentence, when it is to be
/// planned anew.
Value PlannerHost::Services::rest(TermStore& store, Arguments arguments) {
  const auto from = gazetteer_.place(store, arguments[0]);
  const auto* device = gazetteer_.sensor(text_of(store, arguments[2]));
  const auto* before = gazetteer_.sensor(text_of(store, arguments[3]));
  const std::vector<Vector3> way = locations_of(store, arguments[4]);
  if (!from || device == nullptr || before == nullptr || way.size() < 2) return kNil;
  if (gazetteer_.zone(text_of(store, arguments[1])) == nullptr) return kNil;
  const auto motion =
      refinery_.sweeps.rest(*from, way, *device, *before, departure(store, arguments[5]));
  return motion ? flight(store, motion, "rest") : Value(kNil);
}

/// (not-reached PLACES (LOC…)): those of the places where none of the locations is.
Value PlannerHost::Services::not_reached(TermStore& store, Arguments arguments) {
  if (!store.is_list(arguments[0])) return failure("a list of places is expected");
  const std::vector<Vector3> reached = locations_of(store, arguments[1]);
  std::vector<Term> left;
  for (const Term term : store.items(arguments[0])) {
    const auto at = gazetteer_.place(store, term);
    const bool was_there =
        at && std::any_of(reached.begin(), reached.end(), [&](const Vector3& one) {
          return (gazetteer_.flown_to(*at) - one).norm() <= vicinity(gazetteer_);
        });
    if (!was_there) left.push_back(term);
  }
  return store.list(left);
}

}  // namespace skein::supervisor
