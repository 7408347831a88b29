// SPDX-License-Identifier: Apache-2.0
#include "merging/home_air.hpp"

#include "core.hpp"
#include "skein/elementary/parameter_reader.hpp"
#include "skein/supervisor/own_ways.hpp"

namespace skein::decision_node {

using world::Vector3;

namespace {

functional::Request along(const std::vector<Vector3>& way) {
  functional::Request request{functional::Verb::kDispatch, {}, "goto", {}};
  request.parameters.add(elementary::points_parameter("waypoints", {way.begin() + 1, way.end()}));
  return request;
}

}  // namespace

bool HomeAir::returns() const {
  const Config& config = core_.config();
  return config.merging && !config.merging->witness.empty() && !config.drives &&
         config.contact_policy == ContactPolicy::kReturn && config.knowledge &&
         core_.deliberation().possible();
}

bool HomeAir::is_new(const std::optional<Vector3>& rest) const {
  return reaches_ground_ && returns() && (from_ != rest || world_ != core_.deliberation().world());
}

void HomeAir::look(const std::optional<Vector3>& rest, const AirwaySituation& situation) {
  from_ = rest;
  world_ = core_.deliberation().world();
  flights_.clear();
  choices_.clear();
  if (!rest) return;
  const MergingConfig& config = *core_.config().merging;
  const auto& place = core_.config().home;
  const Vector3 home(place.at(0), place.at(1), place.at(2));
  const auto margins = merging::margins_of(config.model, config.wind, config.model.cruise_speed);
  AirwaySituation there = resting_at(situation, *rest);
  there.state.airborne = true;
  const merging::Volume landing = landing_at(home + Vector3(0, 0, margins.slope), margins);
  if ((*rest - home).norm() <= margins.settled) return choices_.push_back({landing});
  flights_ = ways_to(home, there);
  for (const Airway& one : flights_) {
    choices_.push_back(one.air);
    choices_.back().push_back(landing);
  }
}

Airways HomeAir::ways_to(const Vector3& home, const AirwaySituation& there) const {
  const auto way = supervisor::own_way(core_.config().knowledge, world_, there.now, *from_, home);
  return airways_of(along(way), true, *core_.config().merging, there).value_or(Airways());
}

Airways HomeAir::flights(const functional::Request& request,
                         const std::optional<Vector3>& rest) const {
  if (request.type != "goto" || !is_own(request.id) || rest != from_) return {};
  Airways home = flights_;
  for (Airway& one : home) one.request.id = request.id;
  return home;
}

}  // namespace skein::decision_node
