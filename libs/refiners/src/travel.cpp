// SPDX-License-Identifier: Apache-2.0
#include "travel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skein/foundation/contract.hpp"

namespace skein::refiners {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kUnknown = -1;

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
    : who_(who), setting_(&setting), airspace_(std::move(airspace)) {}

Travel::Id Travel::add(const world::Vector3& place) {
  const auto [at, is_new] = ids_.try_emplace({place.x(), place.y(), place.z()}, places_.size());
  if (is_new) places_.push_back(place);
  return at->second;
}

bool Travel::is_free(Id place) const { return airspace_.is_free(places_[place]); }

double Travel::seconds(Id from, Id to) {
  if (from == to) return 0;
  if (width_ < places_.size()) reserve_pairs();
  double& known = seconds_[from * width_ + to];
  if (known != kUnknown) return known;
  if (can_go_straight(from, to)) return known = seconds_of(flight({places_[from], places_[to]}));
  return known = plan(from, to);
}

void Travel::reserve_pairs() {
  const std::size_t width = std::max(places_.size(), 2 * width_);
  std::vector<double> wider(width * width, kUnknown);
  for (std::size_t row = 0; row < width_; ++row)
    std::copy_n(seconds_.begin() + static_cast<std::ptrdiff_t>(row * width_), width_,
                wider.begin() + static_cast<std::ptrdiff_t>(row * width));
  seconds_ = std::move(wider);
  width_ = width;
}

/// A vehicle that hovers slows down where it is steep; another must not climb faster than it can.
bool Travel::can_go_straight(Id from, Id to) const {
  const world::Vector3 step = places_[to] - places_[from];
  if (!who_.vehicle.hovers) {
    const double rate = step.z() > 0 ? who_.vehicle.climb_rate : who_.vehicle.descent_rate;
    const double speed = who_.speed > 0 ? who_.speed : who_.vehicle.cruise_speed;
    if (std::abs(step.z()) * speed > rate * step.head<2>().norm()) return false;
  }
  const double back = seconds_[to * width_ + from];
  if (back != kUnknown && back < kNever && !planned_.contains({to, from}))
    return true;  // it was straight
  return airspace_.is_free(places_[from], places_[to]);
}

/// A way may be flown back when nothing makes climbing it harder than descending it.
bool Travel::turns_back_alike() const {
  return who_.vehicle.hovers || who_.vehicle.climb_rate == who_.vehicle.descent_rate;
}

double Travel::plan(Id from, Id to) {
  const auto back = planned_.find({to, from});
  if (turns_back_alike() && seconds_[to * width_ + from] != kUnknown) {
    if (back == planned_.end()) return kNever;
    const Way way(back->second.rbegin(), back->second.rend());
    planned_.emplace(std::pair(from, to), way);
    // Sums in another order: what differs by rounding only is to be the same.
    const double there = seconds_[to * width_ + from], here = seconds_of(flight(way));
    return std::abs(here - there) < 1e-6 ? there : here;
  }
  if (setting_->budget.expired()) {
    cut_short_ = true;
    return kNever;
  }
  Setting setting{setting_->world, {}, setting_->seed, setting_->paths};
  setting.budget.time_is_up = setting_->budget.time_is_up;
  const auto path = refine(path_query(who_, places_[from], places_[to]), setting);
  if (!path) {
    cut_short_ = cut_short_ || path.error().kind == RefusalKind::kBudgetExhausted;
    return kNever;
  }
  planned_.emplace(std::pair(from, to), path->task.way);
  return seconds_of(flight(path->task.way));
}

Way Travel::way(Id from, Id to) const {
  SKEIN_EXPECTS(from == to || seconds_[from * width_ + to] < kNever);
  const auto found = planned_.find({from, to});
  if (found != planned_.end()) return found->second;
  return {places_[from], places_[to]};
}

Flight Travel::flight(const Way& way) const {
  return estimate_flight(way, who_.vehicle, setting_->world.wind, who_.speed);
}

}  // namespace skein::refiners
