// SPDX-License-Identifier: Apache-2.0
#include "flight/autopilot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/foundation/random.hpp"
#include "skein/world/passage.hpp"
#include "skein/world/steering.hpp"

namespace skein::supervisor {
namespace {

using refiners::Way;
using world::Vector2;
using world::Vector3;
using world::VehicleModel;

constexpr double kPi = std::numbers::pi;
constexpr double kArrivalSpeed = 1;              // [m/s] at the last way-point, of one that hovers
constexpr double kOrbitGain = 1.5;               // how sharply a circle is joined
constexpr double kNear = 0.05;                   // [m]
constexpr double kPatience = 7200;               // [s]
constexpr double kCorrection = 5;                // [s] between two of an autopilot
constexpr double kVerticalShare = 0.5;           // heights are held better than places
constexpr double kGustLasts = 5, kGustStep = 1;  // [s]

Vector2 facing(double heading) { return {std::cos(heading), std::sin(heading)}; }

/// `turn`: from its heading on [rad]; `course`: a unit vector, of what hovers.
struct Order {
  double speed = 0, turn = 0, climb = 0;
  Vector2 course = Vector2::Zero();
};

class Flyer {
 public:
  Flyer(const Pose& from, const VehicleModel& vehicle, const world::Wind& wind)
      : vehicle_(vehicle),
        drift_(vehicle.wind_drift * world::mean_velocity(wind)),
        at_(from.at),
        heading_(from.heading),
        facing_(facing(from.heading)),
        air_(from.speed * facing_.x(), from.speed * facing_.y(), 0) {}

  const Vector3& at() const { return at_; }
  double speed() const { return air_.norm(); }
  Pose pose() const { return {at_, heading_, air_.head<2>().norm()}; }

  void step(const Order& order, const Vector3& gust) {
    vehicle_.hovers ? thrust(order) : turn(order);
    const double most = vehicle_.acceleration * kTrackStep;
    const double climb = std::clamp(order.climb, -vehicle_.descent_rate, vehicle_.climb_rate);
    air_.z() += std::clamp(climb - air_.z(), -most, most);
    at_ += (air_ + drift_ + gust) * kTrackStep;
  }

  double level_towards(double height, double climb_there = 0) const {
    const double error = height - at_.z();
    const double there = climb_there * error < 0 ? 0 : climb_there;  // past it, it comes back
    return there +
           std::copysign(world::stopping_speed(vehicle_.acceleration, std::abs(error)), error);
  }

  /// Straight at a point: the quicker of the two motions waits for the slower.
  Order hover_towards(const Vector3& to, const world::Passage& there) const {
    const Vector2 level = (to - at_).head<2>();
    const double distance = level.norm(), rise = std::abs(to.z() - at_.z());
    const double climb =
        std::clamp(level_towards(to.z(), there.climb), -vehicle_.descent_rate, vehicle_.climb_rate);
    Order order{
        std::min(vehicle_.cruise_speed,
                 std::hypot(there.speed, world::stopping_speed(vehicle_.acceleration, distance))),
        0, climb, distance > 0 ? Vector2(level / distance) : Vector2::UnitX()};
    if (distance < kNear || rise < kNear) return order;
    const double level_time = distance / order.speed, climb_time = rise / std::abs(order.climb);
    if (climb_time < level_time)
      order.climb *= climb_time / level_time;
    else
      order.speed *= level_time / climb_time;
    return order;
  }

  Order turn_towards(const Vector3& to, bool makes_room) const {
    return {vehicle_.cruise_speed, makes_room ? 0 : turn_to((to - at_).head<2>()),
            level_towards(to.z())};
  }

  Order circle(const Vector3& centre) const {
    const Vector2 offset = (at_ - centre).head<2>();
    const double excess = (offset.norm() - vehicle_.orbit_radius) / vehicle_.orbit_radius;
    const double along = offset.norm() > 1e-6 ? turn_to({-offset.y(), offset.x()}) : 0;
    return {vehicle_.cruise_speed, world::wrapped(along + std::atan(kOrbitGain * excess)),
            level_towards(centre.z())};
  }

