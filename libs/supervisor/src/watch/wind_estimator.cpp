// SPDX-License-Identifier: Apache-2.0
#include "watch/wind_estimator.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace skein::supervisor {

namespace {

constexpr double kBelief = 3;            // [m/s] of each component of the wind believed
constexpr double kAirSpeedShare = 0.15;  // of the cruise speed
constexpr double kWindWalk = 0.02;       // [m/s per √s]
// [m/s per √s] It brakes for corners, and may become slow: what is along its nose tells of the wind
// by its turns, not by its changes.
constexpr double kAirSpeedWalk = 0.5;
constexpr double kUnmodelled = 0.3;    // [m/s] of a velocity, beside gusts
constexpr double kCorrelated = 5;      // [s] for which gusts last: so many states tell as one
constexpr double kSteadyChange = 0.6;  // [m/s²] of the velocity over the ground
constexpr double kSteadyTurn = 0.05;   // [rad/s] of a hovering vehicle's nose
constexpr double kLevel = 0.5;         // [m/s] up or down: who climbs may not fly at its speed yet
constexpr double kLeastShare = 0.5;    // of the cruise speed, through the air
constexpr double kLongestStep = 5;     // [s] between states that are compared

Eigen::Vector2d nose(const world::VehicleState& state) {
  return {std::cos(state.heading), std::sin(state.heading)};
}

}  // namespace

WindEstimator::WindEstimator(const world::VehicleModel& vehicle, const world::Wind& believed)
    : hovers_(vehicle.hovers),
      cruise_(vehicle.cruise_speed),
      drift_(vehicle.wind_drift),
      gusts_(believed.gusts) {
  const world::Vector3 wind = world::mean_velocity(believed);
  mean_ = {wind.x(), wind.y(), cruise_};
  const double speed = kAirSpeedShare * cruise_;
  covariance_ = Eigen::Vector3d(kBelief * kBelief, kBelief * kBelief, speed * speed).asDiagonal();
}

bool WindEstimator::is_steady(const world::VehicleState& state, double dt) const {
  if (!last_ || !last_->airborne || !state.airborne || dt <= 0 || dt > kLongestStep) return false;
  if (std::abs(state.velocity.z()) > kLevel) return false;
  const double turn = std::abs(std::remainder(state.heading - last_->heading, 2 * M_PI)) / dt;
  // A vehicle that cannot hover flies where its nose points, also in turns.
  if (hovers_ && turn > kSteadyTurn) return false;
  const Eigen::Vector2d by_turning = mean_.z() * (nose(state) - nose(*last_));
  const Eigen::Vector2d change = (state.velocity - last_->velocity).head<2>() - by_turning;
  const Eigen::Vector2d air = state.velocity.head<2>() - drift_ * mean_.head<2>();
  return change.norm() / dt <= kSteadyChange && air.norm() >= kLeastShare * cruise_;
}

void WindEstimator::see(const world::VehicleState& state, MissionTime at) {
  const double dt = last_ ? (at - last_at_).to_seconds() : 0;
  const bool steady = drift_ > 0 && is_steady(state, dt);
  last_ = state;
  last_at_ = at;
  if (!steady) return;
  covariance_(0, 0) += kWindWalk * kWindWalk * dt;
  covariance_(1, 1) += kWindWalk * kWindWalk * dt;
  covariance_(2, 2) += kAirSpeedWalk * kAirSpeedWalk * dt;

  Eigen::Matrix<double, 2, 3> sees;
  sees << drift_ * Eigen::Matrix2d::Identity(), nose(state);
  const Eigen::Vector2d surprise = state.velocity.head<2>() - sees * mean_;
  const double gust = drift_ * gusts_;
  const double noise = (gust * gust + kUnmodelled * kUnmodelled) * std::max(1.0, kCorrelated / dt);
  const Eigen::Matrix2d of_surprise =
      sees * covariance_ * sees.transpose() + noise * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, 3, 2> gain = covariance_ * sees.transpose() * of_surprise.inverse();
  mean_ += gain * surprise;
  covariance_ = (Eigen::Matrix3d::Identity() - gain * sees) * covariance_;
  covariance_ = (covariance_ + covariance_.transpose().eval()) / 2;
}

world::Wind WindEstimator::wind() const {
  return {std::atan2(mean_.y(), mean_.x()), mean_.head<2>().norm(), gusts_};
}

// The greater eigenvalue of the wind's part.
double WindEstimator::spread() const {
  const double a = covariance_(0, 0), b = covariance_(0, 1), c = covariance_(1, 1);
  return std::sqrt((a + c) / 2 + std::hypot((a - c) / 2, b));
}

}  // namespace skein::supervisor
