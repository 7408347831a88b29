// SPDX-License-Identifier: Apache-2.0
#include "vehicle/mavlink_vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mav.hpp"

namespace skein::autopilot::testing {

using world::Vector2;
using world::Vector3;

namespace {

constexpr Duration kStep = Duration::milliseconds(100);
constexpr Duration kHeartbeats = Duration::milliseconds(1'000);
constexpr std::uint8_t kDenied = 2, kUnsupported = 3, kFailed = 4;

Vector3 on_ground(const world::Terrain& terrain, const Vector2& at) {
  return {at.x(), at.y(), terrain.elevation(at.x(), at.y())};
}

std::uint16_t from_north(double heading) {
  const double turn = 2 * std::numbers::pi;
  const double north = std::fmod(std::numbers::pi / 2 - heading + 2 * turn, turn);
  return static_cast<std::uint16_t>(std::lround(north * 18000 / std::numbers::pi) % 36000);
}

}  // namespace

MavlinkVehicle::MavlinkVehicle(const MavlinkVehicleConfig& config)
    : config_(config),
      frame_(config.origin),
      vehicle_(config.model, on_ground(config.terrain, config.start), 0, 1),
      guidance_(config.model, config_.terrain, {}),
      home_(vehicle_.state().position),
      mode_(config.dialect == Dialect::kPx4 ? guided_mode(config.dialect) : 0) {
  forget_messages();
}

void MavlinkVehicle::forget_messages() { periods_ = {{mavlink::Heartbeat::kId, kHeartbeats}}; }

int MavlinkVehicle::count(std::uint16_t command) const {
  const auto found = counts_.find(command);
  return found == counts_.end() ? 0 : found->second;
}

void MavlinkVehicle::hear(const mavlink::Bytes& bytes) {
  for (const mavlink::Frame& frame : parser_.take(bytes)) {
    const auto message = mavlink::to_message(frame);
    if (const auto* one = std::get_if<mavlink::CommandLong>(&*message)) carry_out(*one);
    if (const auto* one = std::get_if<mavlink::CommandInt>(&*message)) carry_out(*one);
  }
  // Ids 69 and 70 are not known to the parser: they would stand in the bytes as they are.
  const bool sticks = bytes.size() > 9 && bytes[0] == mavlink::kMagic &&
                      (bytes[7] == 69 || bytes[7] == 70) && bytes[8] == 0 && bytes[9] == 0;
  heard_sticks_ = heard_sticks_ || sticks;
}

std::vector<mavlink::Bytes> MavlinkVehicle::step(Duration now) {
  for (; now_ + kStep <= now; now_ = now_ + kStep) {
    fly();
    follow_modes();
    tell();
  }
  std::vector<mavlink::Bytes> sent = std::exchange(sent_, {});
  return silent_ ? std::vector<mavlink::Bytes>() : sent;
}

// ---- commands ----

bool MavlinkVehicle::is_refused(std::uint16_t command) {
  ++counts_[command];
  const auto refused = refused_.find(command);
  if (refused == refused_.end()) return false;
  answer(command, refused->second);
  return true;
}

void MavlinkVehicle::carry_out(const mavlink::CommandLong& command) {
  if (!is_refused(command.command)) answer(command.command, obey(command));
}

void MavlinkVehicle::carry_out(const mavlink::CommandInt& command) {
  if (is_refused(command.command)) return;
  const bool known = command.command == mav::kDoReposition;
  answer(command.command, known ? reposition(command) : kUnsupported);
}

std::uint8_t MavlinkVehicle::obey(const mavlink::CommandLong& command) {
  switch (command.command) {
    case mav::kDoSetMode:
      return obey_mode(command);
    case mav::kComponentArmDisarm:
      if (command.param1 < 0.5F && vehicle_.state().airborne) return kDenied;
      armed_ = command.param1 > 0.5F;
      if (armed_) home_ = vehicle_.state().position;
      return mav::kAccepted;
    case mav::kNavTakeoff:
      return take_off(command);
    case mav::kDoChangeSpeed:
      return mav::kAccepted;
    case mav::kDoDigicamControl:
      if (command.param5 > 0.5F) ++pictures_;
      return mav::kAccepted;
    case mav::kSetMessageInterval:
      periods_[static_cast<std::uint32_t>(command.param1)] =
          Duration::nanoseconds(static_cast<std::int64_t>(command.param2) * 1000);
      return mav::kAccepted;
    default:
      return kUnsupported;
  }
}

std::uint8_t MavlinkVehicle::obey_mode(const mavlink::CommandLong& command) {
  const auto main = static_cast<CustomMode>(command.param2);
  const auto sub = static_cast<CustomMode>(command.param3);
  set_mode(config_.dialect == Dialect::kPx4 ? (main << 16U) | (sub << 24U) : main);
  return mav::kAccepted;
}

std::uint8_t MavlinkVehicle::take_off(const mavlink::CommandLong& command) {
  if (!armed_ || vehicle_.state().airborne || mode_ != guided_mode(config_.dialect)) return kFailed;
  // From mean sea level, or from home.
  const double height = config_.dialect == Dialect::kPx4
                            ? static_cast<double>(command.param7) + config_.geoid
                            : static_cast<double>(command.param7) + home_.z();
  const Vector3 at =
      frame_.to_local({config_.origin.latitude_degrees, config_.origin.longitude_degrees, height});
  const bool is_px4 = config_.dialect == Dialect::kPx4;
  guidance_.set(sim::Rise{vehicle_.state().position.head<2>(), is_px4 ? at.z() : height});
  if (const auto own = takeoff_mode(config_.dialect)) mode_ = *own;
  return mav::kAccepted;
}

std::uint8_t MavlinkVehicle::reposition(const mavlink::CommandInt& command) {
  if (!armed_ || !vehicle_.state().airborne || command.frame != mav::kFrameGlobal) return kFailed;
  if (command.param2 > 0.5F) mode_ = guided_mode(config_.dialect);
  const Vector3 to = frame_.to_local(
      {command.x / 1e7, command.y / 1e7, static_cast<double>(command.z) + config_.geoid});
  const double speed =
      command.param1 > 0 ? static_cast<double>(command.param1) : config_.model.cruise_speed;
  guidance_.set(sim::Fly{{to}, speed});
  return mav::kAccepted;
}

void MavlinkVehicle::answer(std::uint16_t command, std::uint8_t result) {
  if (mute_) return;
  mavlink::CommandAck ack;
  ack.command = command;
  ack.result = result;
  send(ack);
}

// ---- flight ----

bool MavlinkVehicle::is_home_mode() const {
  return name_of(config_.dialect, mode_) == "RTL" || name_of(config_.dialect, mode_) == "Return";
}

void MavlinkVehicle::set_mode(CustomMode mode) {
  if (std::exchange(mode_, mode) == mode || !vehicle_.state().airborne) return;
  const Vector3& at = vehicle_.state().position;
  if (mode == land_mode(config_.dialect)) {
    guidance_.set(sim::Descend{at.head<2>()});
  } else if (is_home_mode()) {
    guidance_.set(sim::Fly{{Vector3(home_.x(), home_.y(), at.z())}, config_.model.cruise_speed});
  } else {
    guidance_.set(sim::Brake{});
  }
}

void MavlinkVehicle::begin_failsafe() {
  critical_ = true;
  set_mode(config_.dialect == Dialect::kPx4 ? (4U << 16U) | (5U << 24U) : 6);
}

void MavlinkVehicle::fly() {
  const sim::Command command = guidance_.next(vehicle_, Vector3::Zero(), 0);
  vehicle_.step(armed_ ? command : sim::Command{0, 0, 0, std::nullopt, true}, Vector3::Zero(),
                config_.terrain, kStep.to_seconds());
  guidance_.update(vehicle_, kStep.to_seconds());
}

void MavlinkVehicle::follow_modes() {
  const bool there = guidance_.done() && vehicle_.state().airborne;
  if (mode_ == takeoff_mode(config_.dialect) && there) mode_ = guided_mode(config_.dialect);
  if (is_home_mode() && there) guidance_.set(sim::Descend{home_.head<2>()});
  const bool descends = mode_ == land_mode(config_.dialect) || is_home_mode();
  if (descends && guidance_.done() && !vehicle_.state().airborne) armed_ = false;
}

// ---- what it tells ----

double MavlinkVehicle::sea_height() const {
  return frame_.to_geodetic(vehicle_.state().position).altitude - config_.geoid;
}

mavlink::Heartbeat MavlinkVehicle::heartbeat() const {
  const bool is_px4 = config_.dialect == Dialect::kPx4;
  mavlink::Heartbeat heartbeat;
  heartbeat.type = 2;
  heartbeat.autopilot = is_px4 ? mav::kPx4 : mav::kArdupilot;
  heartbeat.custom_mode = mode_;
  const unsigned main = (mode_ >> 16U) & 0xffU;
  const bool manual = !is_px4 || (main != 4 && main != 6);
  heartbeat.base_mode = static_cast<std::uint8_t>(
      mav::kCustomModeFlag | (armed_ ? mav::kArmedFlag : 0) | (manual ? mav::kManualInputFlag : 0));
  const std::uint8_t sound = armed_ ? mav::kStateActive : 3;
  heartbeat.system_status = critical_ ? mav::kStateCritical : sound;
  return heartbeat;
}

mavlink::GlobalPositionInt MavlinkVehicle::position() const {
  const world::VehicleState& state = vehicle_.state();
  const world::GeodeticPoint point = frame_.to_geodetic(state.position);
  const auto in = [](double value, double scale) {
    return static_cast<std::int32_t>(std::lround(value * scale));
  };
  mavlink::GlobalPositionInt position;
  position.time_boot_ms = static_cast<std::uint32_t>(now_.to_seconds() * 1e3);
  position.lat = in(point.latitude_degrees, 1e7);
  position.lon = in(point.longitude_degrees, 1e7);
  position.alt = in(sea_height(), 1e3);
  position.relative_alt = in(state.position.z() - home_.z(), 1e3);
  position.vx = static_cast<std::int16_t>(in(state.velocity.y(), 100));
  position.vy = static_cast<std::int16_t>(in(state.velocity.x(), 100));
  position.vz = static_cast<std::int16_t>(in(-state.velocity.z(), 100));
  position.hdg = from_north(state.heading);
  return position;
}

mavlink::Message MavlinkVehicle::message_of(std::uint32_t message) const {
  const auto left = static_cast<std::int8_t>(
      battery_ < 0 ? static_cast<int>(vehicle_.state().energy * 100) : battery_);
  switch (message) {
    case mavlink::GlobalPositionInt::kId:
      return position();
    case mavlink::ExtendedSysState::kId:
      return mavlink::ExtendedSysState{0, std::uint8_t(vehicle_.state().airborne ? 2 : 1)};
    case mavlink::SysStatus::kId: {
      mavlink::SysStatus status;
      status.battery_remaining = left;
      return status;
    }
    case mavlink::BatteryStatus::kId: {
      mavlink::BatteryStatus status;
      status.battery_remaining = left;
      return status;
    }
    case mavlink::Attitude::kId: {
      mavlink::Attitude attitude;
      attitude.yaw = static_cast<float>(std::numbers::pi / 2 - vehicle_.state().heading);
      return attitude;
    }
    default:
      return heartbeat();
  }
}

void MavlinkVehicle::tell() {
  for (const auto& [message, period] : periods_) {
    Duration& next = next_[message];
    if (period <= Duration() || now_ < next) continue;
    next = now_ + period;
    send(message_of(message));
  }
}

void MavlinkVehicle::say(const std::string& words) {
  mavlink::StatusText text;
  text.severity = mav::kSeverityWarning;
  std::copy_n(words.begin(), std::min(words.size(), text.text.size()), text.text.begin());
  send(text);
}

void MavlinkVehicle::send(const mavlink::Message& message) {
  sent_.push_back(mavlink::to_bytes(mavlink::to_frame(message, {config_.system, 1}, sequence_++)));
}

}  // namespace skein::autopilot::testing
