// SPDX-License-Identifier: Apache-2.0
#include "planning/host_names.hpp"

#include <algorithm>

#include "flight/flight_times.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::supervisor {

using htn::kNil;
using htn::Term;
using htn::TermStore;
using world::Vector3;

namespace {

/// Beside what it wavers [m].
constexpr double kNear = 2;
}  // namespace

double vicinity(const Gazetteer& gazetteer) {
  const world::VehicleModel& vehicle = gazetteer.knowledge().vehicle;
  return kNear + arrival_distance(vehicle, gazetteer.world().wind) +
         (vehicle.hovers ? 0 : vehicle.orbit_radius);
}

Term HostNames::refuse(const std::string& why) {
  said_.push_back(why);
  if (std::find(refusals_.begin(), refusals_.end(), why) == refusals_.end())
    refusals_.push_back(why);
  return kNil;
}

std::optional<Vector3> HostNames::place(const TermStore& store, Term term) {
  auto at = gazetteer_.place(store, term);
  if (at) return at;
  std::vector<std::string> names;
  for (const auto& one : gazetteer_.world().places) names.push_back(one.first);
  const std::string name = Gazetteer::words(store, term);
  refuse("unknown place '" + name + "'" + did_you_mean(nearest_name(name, names)));
  return at;
}

}  // namespace skein::supervisor
