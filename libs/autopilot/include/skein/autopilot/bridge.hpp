// SPDX-License-Identifier: Apache-2.0
// The functional layer of one vehicle whose autopilot speaks MAVLink.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/autopilot/dialect.hpp"
#include "skein/foundation/time.hpp"
#include "skein/functional/port.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/mavlink/frame.hpp"
#include "skein/mavlink/parser.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::autopilot {

struct BridgeConfig {
  std::string uav;
  world::VehicleModel model = {};  ///< one that hovers
  world::Terrain terrain;
  world::GeodeticOrigin origin = {};              ///< of the local frame
  world::Vector2 start = world::Vector2::Zero();  ///< where it stands before the mission [m] ENU
  double energy = 1;                              ///< until the vehicle tells, [0, 1]
  mavlink::Address own = {245, 191};              ///< who the bridge is: an on-board computer
  std::optional<std::uint8_t> system = {};        ///< absent: the first autopilot that is heard
  std::optional<Dialect> dialect = {};            ///< absent: as its heartbeat says
  std::uint8_t camera = 1;  ///< component that takes pictures; 1: by the autopilot's trigger
  Duration patience = Duration::seconds(120);  ///< tasks go on while the decision node is silent
};

/// Time passes.
struct Tick {};
/// What came over the link, in pieces of any size.
struct Heard {
  mavlink::Bytes bytes;
};
/// The vehicle's decision node can no longer be heard, or again; or comes back and knows nothing.
struct ContactLost {
  bool lost = true;
  bool forgotten = false;
};
using Input = std::variant<Tick, Heard, functional::Request, ContactLost>;

/// To the link: one frame.
struct Transmit {
  mavlink::Bytes bytes;
};
/// For people and for the event log.
struct Notice {
  std::string text;
  bool operator==(const Notice&) const = default;
};
/// `at` of telemetry and perceptions is left to who knows mission time.
using Effect =
    std::variant<Transmit, functional::Status, world::Telemetry, world::Perception, Notice>;

/// Keeps the contract of docs/functional-layer.md by MAVLink 2: commands with resending and
/// acknowledgement, guided flight from way-point to way-point, heartbeats.
///
/// | task | what the autopilot is asked | done |
/// | takeoff | guided mode, arm, NAV_TAKEOFF | at the height, no longer climbing |
/// | goto | DO_REPOSITION to each way-point in turn | near the last, slow |
/// | land | its landing mode | it says that it is on the ground |
/// | wait | nothing: it stays where it is | after its duration |
/// | takeshot, perceive, monitor | the camera's trigger once a period | number, duration |
/// | interruption | DO_REPOSITION to where it can stop | at rest for a second |
///
/// The pilot always wins: while the vehicle is armed in a mode that was not asked for, every task
/// is aborted with that reason, nothing more is sent for it, and motion is refused, until the mode
/// is the guided one again or the vehicle is disarmed. The pilot's sticks are never overridden.
///
/// `now` of all calls is one steady clock that runs at mission time's rate, also while mission time
/// is held, and never decreases. Deterministic. Thread rule: one thread. Source: spec 1.1, 2.1;
/// docs/mavlink.md, decision 20.
class Bridge {
 public:
  explicit Bridge(BridgeConfig config);
  ~Bridge();
  Bridge(Bridge&&) noexcept;
  Bridge& operator=(Bridge&&) noexcept;

  /// A Tick is wanted this often.
  static constexpr Duration kPeriod = Duration::milliseconds(100);

  std::vector<Effect> handle(const Input& input, Duration now);

  /// The autopilot is heard and says where the vehicle is.
  bool is_ready() const;
  const mavlink::ParserCounts& counts() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace skein::autopilot
