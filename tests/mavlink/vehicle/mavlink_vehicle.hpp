// SPDX-License-Identifier: Apache-2.0
// A vehicle that speaks MAVLink as PX4 or ArduCopter do, as far as the bridge talks with them; it
// flies by the simulator's dynamics and guidance. No autopilot, and no proof about one: where PX4
// and ArduPilot differ from what is written here, it is wrong with us.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "guidance.hpp"
#include "skein/autopilot/dialect.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/mavlink/parser.hpp"

namespace skein::autopilot::testing {

struct MavlinkVehicleConfig {
  Dialect dialect = Dialect::kArdupilot;
  world::VehicleModel model;
  world::Terrain terrain;
  world::GeodeticOrigin origin;
  world::Vector2 start = world::Vector2::Zero();
  double geoid = 47;  ///< of mean sea level over the ellipsoid [m]
  std::uint8_t system = 1;
};

class MavlinkVehicle {
 public:
  explicit MavlinkVehicle(const MavlinkVehicleConfig& config);

  /// Takes bytes of the link.
  void hear(const mavlink::Bytes& bytes);
  /// Flies on until `now`, and gives what it sends, one frame each.
  std::vector<mavlink::Bytes> step(Duration now);

  const world::VehicleState& state() const { return vehicle_.state(); }
  bool is_armed() const { return armed_; }
  CustomMode mode() const { return mode_; }
  int pictures() const { return pictures_; }
  /// How often a command came.
  int count(std::uint16_t command) const;
  bool heard_sticks() const { return heard_sticks_; }

  // ---- what people and bad luck do to it ----
  void set_mode(CustomMode mode);
  void set_armed(bool armed) { armed_ = armed; }
  void set_battery(int percent) { battery_ = percent; }
  /// Low battery, lost link: it says so and flies home by itself.
  void begin_failsafe();
  void say(const std::string& words);
  /// It does everything, and answers nothing.
  void be_mute(bool mute) { mute_ = mute; }
  /// It answers this command by a MAV_RESULT, and does nothing.
  void refuse(std::uint16_t command, std::uint8_t result) { refused_[command] = result; }
  /// Its autopilot was started anew: it sends heartbeats alone.
  void forget_messages();
  /// Nothing comes from it.
  void be_silent(bool silent) { silent_ = silent; }

 private:
  void carry_out(const mavlink::CommandLong& command);
  void carry_out(const mavlink::CommandInt& command);
  std::uint8_t obey(const mavlink::CommandLong& command);
  std::uint8_t obey_mode(const mavlink::CommandLong& command);
  std::uint8_t take_off(const mavlink::CommandLong& command);
  std::uint8_t reposition(const mavlink::CommandInt& command);
  bool is_refused(std::uint16_t command);
  void answer(std::uint16_t command, std::uint8_t result);
  void fly();
  void follow_modes();
  void tell();
  void send(const mavlink::Message& message);
  mavlink::Message message_of(std::uint32_t message) const;
  mavlink::Heartbeat heartbeat() const;
  mavlink::GlobalPositionInt position() const;
  double sea_height() const;
  bool is_home_mode() const;

  MavlinkVehicleConfig config_;
  geodesy::GeodeticFrame frame_;
  sim::Vehicle vehicle_;
  sim::Guidance guidance_;
  world::Vector3 home_;
  CustomMode mode_;
  bool armed_ = false;
  bool critical_ = false, mute_ = false, silent_ = false, heard_sticks_ = false;
  int battery_ = -1;  ///< what was said; negative: what the model has left
  int pictures_ = 0;
  std::map<std::uint16_t, std::uint8_t> refused_;
  std::map<std::uint16_t, int> counts_;
  std::map<std::uint32_t, Duration> periods_, next_;  ///< by message
  mavlink::Parser parser_;
  Duration now_{};
  std::uint8_t sequence_ = 0;
  std::vector<mavlink::Bytes> sent_;
};

}  // namespace skein::autopilot::testing
