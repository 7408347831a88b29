// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/role_places.hpp"

#include "skein/interaction/placed_constraint.hpp"
#include "skein/refiners/relay.hpp"
#include "skein/refiners/viewpoint.hpp"

namespace skein::interaction {

namespace {

world::Vector3 vector_of(const Position& p) { return {p[0], p[1], p[2]}; }
Position position_of(const world::Vector3& v) { return {v.x(), v.y(), v.z()}; }

Result<refiners::PlaceConstraint, Failure> constraint_of(const ActiveScm& active,
                                                         const Whereabouts& whereabouts) {
  std::vector<PlacedConstraint> all;
  for (auto& one : placed(active.scm, active.binding, whereabouts)) {
    if (!one) return failure("a place of " + active.id + " is unknown");
    all.push_back(std::move(*one));
  }
  return refiners::PlaceConstraint{active.id, [all](const world::Vector3& at) {
                                     for (const PlacedConstraint& one : all) {
                                       if (!one.holds(position_of(at))) return false;
                                     }
                                     return true;
                                   }};
}

}  // namespace

Result<Position, Failure> best_view(const RolePlaceQuery& query, const std::string& device,
                                    const Position& target, const Observer& observer,
                                    const refiners::Setting& setting) {
  refiners::ViewpointQuery view;
  view.vehicle = query.vehicle;
  view.device = device;
  view.target = vector_of(target);
  view.clearance = query.clearance;
  view.from = vector_of(query.from);
  view.at = query.at;
  const Whereabouts whereabouts = known_by(observer, query.at, query.limits);
  for (const ActiveScm& active : query.scms) {
    auto constraint = constraint_of(active, whereabouts);
    if (!constraint) return tl::unexpected<Failure>(constraint.error());
    view.constraints.push_back(std::move(*constraint));
  }
  const auto found = refiners::refine(view, setting);
  if (!found) return failure(found.error().why);
  return position_of(found->task.points.front().position);
}

Result<Position, Failure> relay_position(const RolePlaceQuery& query, const Position& one,
                                         const Position& other, double least_margin,
                                         const Observer& observer,
                                         const refiners::Setting& setting) {
  refiners::RelayQuery relay;
  relay.vehicle = query.vehicle;
  relay.a = vector_of(one);
  relay.b = vector_of(other);
  relay.least_margin = least_margin;
  relay.clearance = query.clearance;
  relay.at = query.at;
  const auto best = refiners::refine(relay, setting);

  const world::World& world = setting.world;
  ValidPositionQuery valid;
  valid.scms = query.scms;
  valid.limits = query.limits;
  valid.seed = setting.seed;
  // Without an answer, or where they hear each other without a relay: half-way.
  const bool placed = best && !best->task.positions.empty();
  valid.from = position_of(placed ? best->task.positions.front() : (relay.a + relay.b) / 2);
  const FreeAir free = free_air_of(world, query.vehicle, query.clearance, query.at);
  valid.air = free;
  valid.air.holds = [&](const Position& at) {
    return free.holds(at) &&
           world.radio.margin(relay.a, vector_of(at), world.terrain) >= least_margin &&
           world.radio.margin(vector_of(at), relay.b, world.terrain) >= least_margin;
  };
  const auto found = valid_position(valid, observer, query.at);
  if (!found) return failure(found.error().why);
  return found->position;
}

}  // namespace skein::interaction
