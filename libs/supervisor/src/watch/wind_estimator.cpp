// SPDX-License-Identifier: Apache-2.0
#include "watch/wind_estimator.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace skein::supervisor {

namespace {

constexpr double kBelief = 3;           // [m/s] of each component of the wind believed
constexpr double kAirSpeedShare = 0.4;  // of the cruise speed: a vehicle may be slow
constexpr double kWindWalk = 0.02;      // [m/s per √s]
constexpr double kAirSpeedWalk = 0.1;   // [m/s per √s]
constexpr double kUnmodelled = 0.3;     // [m/s] of a velocity, beside gusts
constexpr double kCorrelated = 5;       // [s] for which gusts last: so many states tell as one
constexpr double kSurprising = 12;      // squared deviations: chance does this in 1 of 400
constexpr double kSteadyChange = 0.6;   // [m/s²] of the velocity over the ground
constexpr double kSteadyTurn = 0.05;    // [rad/s] of a hovering vehicle's nose
constexpr double kSettles = 4;          // [s] in which a speed is compared with itself
constexpr double kSettled = 0.3, kInGusts = 2.5;  // [m/s] off that, and of the gusts felt
constexpr double kLevel = 0.5;       // [m/s] up or down: who climbs may not fly at its speed yet
constexpr double kLeastShare = 0.5;  // of the cruise speed, through the air
constexpr double kLongestStep = 5;   // [s] between states that are compared

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

// On a straight flight; who brakes, or becomes slow, is not, however little a second shows of it.
bool WindEstimator::has_settled(const world::VehicleState& state, double dt) {
  const double along = state.velocity.head<2>().dot(nose(state));
  const double turn =
      last_ && dt > 0 ? std::abs(std::remainder(state.heading - last_->heading, 2 * M_PI)) / dt : 0;
  if (!last_ || !last_->airborne || turn > kSteadyTurn || dt > kLongestStep) {
    along_ = along;
    return true;
  }
  along_ += (along - along_) * (1 - std::exp(-dt / kSettles));
  return std::abs(along - along_) <= kSettled + kInGusts * drift_ * gusts_;
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

// A mean wind changes slowly: what surprises is that the vehicle has become slower, or quicker.
void WindEstimator::doubt_air_speed(const Eigen::Vector2d& surprise,
                                    const Eigen::Matrix2d& expected) {
  if (surprise.dot(expected.inverse() * surprise) <= kSurprising) return;
  const double speed = kAirSpeedShare * cruise_;
  for (int i = 0; i < 2; ++i) covariance_(2, i) = covariance_(i, 2) = 0;
  covariance_(2, 2) = std::max(covariance_(2, 2), speed * speed);
}

void WindEstimator::see(const world::VehicleState& state, MissionTime at) {
  const double dt = last_ ? (at - last_at_).to_seconds() : 0;
  const bool settled = has_settled(state, dt);
  const bool steady = drift_ > 0 && settled && is_steady(state, dt);
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
  const double of_one = gust * gust + kUnmodelled * kUnmodelled;
  doubt_air_speed(surprise,
                  sees * covariance_ * sees.transpose() + of_one * Eigen::Matrix2d::Identity());
  const double noise = of_one * std::max(1.0, kCorrelated / dt);
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