  /// The point lies inside the circle of that radius that would turn towards it.
  bool needs_room(const Vector2& point, double radius, double tolerance) const {
    const Vector2 left(-facing_.y(), facing_.x());
    const double side = left.dot(point - at_.head<2>()) >= 0 ? 1 : -1;
    return (point - (at_.head<2>() + side * radius * left)).norm() < radius - tolerance / 2;
  }

 private:
  void thrust(const Order& order) {
    const Vector2 change = order.speed * order.course - air_.head<2>();
    const double most = vehicle_.acceleration * kTrackStep, size = change.norm();
    air_.head<2>() += size <= most ? change : Vector2(change * (most / size));
  }

  void turn(const Order& order) {
    const double now = air_.head<2>().norm(), most = vehicle_.acceleration * kTrackStep;
    const double wanted = std::clamp(order.speed, vehicle_.min_speed, vehicle_.max_speed);
    const double speed = now + std::clamp(wanted - now, -most, most);
    const double limit = speed * kTrackStep / vehicle_.min_turn_radius;
    heading_ += std::clamp(order.turn, -limit, limit);
    facing_ = facing(heading_);
    air_.head<2>() = speed * facing_;
  }

  /// From its heading to that direction [rad].
  double turn_to(const Vector2& direction) const {
    const double across = facing_.x() * direction.y() - facing_.y() * direction.x();
    return std::atan2(across, facing_.dot(direction));
  }

  const VehicleModel& vehicle_;
  Vector3 drift_, at_;
  double heading_;
  Vector2 facing_;  ///< its heading as a unit vector
  Vector3 air_;
};

/// What displaces a vehicle: errors that last until the next correction, gusts that last a while.
class Shaking {
 public:
  Shaking(const VehicleModel& vehicle, const world::Wind& wind, std::uint64_t trial)
      : random_(trial, "flight in thought"),
        shakes_(trial > 0),
        spread_(world::tracking_spread(vehicle)),
        period_(vehicle.pilot ? vehicle.pilot->attention_period.to_seconds() : kCorrection),
        gusts_(vehicle.wind_drift * wind.gusts) {}

  void advance(double seconds) {
    if (!shakes_) return;
    if (seconds >= next_error_) {
      next_error_ += period_;
      error_ = spread_ * Vector3(bounded(), bounded(), kVerticalShare * bounded());
    }
    if (seconds >= next_gust_ && gusts_ > 0) {
      next_gust_ += kGustStep;
      const double kept = std::exp(-kGustStep / kGustLasts);
      const Vector3 fresh(random_.normal(), random_.normal(), 0);
      gust_ = kept * gust_ + gusts_ * std::sqrt(1 - kept * kept) * fresh;
    }
  }
  const Vector3& error() const { return error_; }
  const Vector3& gust() const { return gust_; }

 private:
  double bounded() { return std::clamp(random_.normal(), -2.0, 2.0); }

