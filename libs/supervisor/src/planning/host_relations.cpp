// SPDX-License-Identifier: Apache-2.0
// Functions of the host that need no refiner: where it is, who is who, whether it is in time.
#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/host_services.hpp"
#include "planning/terms.hpp"

namespace skein::supervisor {

using htn::kNil;
using htn::Term;
using htn::TermStore;
using world::Vector3;

namespace {

using Value = Result<Term, Failure>;

/// Beside what it wavers [m].
constexpr double kNear = 2;
/// Constraints and intervals agree but for rounding [s].
constexpr double kRounding = 1e-6;

/// Bounds in the order of the language: start before, start after, end before, end after.
std::optional<double> bound(const TermStore& store, Term constraints, std::size_t at) {
  if (constraints == kNil || !store.is_list(constraints)) return std::nullopt;
  const std::vector<Term> all = store.items(constraints);
  return at < all.size() ? number_of(store, all[at]) : std::nullopt;
}

}  // namespace

double vicinity(const Gazetteer& gazetteer) {
  const world::VehicleModel& vehicle = gazetteer.knowledge().vehicle;
  return kNear + arrival_distance(vehicle, gazetteer.world().wind) +
         (vehicle.hovers ? 0 : vehicle.orbit_radius);
}

Value PlannerHost::Services::is_at(TermStore& store, Arguments arguments) {
  const auto from = place(store, arguments[0]), to = place(store, arguments[1]);
  if (!from || !to) return kNil;
  return TermStore::boolean((gazetteer_.flown_to(*to) - *from).norm() <= vicinity(gazetteer_));
}

Value PlannerHost::Services::is_over(TermStore& store, Arguments arguments) {
  const auto from = place(store, arguments[0]), to = place(store, arguments[1]);
  if (!from || !to) return kNil;
  return TermStore::boolean((*to - *from).head<2>().norm() <= vicinity(gazetteer_));
}

/// In the order of the team, those that are not in it after them in the order given.
std::vector<std::string> PlannerHost::Services::team(const TermStore& store,
                                                     Arguments lists) const {
  std::vector<std::string> given;
  for (const Term list : lists) {
    if (!store.is_list(list)) continue;
    for (const Term term : store.items(list)) {
      const std::string name = text_of(store, term);
      const bool known = std::any_of(given.begin(), given.end(),
                                     [&](const auto& one) { return same_name(one, name); });
      if (!known && !name.empty()) given.push_back(name);
    }
  }
  const auto& order = gazetteer_.knowledge().team;
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

Value PlannerHost::Services::rank_in(TermStore& store, Arguments arguments) {
  const std::vector<std::string> all = team(store, arguments);
  const auto me = std::find_if(all.begin(), all.end(), [&](const std::string& one) {
    return same_name(one, gazetteer_.knowledge().uav);
  });
  return store.integer(me == all.end() ? 0 : me - all.begin());
}

Value PlannerHost::Services::count_of(TermStore& store, Arguments arguments) {
  const auto count = static_cast<std::int64_t>(team(store, arguments).size());
  return store.integer(std::clamp<std::int64_t>(count, 1, 16));
}

Value PlannerHost::Services::with_me(TermStore& store, Arguments arguments) {
  const std::vector<Term> me = {store.symbol(gazetteer_.knowledge().uav)};
  const std::vector<Term> lists = {store.list(me), arguments[0]};
  std::vector<Term> names;
  for (const std::string& name : team(store, lists)) names.push_back(store.symbol(name));
  return store.list(names);
}

/// (in-time WHAT ORIGIN START DURATION TIME-CONSTRAINTS): whether the latest start and end keep
/// the bounds.
Value PlannerHost::Services::in_time(TermStore& store, Arguments arguments) {
  const auto start = seconds_of(store, arguments[2]), duration = seconds_of(store, arguments[3]);
  if (!start || !duration) return failure("start and duration must be ((num LEAST) (num MOST))");
  const auto at = [&](double s) {
    return std::isinf(s) ? std::string("an unknown time")
                         : to_text(origin_ + Duration::seconds(std::round(s * 10) / 10)) + " s";
  };
  bool fits = true;
  const auto check = [&](std::size_t which, double least, double most, const std::string& verb) {
    const auto before = bound(store, arguments[4], which);
    if (!before || most <= *before + kRounding) return;
    fits = false;
    refuse(text_of(store, arguments[0]) + " of goal " + text_of(store, arguments[1]) + " " + verb +
           "s between " + at(least) + " and " + at(most) + ", but must " + verb + " before " +
           at(*before));
  };
  check(0, start->least, start->most, "start");
  check(2, start->least + duration->least, start->most + duration->most, "end");
  return TermStore::boolean(fits);
}

}  // namespace skein::supervisor
