// SPDX-License-Identifier: Apache-2.0
// MAVLink telemetry of a team for foreign ground stations.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/mavlink/frame.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::mavlink_out {

struct Vehicle {
  std::string name;
  world::VehicleKind kind = world::VehicleKind::kHelicopter;
  double home = 0;  ///< z of the ground where it starts [m]
};

struct AnnouncerConfig {
  std::vector<Vehicle> vehicles;  ///< system ids from 1, in this order
  world::GeodeticOrigin origin;   ///< of the local frame
  double geoid = 0;               ///< of the sea over the ellipsoid there [m]
  double rate = 1;                ///< mission seconds per second
};

/// The last telemetry of a vehicle, in the local frame.
struct Heard {
  std::string name;
  MissionTime at;  ///< time of the measurement
  world::Vector3 position = world::Vector3::Zero(), velocity = world::Vector3::Zero();
  double heading = 0;  ///< [rad]
  double energy = 0;   ///< share left, in [0, 1]
  bool airborne = false;
  bool in_trouble = false;  ///< a device on board has failed
};

/// As of syslog.
enum class Severity : std::uint8_t { kError = 3, kWarning = 4, kInfo = 6, kDebug = 7 };

/// Each vehicle is a system of its own. As long as it is heard (3 s, of the mission where that is
/// slower), once a second: HEARTBEAT, SYS_STATUS, BATTERY_STATUS, EXTENDED_SYS_STATE; and, as they
/// come, at most five a second: GLOBAL_POSITION_INT and ATTITUDE (heading alone is known: roll and
/// pitch are 0). For a vehicle without telemetry nothing is sent, which stations show as a lost
/// link. Sans-IO;
/// memory is bounded. Source: mavlink.io, common.xml.
class Announcer {
 public:
  /// Precondition: at most kMostVehicles.
  explicit Announcer(AnnouncerConfig config);
  static constexpr std::size_t kMostVehicles = 250;

  /// `now` is steady, here and below. What is older than what was heard before does not count.
  void hear(const Heard& heard, Duration now);
  /// Queues a text for people (STATUSTEXT) in the name of a vehicle, or, for other names, of the
  /// first vehicle with telemetry. Long texts are split; of too many the oldest are dropped.
  void say(const std::string& name, Severity severity, const std::string& text);

  /// Frames that are due, each for a datagram.
  std::vector<mavlink::Bytes> turn(Duration now);

 private:
  struct System {
    Vehicle vehicle;
    mavlink::Address address;
    std::uint8_t sequence = 0;
    Heard last;
    std::optional<Duration> heard, moved, beaten;  ///< when last
    bool is_new = false;                           ///< it was heard and not told since
  };
  struct Words {
    std::string name;
    Severity severity;
    std::string text;
  };

  bool is_heard(const System& system, Duration now) const;
  System* find(const std::string& name);
  void send(System& system, const mavlink::Message& message);
  void tell_position(System& system);
  void tell_state(System& system);
  void tell_words(Duration now);

  AnnouncerConfig config_;
  geodesy::GeodeticFrame frame_;
  std::vector<System> systems_;
  std::deque<Words> words_;
  std::uint16_t text_id_ = 0;
  std::vector<mavlink::Bytes> due_;
};

}  // namespace skein::mavlink_out
