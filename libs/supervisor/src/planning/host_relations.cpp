// SPDX-License-Identifier: Apache-2.0
#include "planning/host_relations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flight/flight_times.hpp"
#include "planning/terms.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein::supervisor {

using htn::kNil;
using htn::Term;
using htn::TermStore;
using world::Vector3;

namespace {

/// Constraints and intervals agree but for rounding [s].
constexpr double kRounding = 1e-6;

/// Bounds in the order of the language: start before, start after, end before, end after.
std::optional<double> bound(const TermStore& store, Term constraints, std::size_t at) {
  if (constraints == kNil || !store.is_list(constraints)) return std::nullopt;
  const std::vector<Term> all = store.items(constraints);
  return at < all.size() ? number_of(store, all[at]) : std::nullopt;
}

}  // namespace

HostValue HostRelations::target_of(TermStore& store, HostArguments arguments) {
  const auto at = names_.place(store, arguments[0]);
  if (!at || !gazetteer().on_ground(*at)) return kNil;
  return target_term(store, *at);
}

HostValue HostRelations::entry(TermStore& store, HostArguments arguments) {
  const auto at = names_.place(store, arguments[0]);
  return at ? location_term(store, gazetteer().flown_to(*at)) : kNil;
}

HostValue HostRelations::is_at(TermStore& store, HostArguments arguments) {
  const auto from = names_.place(store, arguments[0]), to = names_.place(store, arguments[1]);
  if (!from || !to) return kNil;
  return TermStore::boolean((gazetteer().flown_to(*to) - *from).norm() <= vicinity(gazetteer()));
}

HostValue HostRelations::is_over(TermStore& store, HostArguments arguments) {
  const auto from = names_.place(store, arguments[0]), to = names_.place(store, arguments[1]);
  if (!from || !to) return kNil;
  return TermStore::boolean((*to - *from).head<2>().norm() <= vicinity(gazetteer()));
}

/// (not-reached PLACES (LOC…)): those of the places where none of the locations is.
HostValue HostRelations::not_reached(TermStore& store, HostArguments arguments) {
  if (!store.is_list(arguments[0])) return failure("a list of places is expected");
  const std::vector<Vector3> reached = locations_of(store, arguments[1]);
  std::vector<Term> left;
  for (const Term term : store.items(arguments[0])) {
    const auto at = gazetteer().place(store, term);
    const bool was_there =
        at && std::any_of(reached.begin(), reached.end(), [&](const Vector3& one) {
          return (gazetteer().flown_to(*at) - one).norm() <= vicinity(gazetteer());
        });
    if (!was_there) left.push_back(term);
  }
  return store.list(left);
}

/// In the order of the team, those that are not in it after them in the order given.
std::vector<std::string> HostRelations::team(const TermStore& store, HostArguments lists,
                                             std::vector<std::string> given) const {
  for (const Term list : lists) {
    if (!store.is_list(list)) continue;
    for (const Term term : store.items(list)) {
      const std::string name = text_of(store, term);
      const bool known = std::any_of(given.begin(), given.end(),
                                     [&](const auto& one) { return same_name(one, name); });
      if (!known && !name.empty()) given.push_back(name);
    }
  }
  const auto& order = gazetteer().knowledge().team;
  std::stable_sort(given.begin(), given.end(), [&](const auto& a, const auto& b) {
    const auto rank = [&](const std::string& name) {
      return std::find_if(order.begin(), order.end(),
                          [&](const auto& one) { return same_name(one, name); }) -
             order.begin();
    };
    return rank(a) < rank(b);
  });
  return given;
}

std::vector<std::string> HostRelations::who_meet(const TermStore& store,
                                                 HostArguments lists) const {
  return team(store, lists, {gazetteer().knowledge().uav});
}

HostValue HostRelations::with_me(TermStore& store, HostArguments arguments) {
  std::vector<Term> names;
  for (const std::string& name : who_meet(store, arguments)) names.push_back(store.symbol(name));
  return store.list(names);
}

/// (in-time WHAT ORIGIN START DURATION TIME-CONSTRAINTS): whether the latest start and end keep
/// the bounds.
HostValue HostRelations::in_time(TermStore& store, HostArguments arguments) {
  const auto start = seconds_of(store, arguments[2]), duration = seconds_of(store, arguments[3]);
  if (!start || !duration) return failure("start and duration must be ((num LEAST) (num MOST))");
  const auto at = [&](double s) {
    return std::isinf(s) ? std::string("an unknown time")
                         : in_seconds(origin_ + Duration::seconds(s));
  };
  bool fits = true;
  const auto check = [&](std::size_t which, double least, double most, const std::string& verb) {
    const auto before = bound(store, arguments[4], which);
    if (!before || most <= *before + kRounding) return;
    fits = false;
    names_.refuse(text_of(store, arguments[0]) + " of goal " + text_of(store, arguments[1]) + " " +
                  verb + "s between " + at(least) + " and " + at(most) + ", but must " + verb +
                  " before " + at(*before));
  };
  check(0, start->least, start->most, "start");
  check(2, start->least + duration->least, start->most + duration->most, "end");
  return TermStore::boolean(fits);
}

}  // namespace skein::supervisor
