// SPDX-License-Identifier: Apache-2.0
// One simulated UAV: vehicle, pilot, guidance, sensors, and the functional layer that runs its
// tasks.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "guidance.hpp"
#include "gusts.hpp"
#include "pilot.hpp"
#include "sensor_suite.hpp"
#include "skein/sim/simulator_config.hpp"
#include "status_board.hpp"

namespace skein::sim {

/// At most one task that holds the vehicle (takeoff, land, goto, wait, perceive, monitor) at a
/// time:
///
/// | from     | when                                    | to       | told              |
/// | –        | request accepted                         | pending  | –                 |
/// | –        | request impossible, or a motion task runs | –        | aborted + reason  |
/// | pending  | pilot has reacted (autopilot: at once)   | active   | running           |
/// | active   | guidance done, or duration over          | –        | ended             |
/// | active   | it looks, and its device failed          | –        | aborted + reason  |
/// | pending, active | interrupt, pilot has reacted      | stopping | –                 |
/// | stopping | at rest (a landing too low: on the ground; one that looks: at once) | – | aborted |
/// | any      | engine failure, energy out, contact lost for longer than patience, the decision
/// node or the layer itself forgot all | – | aborted + reason |
/// | pending, active | fault of the functional layer    | –        | aborted + reason  |
///
/// Between tasks the vehicle holds its position (or circles, or stays on the ground).
class Unit {
 public:
  Unit(const SimulatedVehicle& vehicle, const SimulatorConfig& config, const Scene& scene);

  void handle(const functional::Request& request, MissionTime now, std::vector<Effect>& effects);
  void handle(const Fault& fault, MissionTime now, std::vector<Effect>& effects);
  void handle(const ContactLost& contact, MissionTime now, std::vector<Effect>& effects);
  void forget(MissionTime now, std::vector<Effect>& effects);
  /// Advances to `now`, one step of the physics after the last.
  void step(MissionTime now, double dt, std::vector<Effect>& effects);

  const std::string& name() const { return board_.uav(); }
  const world::VehicleState& state() const { return vehicle_.state(); }
  /// Devices that do not work, in the order of their names; the engine among them.
  std::vector<std::string> failed() const;

 private:
  struct MotionTask {
    enum class Phase { kPending, kActive, kStopping };
    TaskId id;
    std::string type;
    elementary::ElementaryTask task;
    Phase phase = Phase::kPending;
    MissionTime begins = {};                ///< kPending: when the pilot has reacted
    std::optional<MissionTime> stops = {};  ///< when the pilot reacts to an interrupt
    MissionTime ends = MissionTime::max();  ///< of a wait with a duration
    std::string stopped_because = "interrupted";
  };

  void dispatch(const functional::Request& request, MissionTime now, std::vector<Effect>& effects);
  void interrupt(TaskId task, MissionTime now, std::vector<Effect>& effects);
  void begin(MissionTime now, std::vector<Effect>& effects);
  void stop(MissionTime now, std::vector<Effect>& effects);
  void advance_task(MissionTime now, std::vector<Effect>& effects);
  void finish(TaskState state, std::string reason, MissionTime now, std::vector<Effect>& effects);
  void abort_everything(const std::string& reason, MissionTime now, std::vector<Effect>& effects);
  void come_to_rest();
  void abort_one(const Fault& fault, MissionTime now, std::vector<Effect>& effects);
  bool takes_abort(const std::string& type, MissionTime now);
  double pace_at(MissionTime now) const;
  void watch_contact(MissionTime now, std::vector<Effect>& effects);
  void give_up(const char* reason, MissionTime now, std::vector<Effect>& effects);
  void watch_breakdowns(MissionTime now, std::vector<Effect>& effects);
  /// Whether the task that holds the vehicle also uses a sensor.
  bool looks() const;
  void release_perception();
  std::string activity() const;
  double height() const;

  world::VehicleModel model_;
  Scene scene_;
  Vehicle vehicle_;
  Guidance guidance_;
  Pilot pilot_;
  Gusts gusts_;
  SensorSuite sensors_;
  StatusBoard board_;
  std::optional<MotionTask> motion_;
  bool breakdown_told_ = false;
  Duration patience_;
  std::optional<MissionTime> silent_since_ = {};  ///< since when its decision node is silent
  double speed_factor_;
  double slowed_by_ = 1;
  MissionTime slow_until_ = {};
  std::multiset<std::string> aborts_;                ///< types whose next task aborts
  std::map<std::string, MissionTime> aborts_until_;  ///< types of which every task aborts
};

}  // namespace skein::sim
