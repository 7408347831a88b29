// SPDX-License-Identifier: Apache-2.0
#include "coverage/turn_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/foundation/contract.hpp"
#include "skein/refiners/coverage.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
constexpr double kPi = std::numbers::pi;

/// From a pose on one turn, then straight, to a point.
struct TurnThenStraight {
  double length;
  double heading;  ///< where it arrives [rad]
};

/// `side`: 1 turns left, -1 right. Nothing when the point is within the circle of that turn.
std::optional<TurnThenStraight> turn_then_straight(const Pose& from, const Vector2& to,
                                                   double radius, double side) {
  // Mirrored so that the turn is to the left: the pose at the origin, heading along x.
  const double c = std::cos(from.heading), s = std::sin(from.heading);
  const Vector2 offset = to - from.at;
  const double x = c * offset.x() + s * offset.y();
  const double y = side * (c * offset.y() - s * offset.x()) - radius;
  const double straight2 = x * x + y * y - radius * radius;
  if (straight2 < 0) return std::nullopt;
  const double straight = std::sqrt(straight2);
  double turn = std::atan2(y, x) - std::atan2(straight, radius) + kPi / 2;
  turn = std::fmod(turn + 4 * kPi, 2 * kPi);
  if (turn > 2 * kPi - 1e-9) turn = 0;  // straight ahead, but for rounding
  return TurnThenStraight{turn * radius + straight, from.heading + side * turn};
}

/// The point is within one of the two circles at most, since they only touch.
TurnThenStraight shortest_to_point(const Pose& from, const Vector2& to, double radius) {
  const auto left = turn_then_straight(from, to, radius, 1);
  const auto right = turn_then_straight(from, to, radius, -1);
  if (!left && !right) return {0, from.heading};  // where they touch
  if (!right || (left && left->length <= right->length)) return *left;
  return *right;
}

Pose reversed(const Pose& pose) { return {pose.at, pose.heading + kPi}; }

/// The U-turn of a vehicle that cannot hover, between two level lanes: half a circle and a straight
/// piece, or where the lanes are closer than that, a bulb of three arcs. Source: Dubins 1957.
double u_turn(double spacing, double radius) {
  if (spacing >= 2 * radius) return kPi * radius + spacing - 2 * radius;
  return radius * (kPi + 4 * std::acos((2 * radius + spacing) / (4 * radius)));
}

}  // namespace

TurnModel::TurnModel(const world::VehicleModel& vehicle, double speed)
    : vehicle_(&vehicle),
      hovers_(vehicle.hovers),
      speed_(speed),
      acceleration_(vehicle.acceleration),
      yaw_rate_(vehicle.yaw_rate),
      radius_(vehicle.min_turn_radius) {
  SKEIN_EXPECTS(speed > 0);
}

double TurnModel::along(double length) const {
  if (!hovers_) return length / speed_;
  const double to_gather_speed = speed_ * speed_ / acceleration_;  // and to lose it again
  return length >= to_gather_speed ? length / speed_ + speed_ / acceleration_
                                   : 2 * std::sqrt(length / acceleration_);
}

TurnModel TurnModel::in_wind(const Vector2& wind) const {
  SKEIN_EXPECTS(wind.norm() < speed_);
  const double held = std::sqrt(speed_ * speed_ - wind.y() * wind.y());
  TurnModel model = *this;
  model.lost_forth_ = 1 / (held + wind.x()) - 1 / speed_;
  model.lost_back_ = 1 / (held - wind.x()) - 1 / speed_;
  return model;
}

double TurnModel::between(const Pass& from, const Pass& to) const {
  const Vector2 step = to.from - from.to;
  const bool opposite = from.heading != to.heading;
  if (hovers_) return std::max(along(step.norm()), opposite ? kPi / yaw_rate_ : 0);
  const double across = std::abs(step.y());
  // Half a circle in two parts and a straight piece: nothing that turns by as much is shorter.
  if (opposite && across >= 2 * radius_)
    return (kPi * radius_ + std::hypot(step.x(), across - 2 * radius_)) / speed_;
  return DubinsCurve::shortest(from.end(), to.begin(), radius_).length() / speed_;
}

double TurnModel::beside(double spacing) const {
  if (!hovers_) return u_turn(spacing, radius_) / speed_;
  return std::max(along(spacing), kPi / yaw_rate_);
}

double TurnModel::reach(const Vector2& start, const Pass& first) const {
  if (hovers_) return along((first.from - start).norm());
  return shortest_to_point(reversed(first.begin()), start, radius_).length / speed_;
}

double TurnModel::leave(const Pass& last, const Vector2& end) const {
  if (hovers_) return along((end - last.to).norm());
  return shortest_to_point(last.end(), end, radius_).length / speed_;
}

DubinsCurve arrival(const Vector2& from, const Pose& to, double radius) {
  const double heading = shortest_to_point(reversed(to), from, radius).heading + kPi;
  return DubinsCurve::shortest({from, heading}, to, radius);
}

DubinsCurve departure(const Pose& from, const Vector2& to, double radius) {
  return DubinsCurve::shortest(from, {to, shortest_to_point(from, to, radius).heading}, radius);
}

double turn_time(const world::VehicleModel& vehicle, double spacing, double speed) {
  const double flown = speed > 0 ? speed : vehicle.cruise_speed;
  SKEIN_EXPECTS(flown > 0 && spacing >= 0);
  const TurnModel model(vehicle, flown);
  return model.beside(spacing) + model.stop();
}

}  // namespace skein::refiners
