// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_out/announcer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::mavlink_out {
namespace {

using namespace mavlink;  // NOLINT(google-build-using-namespace): its messages

constexpr std::size_t kMostWords = 64;
constexpr std::size_t kPiece = 50;
constexpr std::size_t kMostPieces = 4;
constexpr Duration kBeat = Duration::milliseconds(1000);
constexpr Duration kMove = Duration::milliseconds(200);
constexpr double kSilence = 3;  // [s]

// Of common.xml.
constexpr std::uint8_t kAutopilot = 1;  // MAV_COMP_ID_AUTOPILOT1
constexpr std::uint8_t kArmed = 0x80, kAuto = 0x04;
constexpr std::uint8_t kStandby = 3, kActive = 4, kCritical = 5;
constexpr std::uint8_t kOnGround = 1, kInAir = 2;

std::uint8_t type_of(world::VehicleKind kind) {
  switch (kind) {
    case world::VehicleKind::kHelicopter:
      return 4;
    case world::VehicleKind::kBlimp:
      return 7;
    case world::VehicleKind::kFixedWing:
      return 1;
    case world::VehicleKind::kGround:
      return 10;
  }
  return 0;
}

template <class Integer>
Integer bounded(double value) {
  using Limits = std::numeric_limits<Integer>;
  if (!std::isfinite(value)) return 0;
  return static_cast<Integer>(std::llround(
      std::clamp(value, static_cast<double>(Limits::min()), static_cast<double>(Limits::max()))));
}

std::int8_t percent(double share) {
  return bounded<std::int8_t>(std::clamp(share, 0.0, 1.0) * 100);
}

/// Clockwise from north, in [0, 2π).
double north_of(double heading) {
  const double turn = 2 * std::numbers::pi;
  const double angle = std::fmod(std::numbers::pi / 2 - heading, turn);
  return angle < 0 ? angle + turn : angle;
}

std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  if (text.size() > kPiece * kMostPieces) text.replace(kPiece * kMostPieces - 3, text.npos, "...");
  return text;
}

}  // namespace

Announcer::Announcer(AnnouncerConfig config) : config_(std::move(config)), frame_(config_.origin) {
  SKEIN_EXPECTS(config_.vehicles.size() <= kMostVehicles);
  for (const Vehicle& vehicle : config_.vehicles) {
    System& system = systems_.emplace_back();
    system.vehicle = vehicle;
    system.address = {static_cast<std::uint8_t>(systems_.size()), kAutopilot};
  }
}

void Announcer::hear(const Heard& heard, Duration now) {
  System* system = find(heard.name);
  if (system == nullptr || (system->heard && heard.at < system->last.at)) return;
  if (!heard.position.allFinite() || !heard.velocity.allFinite()) return;
  system->last = heard;
  system->heard = now;
  system->is_new = true;
}

void Announcer::say(const std::string& name, Severity severity, const std::string& text) {
  if (words_.size() == kMostWords) words_.pop_front();
  words_.push_back({name, severity, printable(text)});
}

std::vector<Bytes> Announcer::turn(Duration now) {
  due_.clear();
  for (System& system : systems_) {
    if (!is_heard(system, now)) continue;
    if (!system.beaten || now - *system.beaten >= kBeat) {
      system.beaten = now;
      tell_state(system);
    }
    if (system.is_new && (!system.moved || now - *system.moved >= kMove)) {
      system.is_new = false;
      system.moved = now;
      tell_position(system);
    }
  }
  tell_words(now);
  return std::exchange(due_, {});
}

bool Announcer::is_heard(const System& system, Duration now) const {
  const double patience = kSilence / std::min(1.0, std::max(config_.rate, 0.001));
  return system.heard && (now - *system.heard).to_seconds() < patience;
}

Announcer::System* Announcer::find(const std::string& name) {
  const auto found = std::find_if(systems_.begin(), systems_.end(), [&](const System& system) {
    return system.vehicle.name == name;
  });
  return found == systems_.end() ? nullptr : &*found;
}

void Announcer::send(System& system, const Message& message) {
  due_.push_back(to_bytes(to_frame(message, system.address, system.sequence++)));
}

void Announcer::tell_state(System& system) {
  const Heard& last = system.last;
  Heartbeat beat;
  beat.type = type_of(system.vehicle.kind);
  beat.base_mode = static_cast<std::uint8_t>(kAuto | (last.airborne ? kArmed : 0));
  beat.system_status = last.in_trouble ? kCritical : last.airborne ? kActive : kStandby;
  send(system, beat);
  SysStatus status;
  status.battery_remaining = percent(last.energy);
  send(system, status);
  BatteryStatus battery;
  battery.temperature = 0x7fff;
  battery.voltages.fill(0xffff);
  battery.battery_remaining = percent(last.energy);
  send(system, battery);
  send(system, ExtendedSysState{0, last.airborne ? kInAir : kOnGround});
}

void Announcer::tell_position(System& system) {
  const Heard& last = system.last;
  const world::GeodeticPoint at = frame_.to_geodetic(last.position);
  const auto boot = static_cast<std::uint32_t>(last.at.count() / 1'000'000);
  const double north = north_of(last.heading);
  GlobalPositionInt position;
  position.time_boot_ms = boot;
  position.lat = bounded<std::int32_t>(at.latitude_degrees * 1e7);
  position.lon = bounded<std::int32_t>(at.longitude_degrees * 1e7);
  position.alt = bounded<std::int32_t>((at.altitude - config_.geoid) * 1000);
  position.relative_alt = bounded<std::int32_t>((last.position.z() - system.vehicle.home) * 1000);
  position.vx = bounded<std::int16_t>(last.velocity.y() * 100);
  position.vy = bounded<std::int16_t>(last.velocity.x() * 100);
  position.vz = bounded<std::int16_t>(-last.velocity.z() * 100);
  position.hdg =
      static_cast<std::uint16_t>(std::lround(north * 18'000 / std::numbers::pi) % 36'000);
  send(system, position);
  Attitude attitude;
  attitude.time_boot_ms = boot;
  attitude.yaw = static_cast<float>(std::remainder(north, 2 * std::numbers::pi));
  send(system, attitude);
}

void Announcer::tell_words(Duration now) {
  std::deque<Words> kept;
  for (Words& words : std::exchange(words_, {})) {
    const auto speaker = std::find_if(systems_.begin(), systems_.end(), [&](const System& one) {
      return is_heard(one, now) && (words.name.empty() || one.vehicle.name == words.name);
    });
    if (speaker == systems_.end()) {
      kept.push_back(std::move(words));  // until it is heard
      continue;
    }
    const bool in_pieces = words.text.size() > kPiece;
    if (in_pieces && ++text_id_ == 0) ++text_id_;
    for (std::size_t from = 0; from == 0 || from < words.text.size(); from += kPiece) {
      StatusText status;
      status.severity = static_cast<std::uint8_t>(words.severity);
      words.text.copy(status.text.data(), kPiece, from);
      status.id = in_pieces ? text_id_ : std::uint16_t{0};
      status.chunk_seq = static_cast<std::uint8_t>(from / kPiece);
      send(*speaker, status);
    }
  }
  words_ = std::move(kept);
}

}  // namespace skein::mavlink_out
