// SPDX-License-Identifier: Apache-2.0
#include "tour/travel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/plain_way.hpp"
#include "path/approach.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::refiners {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

PathQuery path_query(const Traveller& who, const world::Vector3& from, const world::Vector3& to) {
  PathQuery query;
  query.vehicle = who.vehicle;
  query.from = from;
  query.to = to;
  query.clearance = who.clearance;
  query.speed = who.speed;
  query.depart = who.depart;
  return query;
}

double seconds_of(const Flight& flight) {
  return flight.duration.expected == Duration::max() ? kNever
                                                     : flight.duration.expected.to_seconds();
}

}  // namespace

Result<Travel, Refusal> Travel::over(const Traveller& who, const Setting& setting,
                                     const world::Vector3& from, const world::Vector3& to) {
  auto airspace = airspace_of(path_query(who, from, to), setting);
  if (!airspace) return tl::unexpected(airspace.error());
  return Travel(who, setting, std::move(*airspace));
}

Travel::Travel(const Traveller& who, const Setting& setting, world::Airspace airspace)
    : who_(who),
      straight_(who.vehicle, setting.world.wind, who.speed),
      setting_(&setting),
      airspace_(std::move(airspace)) {}

Travel::Id Travel::add(const world::Vector3& place) {
  const auto [at, is_new] = ids_.try_emplace({place.x(), place.y(), place.z()}, places_.size());
  if (is_new) {
    regions_.push_back(places_.size());
    places_.push_back(place);
  }
  return at->second;
}

std::optional<Refusal> Travel::closed(Id place, const std::string& field) const {
  const world::Vector3& at = places_[place];
  if (airspace_.is_free(at) || setting_->budget.expired()) return std::nullopt;
  const PathQuery query = path_query(who_, at, at);
  const PathSpace space(query, setting_->world, Duration::max());
  if (approach(space, airspace_, at, at, {setting_->budget.time_is_up}) ||
      setting_->budget.expired())
    return std::nullopt;
  return space.closed(at, field);
}

double Travel::bound(Id from, Id to) const {
  return from == to ? 0 : straight_.seconds(places_[from], places_[to]);
}

/// A vehicle that hovers slows down where it is steep; another must not climb faster than it can.
bool Travel::can_go_straight(Id from, Id to) const {
  const world::Vector3 step = places_[to] - places_[from];
  if (!who_.vehicle.hovers) {
    const double rate = step.z() > 0 ? who_.vehicle.climb_rate : who_.vehicle.descent_rate;
    const double speed = who_.speed > 0 ? who_.speed : who_.vehicle.cruise_speed;
    if (std::abs(step.z()) * speed > rate * step.head<2>().norm()) return false;
  }
  return airspace_.is_free(places_[from], places_[to]);
}

bool Travel::settle(Id from, Id to) {
  if (is_known(from, to)) return true;
  if (can_go_straight(from, to)) {
    put(from, to, {bound(from, to), {}, {}});
    join(from, to);
    return true;
  }
  if (are_shut_off(from, to)) {
    put(from, to, {kNever, {}, "every way there is closed"});
    return true;
  }
  time_is_up_ = time_is_up_ || setting_->budget.expired();
  cut_short_ = cut_short_ || time_is_up_;
  if (time_is_up_) return false;
  std::optional<Leg> leg = plan(from, to);
  if (!leg) return false;
  if (turns_back_alike() && !is_known(to, from)) put(to, from, turned(to, from, *leg));
  put(from, to, std::move(*leg));
  return true;
}

void Travel::put(Id from, Id to, Leg leg) {
  legs_.emplace(std::pair(from, to), std::move(leg));
  left_.resize(std::max(left_.size(), from + 1));
  left_[from] = true;
}

/// A way may be flown back when nothing makes climbing it harder than descending it.
bool Travel::turns_back_alike() const {
  return who_.vehicle.hovers || who_.vehicle.climb_rate == who_.vehicle.descent_rate;
}

/// Nothing when the time was up first.
std::optional<Travel::Leg> Travel::plan(Id from, Id to) {
  Setting setting{setting_->world, {}, setting_->seed, setting_->paths};
  setting.budget.time_is_up = setting_->budget.time_is_up;
  const VoxelPathPlanner on_voxels(airspace_);
  const PathPlanner& planner = setting.paths != nullptr ? *setting.paths : on_voxels;
  ++planned_;
  const auto path = planner.plan(path_query(who_, places_[from], places_[to]), setting);
  if (path) {
    cut_short_ = cut_short_ || path->effort.cut_short;
    join(from, to);
    const Way way = without_repeats(path->task.way);
    return Leg{std::max(bound(from, to), seconds_of(flight(way))), way, {}};
  }
  if (path.error().kind == RefusalKind::kBudgetExhausted) {
    cut_short_ = true;
    time_is_up_ = static_cast<bool>(setting.budget.time_is_up);
    if (time_is_up_) return std::nullopt;
  }
  // On the voxels that is so for all places which ways lead to from the one and from the other.
  if (setting.paths == nullptr && path.error().kind == RefusalKind::kUnreachable &&
      airspace_.is_free(places_[from]) && airspace_.is_free(places_[to]))
    shut_off_.emplace_back(from, to);
  return Leg{kNever, {}, path.error().why};
}

Travel::Leg Travel::turned(Id from, Id to, const Leg& back) const {
  if (back.seconds == kNever) return back;
  Way way(back.way.rbegin(), back.way.rend());
  // Sums in another order: what differs by rounding only is to be the same.
  const double here = std::max(bound(from, to), seconds_of(flight(way)));
  return {std::abs(here - back.seconds) < 1e-6 ? back.seconds : here, std::move(way), {}};
}

void Travel::join(Id from, Id to) { regions_[region(from)] = region(to); }

Travel::Id Travel::region(Id place) const {
  while (regions_[place] != place) place = regions_[place] = regions_[regions_[place]];
  return place;
}

bool Travel::are_shut_off(Id from, Id to) const {
  if (shut_off_.empty() || region(from) == region(to)) return false;
  const auto regions = std::minmax({region(from), region(to)});
  return std::any_of(shut_off_.begin(), shut_off_.end(), [&](const auto& pair) {
    return regions == std::minmax({region(pair.first), region(pair.second)});
  });
}

bool Travel::is_known(Id from, Id to) const {
  if (from == to) return true;
  return from < left_.size() && left_[from] && legs_.contains({from, to});
}

double Travel::seconds(Id from, Id to) const {
  if (from < left_.size() && left_[from])
    if (const auto leg = legs_.find({from, to}); leg != legs_.end()) return leg->second.seconds;
  return are_shut_off(from, to) ? kNever : bound(from, to);
}

Way Travel::way(Id from, Id to) const {
  if (from == to) return {places_[from]};
  const Leg& leg = legs_.at({from, to});
  SKEIN_EXPECTS(leg.seconds < kNever);
  return leg.way.empty() ? Way{places_[from], places_[to]} : leg.way;
}

std::string Travel::why_closed(Id from, Id to) const {
  const auto leg = legs_.find({from, to});
  return leg == legs_.end() ? "every way there is closed" : leg->second.why;
}

Flight Travel::flight(const Way& way) const {
  return estimate_flight(way, who_.vehicle, setting_->world.wind, who_.speed);
}

}  // namespace skein::refiners
