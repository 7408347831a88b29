// SPDX-License-Identifier: Apache-2.0
#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mav.hpp"

namespace skein::autopilot {

using world::Vector3;

namespace {

constexpr Duration kLinkLostAfter = Duration::milliseconds(5'000);
constexpr Duration kPositionLostAfter = Duration::milliseconds(3'000);
constexpr double kPerDegree = 1e7;
constexpr std::uint16_t kNoHeading = 0xffff;
/// Higher than this above home an armed vehicle flies, if nobody says otherwise [m].
constexpr double kFlies = 1;

/// From clockwise of north to counter-clockwise of east.
double enu_heading(double from_north) { return world::wrapped(std::numbers::pi / 2 - from_north); }

}  // namespace

Picture::Picture(const BridgeConfig& config)
    : config_(config),
      frame_(config.origin),
      dialect_(config.dialect.value_or(Dialect::kArdupilot)) {
  state_.energy = config.energy;
}

void Picture::hear(const mavlink::Heartbeat& heartbeat, Duration now) {
  heartbeat_ = heartbeat;
  heartbeat_at_ = now;
  if (!config_.dialect) dialect_ = dialect_of(heartbeat.autopilot).value_or(dialect_);
  settle();
}

void Picture::hear(const mavlink::GlobalPositionInt& position, Duration now) {
  const bool no_fix = position.lat == 0 && position.lon == 0;
  const bool possible =
      std::abs(position.lat / kPerDegree) <= 90 && std::abs(position.lon / kPerDegree) <= 180;
  if (no_fix || !possible) return;
  position_ = position;
  position_at_ = now;
  home_height_ = position.alt / 1e3 - position.relative_alt / 1e3;
  settle();
}

void Picture::hear(const mavlink::Attitude& attitude) {
  const bool told = position_ && position_->hdg != kNoHeading;
  if (!told && std::isfinite(attitude.yaw)) state_.heading = enu_heading(attitude.yaw);
}

void Picture::hear(const mavlink::ExtendedSysState& state) {
  landed_state_ = state.landed_state;
  settle();
}

void Picture::hear_battery(int percent) {
  if (percent >= 0) state_.energy = std::min(percent, 100) / 100.0;
}

/// What follows from all that was heard.
void Picture::settle() {
  if (!position_) return;
  const bool high = is_armed() && position_->relative_alt / 1e3 > kFlies;
  const bool landed = landed_state_ == mav::kLandedOnGround;
  state_.airborne = landed_state_ == mav::kLandedUnknown ? high : !landed;
  const double latitude = position_->lat / kPerDegree, longitude = position_->lon / kPerDegree;
  const double sea = position_->alt / 1e3;
  const Vector3 unraised = frame_.to_local({latitude, longitude, sea});
  if (!is_armed() && !state_.airborne) {
    rise_ = config_.terrain.elevation(unraised.x(), unraised.y()) - unraised.z();
  } else if (!rise_) {
    const double start = config_.terrain.elevation(config_.start.x(), config_.start.y());
    rise_ = start + position_->relative_alt / 1e3 - unraised.z();
  }
  Vector3& at = state_.position;
  at = frame_.to_local({latitude, longitude, sea + *rise_});
  // Figures on the wire are rounded; a centimetre under the ground nobody hears it by radio.
  at.z() = std::max(at.z(), config_.terrain.elevation(at.x(), at.y()));
  state_.velocity = Vector3(position_->vy, position_->vx, -position_->vz) / 100;
  if (position_->hdg != kNoHeading)
    state_.heading = enu_heading(position_->hdg / 100.0 * std::numbers::pi / 180);
}

bool Picture::is_linked(Duration now) const {
  return heartbeat_at_ && now - *heartbeat_at_ < kLinkLostAfter;
}

bool Picture::is_located(Duration now) const {
  return is_linked(now) && position_at_ && now - *position_at_ < kPositionLostAfter;
}

bool Picture::is_armed() const { return (heartbeat_.base_mode & mav::kArmedFlag) != 0; }

bool Picture::has_manual_input() const {
  return tells_manual_input(dialect_) && (heartbeat_.base_mode & mav::kManualInputFlag) != 0;
}

bool Picture::is_critical() const { return heartbeat_.system_status >= mav::kStateCritical; }

Place Picture::place_of(const Vector3& local) const {
  const world::GeodeticPoint point = frame_.to_geodetic(local);
  return {static_cast<std::int32_t>(std::lround(point.latitude_degrees * kPerDegree)),
          static_cast<std::int32_t>(std::lround(point.longitude_degrees * kPerDegree)),
          point.altitude - rise_.value_or(0)};
}

}  // namespace skein::autopilot
