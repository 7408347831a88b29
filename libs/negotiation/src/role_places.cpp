// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/role_places.hpp"

#include <algorithm>
#include <utility>

#include "skein/refiners/relay.hpp"
#include "skein/refiners/viewpoint.hpp"

namespace skein::interaction {

namespace {

world::Vector3 vector_of(const Position& p) { return {p[0], p[1], p[2]}; }
Position position_of(const world::Vector3& v) { return {v.x(), v.y(), v.z()}; }

constexpr std::size_t kMostRefused = 8;  // a few roles, and a target that moves

using Constraints = std::vector<PlacedConstraint>;

Result<Constraints, Failure> constraints_of(const ActiveScm& active,
                                            const Whereabouts& whereabouts) {
  Constraints all;
  for (auto& one : placed(active.scm, active.binding, whereabouts)) {
    if (!one) return failure("a place of " + active.id + " is unknown");
    all.push_back(std::move(*one));
  }
  return all;
}

bool all_hold(const Constraints& all, const world::Vector3& at) {
  return std::ranges::all_of(all, [&](const auto& one) { return one.holds(position_of(at)); });
}

std::vector<world::Volume> closed_from(MissionTime at, const world::World& world) {
  std::vector<world::Volume> closed;
  for (const world::Volume& volume : world.volumes)
    if (volume.when.overlaps({at, MissionTime::max()})) closed.push_back(volume);
  return closed;
}

}  // namespace

std::optional<Failure> RefusedViews::why(const Search& search) const {
  const auto found = std::ranges::find(known_, search, &std::pair<Search, Failure>::first);
  return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void RefusedViews::refused(Search search, const Failure& why) {
  if (known_.size() == kMostRefused) known_.pop_front();
  known_.emplace_back(std::move(search), why);
}

Result<Position, Failure> best_view(const RolePlaceQuery& query, const std::string& device,
                                    const Position& target, const Observer& observer,
                                    const refiners::Setting& setting, RefusedViews* known) {
  refiners::ViewpointQuery view;
  view.vehicle = query.vehicle;
  view.device = device;
  view.target = vector_of(target);
  view.clearance = query.clearance;
  view.from = vector_of(query.from);
  view.at = query.at;
  RefusedViews::Search search{device, target, query.clearance, {}, {}};
  const Whereabouts whereabouts = known_by(observer, query.at, query.limits);
  for (const ActiveScm& active : query.scms) {
    const auto all = constraints_of(active, whereabouts);
    if (!all) return tl::unexpected<Failure>(all.error());
    view.constraints.push_back(
        {active.id, [all = *all](const world::Vector3& at) { return all_hold(all, at); }});
    search.constraints.insert(search.constraints.end(), all->begin(), all->end());
  }
  if (known != nullptr) {
    search.closed = closed_from(query.at, setting.world);
    if (const auto why = known->why(search)) return tl::unexpected<Failure>(*why);
  }
  const auto found = refiners::refine(view, setting);
  if (found) return position_of(found->task.points.front().position);
  const Failure why{found.error().why};
  const bool is_whole = found.error().kind != refiners::RefusalKind::kBudgetExhausted;
  if (known != nullptr && is_whole) known->refused(std::move(search), why);
  return tl::unexpected<Failure>(why);
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
