// SPDX-License-Identifier: Apache-2.0
// The UAV's part in merging ways: no motion goes to the vehicle before it has its air.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "component.hpp"
#include "merging/airways.hpp"
#include "merging/home_air.hpp"
#include "merging/left_wait.hpp"
#include "merging/own_flight_ids.hpp"
#include "merging/portions.hpp"
#include "merging/refused_aside.hpp"
#include "merging/vehicle_air.hpp"
#include "merging/waiting.hpp"
#include "merging/way_around.hpp"
#include "skein/merging/merger.hpp"

namespace skein::decision_node {

class Core;

/// The gate between those who ask for motions (executive, ground station, own tasks) and the
/// vehicle. A motion waits until all of its air is reserved; meanwhile its executive takes it for a
/// task that was dispatched and does not run yet, and is told repeatedly that it will come. Air
/// that the vehicle no longer needs is given back piece by piece. A vehicle that moved aside comes
/// back before it does something that has to be done at its place. Without `merging` in the
/// configuration every motion goes to the vehicle at once. Source: spec 6.4;
/// docs/decisions/0019-plan-merging.md.
class Merging final : public Component {
 public:
  explicit Merging(Core& core);

  /// Takes a motion, which waits here or goes to the vehicle with its air; false: it needs no air.
  bool takes(const functional::Request& request);
  /// Drops a motion that waits here; false: it does not wait here.
  bool drop(functional::TaskId task);
  /// Ends a sweep with its current portion, which is to be stopped under the returned number.
  /// Nothing: the vehicle flies no portion of this motion.
  std::optional<functional::TaskId> stop_portions(functional::TaskId task);
  /// A status of the vehicle; true: it is for this component alone.
  bool told(const functional::Status& status);
  /// Whether the vehicle could stay at a place beside all places where others stay or will stay.
  std::function<bool(const world::Vector3&)> free_to_stay() const;
  /// The end of the current flight while the UAV can ask nobody and its way home from there is kept
  /// free: if it stopped before, it would have to hold. Nothing: it may as well stop.
  std::optional<world::Vector3> way_home_begins() const;
  void begin(const Started& started);
  void hear(const MergeTold& told);
  void hear(const WaySearched& done);
  void contact(const Contact& contact);

  void vehicle_told(const world::Telemetry& telemetry) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  void give(const merging::Input& input);
  void carry_out(const merging::Tell& tell);
  void carry_out(const merging::Granted& granted);
  void carry_out(const merging::Waits& waits);
  void carry_out(const merging::MoveAside& aside);
  void ask();
  void want(Airways airways, merging::Volumes afterwards = {});
  void begin(const Airway& airway, const std::string& state);
  void look_at_energy();
  bool may_go_around() const;
  void look_for_way_around();
  void say_it_waits();
  bool may_be_raised(bool asked_long) const;
  void cut();
  void ask_ahead();
  void had_ahead(Airway airway);
  void fly_on();
  void take_portion(functional::Request& flight);
  void portion_over(const functional::Status& status);
  bool flies_portion() const;
  void refuse(std::string why, functional::AbortCause cause = functional::AbortCause::kOther);
  void hold();
  void look_for_room();
  void leave_place();
  void stop_waiting();
  AirwaySituation situation() const;

  Core& core_;
  std::optional<merging::Merger> merger_;
  HomeAir home_;
  merging::Margins margins_;  ///< at its cruise speed
  VehicleAir vehicle_{margins_};
  WayAround around_;
  std::optional<Waiting> waiting_;
  std::optional<Portions> portions_;  ///< of the motion that is flown, or waits
  std::optional<world::Vector3>
      place_;  ///< where it got out of the way from, and did not come back
  std::optional<MissionTime> room_since_;  ///< another one wants to go where it stays, since then
  LeftWait left_wait_;
  supervisor::AirOrders orders_;                    ///< as the supervisor was told
  std::optional<functional::TaskId> runs_already_;  ///< a sweep that begins its last portion
  OwnFlightIds own_ids_;
  RefusedAside refused_;
};

}  // namespace skein::decision_node