  Random random_;
  bool shakes_;
  double spread_, period_, gusts_;
  double next_error_ = 0, next_gust_ = 0;
  Vector3 error_ = Vector3::Zero(), gust_ = Vector3::Zero();
};

bool is_near(const Vector3& at, const Vector3& point, double tolerance) {
  return std::abs(point.z() - at.z()) <= tolerance &&
         (point - at).head<2>().squaredNorm() <= tolerance * tolerance;
}

/// It has its speed, and is at rest, within a step.
bool has_no_inertia(const VehicleModel& vehicle) {
  return vehicle.hovers && vehicle.cruise_speed <= kTrackStep * vehicle.acceleration;
}

FlownWay fly_exactly(const Pose& from, const Way& way, const VehicleModel& vehicle,
                     const world::Wind& wind) {
  FlownWay flown;
  Vector3 at = from.at;
  for (const Vector3& to : way) {
    const double began = flown.seconds;
    flown.seconds +=
        refiners::estimate_flight({at, to}, vehicle, wind).duration.expected.to_seconds();
    while (static_cast<double>(flown.track.size()) * kTrackStep < flown.seconds) {
      const double part =
          (static_cast<double>(flown.track.size()) * kTrackStep - began) / (flown.seconds - began);
      flown.track.emplace_back(at + part * (to - at));
    }
    flown.passages.push_back(flown.seconds);
    at = to;
  }
  flown.track.push_back(at);
  flown.arrived = true;
  flown.end = {at, 0, 0};
  return flown;
}

}  // namespace

FlownWay fly_way(const Pose& from, const Way& way, const VehicleModel& vehicle,
                 const world::Wind& wind, std::uint64_t trial) {
  if (has_no_inertia(vehicle)) return fly_exactly(from, way, vehicle, wind);
  const double tolerance = world::reaching_distance(vehicle, wind);
  // What the drift leaves of a vehicle that stands still in the wind is not a speed of its own.
  const double slow = kArrivalSpeed + vehicle.wind_drift * wind.speed;
  Flyer flyer(from, vehicle, wind);
  Shaking shaking(vehicle, wind, trial);
  FlownWay flown;
  std::size_t next = 0;
  bool makes_room = false;
  while (flown.seconds < kPatience) {
    flown.track.push_back(flyer.at());
    shaking.advance(flown.seconds);
    while (next + 1 < way.size() && is_near(flyer.at(), way[next], tolerance)) {
      flown.passages.push_back(flown.seconds);
      makes_room = false;
      ++next;
    }
    if (next >= way.size()) break;
    const bool rests = !vehicle.hovers || flyer.speed() <= slow;
    flown.arrived = next + 1 == way.size() && rests && is_near(flyer.at(), way[next], tolerance);
    if (flown.arrived) break;
    Order order;
    const Vector3 aim = way[std::min(next, way.size() - 1)] + shaking.error();
    if (vehicle.hovers) {
      const bool is_corner = next > 0 && next + 1 < way.size();
      order = flyer.hover_towards(aim, is_corner
                                           ? world::passage_of(way[next - 1], way[next],
                                                               way[next + 1], vehicle.cruise_speed)
                                           : world::Passage());
    } else {
      const double radius = vehicle.min_turn_radius * (makes_room ? kRoomMargin : 1);
      makes_room = flyer.needs_room(way[next].head<2>(), radius, tolerance);
      order = flyer.turn_towards(aim, makes_room);
    }
    flyer.step(order, shaking.gust());
    flown.seconds += kTrackStep;
  }
  flown.passages.resize(way.size(), flown.seconds);
  flown.end = flyer.pose();
  return flown;
}

std::vector<Vector3> circle_over(const Pose& from, const Vector3& at, const VehicleModel& vehicle,
                                 const world::Wind& wind, double seconds) {
  Flyer flyer(from, vehicle, wind);
  std::vector<Vector3> track = {flyer.at()};
  for (double t = 0; t < seconds; t += kTrackStep) {
    flyer.step(flyer.circle(at), Vector3::Zero());
    track.push_back(flyer.at());
  }
  return track;
}

std::vector<Pose> poses_at(const Vector3& at, const VehicleModel& vehicle, int headings) {
  if (vehicle.hovers) return {{at, 0, 0}};
  std::vector<Pose> poses;
  for (int i = 0; i < headings; ++i) {
    const double angle = 2 * kPi * i / headings;
    const Vector3 out(std::cos(angle), std::sin(angle), 0);
    poses.push_back({at, angle, vehicle.cruise_speed});
    poses.push_back({at + vehicle.orbit_radius * out, angle + kPi / 2, vehicle.cruise_speed});
  }
  return poses;
}

}  // namespace skein::supervisor
