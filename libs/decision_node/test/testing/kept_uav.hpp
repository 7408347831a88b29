// SPDX-License-Identifier: Apache-2.0
// A decision node over level ground, with a vehicle that does what it is told and a log of what was
// asked of it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "testing/merged_team.hpp"

namespace skein::decision_node::testing {

/// The ground station is not heard from then on, and the contact-loss policy due [s].
inline constexpr double kLost = 10, kDue = 40;

/// What a test may set otherwise before the node is made.
struct KeptUavSetup {
  int degree = 3;
  ContactPolicy policy = ContactPolicy::kHold;
  std::vector<world::Volume> volumes = {};
  bool drives = false;
};

inline KeptUavSetup of(ContactPolicy policy, int degree = 3) {
  KeptUavSetup setup;
  setup.policy = policy;
  setup.degree = degree;
  return setup;
}

/// Closed from `from` [s] on: a square about `middle`, whose sides are twice `half` [m].
inline world::Volume closed(const std::string& name, const Vector3& middle, double half,
                            double from = 0) {
  const double x = middle.x(), y = middle.y();
  world::Volume volume;
  volume.name = name;
  volume.polygon = {
      {x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
  volume.when.from = MissionTime::seconds(from);
  return volume;
}

/// "marvin", which hovers, at home at (0, 0, 50). Its contact-loss policy is due after 30 s.
class KeptUav {
 public:
  explicit KeptUav(const KeptUavSetup& setup = {}) : node_(config_of(setup)) {
    give(Started{true});
    give(Contact{kGround, true, true});
  }

  /// All words of `log` since the last call.
  std::vector<std::string> news() { return std::exchange(log_, {}); }

  void give(const Input& input) {
    for (const Effect& effect : node_.handle(input, now_)) note(effect);
    while (!statuses_.empty()) {
      const StatusTold status = statuses_.front();
      statuses_.pop_front();
      for (const Effect& effect : node_.handle(status, now_)) note(effect);
    }
  }
  void command(mission::Request request) { give(Command{{1, ++commands_}, std::move(request)}); }
  /// Time passes, and at the end of it the vehicle tells where it is.
  void at(double seconds) {
    now_ = MissionTime::seconds(seconds);
    give(Tick{});
    tell();
  }
  void flies_at(const Vector3& place, double energy = 1) {
    state_.position = place;
    state_.airborne = place.z() > 0;
    state_.energy = energy;
    tell();
  }
  /// At `seconds`, in the air at (100, 0, 50), it hears nothing of the ground station any more.
  void loses_the_ground(double seconds) {
    flies_at({100, 0, 50});
    now_ = MissionTime::seconds(seconds);
    give(Contact{kGround, true, false});
  }
  /// The vehicle ends the task of this type that is under way, or gives it up.
  void ends(const std::string& type) { over(type, functional::TaskState::kEnded, ""); }
  void gives_up(const std::string& type, const std::string& why) {
    over(type, functional::TaskState::kAborted, why);
  }
  /// Of interruptions, when the vehicle does not brake at once: see stops().
  void brakes_slowly() { brakes_ = false; }
  void stops() {
    for (const functional::TaskId id : std::exchange(braking_, {})) aborted(id);
    give(Tick{});
  }

  std::vector<std::string> under_way() const {
    std::vector<std::string> types;
    for (const auto& [id, type] : under_way_) types.push_back(type);
    return types;
  }
  /// Of the last goto: its way-points, flat.
  const std::vector<double>& last_way() const { return last_way_; }
  std::uint64_t last_id() const { return last_id_; }
  const std::vector<HandedOver>& handed_over() const { return handed_over_; }
  /// What it told of a task last: "scheduled", …; "" if nothing.
  std::string last_told_of(std::uint64_t task) const {
    const auto told = told_.find(functional::TaskId(task));
    return told == told_.end() ? "" : std::string(to_text(told->second));
  }

  static constexpr const char* kGround = "ground";

 private:
  static Config config_of(const KeptUavSetup& setup) {
    Config config;
    config.uav = "marvin";
    config.degree = setup.degree;
    config.contact_policy = setup.policy;
    config.contact_after = Duration::seconds(30);
    config.drives = setup.drives;
    config.home = {0, 0, 50};
    auto knowledge = std::make_shared<supervisor::Knowledge>(*knowledge_of("marvin"));
    knowledge->vehicle.energy.hover_power = knowledge->vehicle.energy.cruise_power = 1000;
    knowledge->home = {0, 0, 0};
    config.knowledge = knowledge;
    const world::AirspaceGrid air{{-400, -400, 0}, 20, {40, 40, 12}};
    config.world = std::make_shared<world::World>(
        world::World{{}, *MergedTeam::level_ground(), {}, air, setup.volumes, {}, {}, {}, {}});
    return config;
  }

  void tell() {
    world::Telemetry telemetry;
    telemetry.uav = "marvin";
    telemetry.state = state_;
    give(telemetry);
  }
  void note(const Effect& effect) {
    if (const auto* one = std::get_if<ToVehicle>(&effect)) ask(one->request);
    if (const auto* one = std::get_if<PolicyCarriedOut>(&effect))
      log_.push_back("policy " + std::string(to_text(one->policy)) +
                     (one->why.empty() ? "" : ": " + one->why));
    if (const auto* one = std::get_if<Notice>(&effect)) log_.push_back("notice: " + one->text);
    if (const auto* one = std::get_if<HandedOver>(&effect)) handed_over_.push_back(*one);
    if (const auto* one = std::get_if<TaskChanged>(&effect))
      told_[one->event.id] = one->event.state;
  }
  void ask(const functional::Request& request) {
    if (request.verb == functional::Verb::kDispatch) {
      log_.push_back("dispatch " + request.type);
      under_way_[request.id] = request.type;
      last_id_ = request.id.value();
      if (const auto* way = request.parameters.find("waypoints")) last_way_ = way->numbers;
      statuses_.push_back({{request.id, functional::TaskState::kRunning, ""}});
    } else if (request.verb == functional::Verb::kInterrupt) {
      log_.push_back("interrupt " + under_way_[request.id]);
      brakes_ ? aborted(request.id) : braking_.push_back(request.id);
    }
  }
  void aborted(functional::TaskId id) {
    under_way_.erase(id);
    statuses_.push_back({{id, functional::TaskState::kAborted, "interrupted"}});
  }
  void over(const std::string& type, functional::TaskState state, const std::string& why) {
    const auto found = std::find_if(under_way_.begin(), under_way_.end(),
                                    [&](const auto& one) { return one.second == type; });
    ASSERT_NE(found, under_way_.end()) << "no " << type << " is under way";
    const functional::TaskId id = found->first;
    under_way_.erase(found);
    give(StatusTold{{id, state, why}});
  }

  DecisionNode node_;
  MissionTime now_;
  world::VehicleState state_;
  std::uint64_t commands_ = 0;
  std::map<functional::TaskId, std::string> under_way_;
  std::deque<StatusTold> statuses_;
  std::vector<functional::TaskId> braking_;
  bool brakes_ = true;
  std::vector<double> last_way_;
  std::uint64_t last_id_ = 0;
  std::vector<HandedOver> handed_over_;
  std::map<functional::TaskId, functional::TaskState> told_;
  std::vector<std::string> log_;
};

}  // namespace skein::decision_node::testing
