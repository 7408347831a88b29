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
#include "merging/portions.hpp"
#include "skein/merging/merger.hpp"

namespace skein::decision_node {

class Core;

/// Flights out of the way: beyond the own tasks of Safekeeping, which nobody else may use either.
inline constexpr functional::TaskId kFirstAside{functional::kFirstBackgroundId.value() / 2};

/// Between whoever has a motion (executive, ground station, own tasks) and the vehicle. A motion
/// waits until it has all of its air; meanwhile it is to its executive a task that was dispatched
/// and is not running yet, and the executive is told again and again that it will come. What the
/// vehicle does not need any more is given back, piece by piece. Who got out of the way comes back
/// before it does what it was to do there. Without `merging` in the configuration every motion goes
/// at once. Source: spec 6.4; docs/decisions/0019-plan-merging.md.
class Merging final : public Component {
 public:
  explicit Merging(Core& core);

  /// The motion waits here, or goes to the vehicle when it has its air. False: it needs none.
  bool takes(const functional::Request& request);
  /// A motion that waits here does so no more. False: it does not wait here.
  bool drop(functional::TaskId task);
  /// The motion ends with what the vehicle flies of it now: that is to be stopped, under this
  /// number. Nothing: the vehicle flies no portion of it.
  std::optional<functional::TaskId> stop_portions(functional::TaskId task);
  /// Of what was asked of the vehicle. True: nobody else is to hear of it.
  bool told(const functional::Status& status);
  /// There it could come and stay beside others, wherever they stay or will.
  std::function<bool(const world::Vector3&)> free_to_stay() const;
  /// Where its flight ends, from where its way home is kept for it while it can ask nobody: stopped
  /// before, it would hold. Nothing: it may as well be stopped.
  std::optional<world::Vector3> way_home_begins() const;
  void begin(const Started& started);
  void hear(const MergeTold& told);
  void contact(const Contact& contact);

  void vehicle_told(const world::Telemetry& telemetry) override;
  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  struct Waiting {
    functional::Request request;
    MissionTime since;
    MissionTime said;  ///< to the executive, that it will come
    Airways airways;   ///< that it asks for; none: not yet, or it is to be asked for again
    /// It asks for these to get out of the way, before it wants its own.
    std::optional<MissionTime> aside_since = {};
    merging::Volumes own_air = {};  ///< that it wants afterwards, as far as it knows
    std::vector<std::string> waits_for;
    bool was_aside = false;    ///< it has got out of the way
    bool asked_long = false;   ///< when it asked last it had waited long
    MissionTime looks_around;  ///< for a way around those who have its air, not before
    bool comes_back = false;   ///< it asks for the way back to where it got out of the way from
    /// It asks for a place aside for another's sake, and wants nothing afterwards.
    bool makes_room = false;
    MissionTime noted;  ///< that it waits, for these
    std::vector<std::string> noted_for;
    std::vector<std::string> in_its_way, noted_way;  ///< of these, who has to leave first
    std::string why_not;  ///< the vehicle cannot, as it seemed at the last look

    /// When it asks for higher ways too, with a role's.
    std::optional<MissionTime> rises_from() const;
    /// When it looks for a way around; none: it does not ask for what it is to fly.
    std::optional<MissionTime> looks_around_from() const;
    /// When it no longer asks for a place aside.
    std::optional<MissionTime> aside_until() const;
  };
  /// What the vehicle flies, or has flown last and has not come to rest from.
  struct Flown {
    Airway airway;
    bool over = false, ended = false;
    /// Of the portion before, which it came from in flight, until it has left some of this one.
    merging::Volumes behind = {};

    merging::Volumes air() const;
    /// True: it has left more of its way.
    bool passed(const world::Vector3& position);
    bool flies(functional::TaskId task) const { return !over && airway.request.id == task; }
    /// What it flew aside for is given up, and this needs it to stand still: once it is there.
    bool is_waited_for_by(const functional::Request& request) const;
  };

  void give(const merging::Input& input);
  void carry_out(const merging::Tell& tell);
  void carry_out(const merging::Granted& granted);
  void carry_out(const merging::Waits& waits);
  void carry_out(const merging::MoveAside& aside);
  void ask();
  void want(Airways airways, merging::Volumes afterwards = {});
  void begin(const Airway& airway, const std::string& state);
  void look_at_energy();
  void look_for_way_around();
  void note_waits();
  void say_it_waits();
  void say_it_has_begun();
  void wait_for(functional::Request request);
  bool may_be_raised(bool asked_long) const;
  void cut();
  void ask_ahead();
  void had_ahead(Airway airway);
  void fly_on();
  void take_portion(functional::Request& flight);
  void portion_runs(const functional::Status& status);
  void portion_over(const functional::Status& status);
  bool flies_portion() const;
  void cannot_fly(const std::string& why);
  void refuse(std::string why, functional::AbortCause cause = functional::AbortCause::kOther);
  void come_to_rest();
  void hold();
  void tell_orders();
  bool is_to_come_back(const functional::Request& request) const;
  Airways places_aside(const merging::Volumes& taken, const std::vector<double>& heights = {0});
  void look_for_room();
  void leave_pad();
  bool stays() const;
  bool has_nothing_to_do() const;
  void stop_waiting();
  AirwaySituation situation() const;
  void note(const std::string& state, const Airway* airway);

  Core& core_;
  std::optional<merging::Merger> merger_;
  HomeAir home_;
  merging::Margins margins_;  ///< at its cruise speed
  world::Telemetry seen_;
  bool has_seen_ = false;
  std::optional<world::Vector3> rest_;  ///< where it holds or circles in the air
  std::optional<Flown> flown_;
  std::optional<Waiting> waiting_;
  std::optional<Portions> portions_;  ///< of the motion that is flown, or waits
  std::optional<world::Vector3>
      place_;  ///< where it got out of the way from, and did not come back
  std::optional<MissionTime> room_since_;   ///< another one wants to go where it stays, since then
  supervisor::AirOrders orders_;            ///< as the supervisor was told
  functional::TaskId aside_ = kFirstAside;  ///< of the next flight out of the way
};

}  // namespace skein::decision_node
