// SPDX-License-Identifier: Apache-2.0
#include "skein/decision_node/stand_in.hpp"

#include <algorithm>
#include <map>

#include "interaction/interaction.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::decision_node {

namespace {

using executive::TaskState;

constexpr Duration kHeard = Duration::milliseconds(5'000);  // then a partner is out of reach
constexpr const char* kNotAllowed = "its model does not let the ground station play it";

/// From when on it may start, to when.
mission::Interval start_of(const mission::HighLevelTask& task, MissionTime now) {
  const Duration from = std::max(now, task.time.start_after.value_or(now)) - MissionTime();
  const auto before = task.time.start_before;
  return {from, before ? std::max(from, *before - MissionTime()) : Duration::max()};
}

}  // namespace

class StandIn::Host final : public JointHost {
 public:
  explicit Host(Config uav)
      : config_(std::move(uav)),
        world_(config_.world),
        partners_(config_.partner_lease),
        interaction_(*this) {}

  StandInEffects handle(const StandInInput& input, MissionTime now) {
    bus_.begin(now);
    effects_ = {};
    lose_the_silent();
    std::visit([this](const auto& one) { on(one); }, input);
    effects_.said = bus_.end();
    std::erase_if(effects_.said, [](const Effect& one) {
      return std::holds_alternative<ShareTelemetry>(one);  // the UAV's node does it
    });
    return std::move(effects_);
  }

  std::optional<MissionTime> next_wakeup() const {
    if (!started_) return std::nullopt;
    std::optional<MissionTime> next = interaction_.next_wakeup();
    for (const auto& [partner, at] : heard_) {
      if (at) next = earliest(next, *at + kHeard);
    }
    return next;
  }

  bool plays() const { return !joints_.empty(); }
  bool plays(executive::TaskId task) const { return joints_.contains(task); }

  // ---- for joint tasks ----

  Bus& bus() override { return bus_; }
  const Config& config() const override { return config_; }
  Partners& partners() override { return partners_; }
  std::shared_ptr<const world::World> world() const override { return world_; }

  void run(executive::Input input) override {
    if (const auto* start = std::get_if<executive::Start>(&input)) {
      tasks_[start->task.id] = {start->task, TaskState::kScheduled, true, {}};
      effects_.asked.emplace_back(*start);
    } else if (const auto* abort = std::get_if<executive::Abort>(&input)) {
      if (tasks_.contains(abort->id)) effects_.asked.emplace_back(*abort);
    } else if (const auto* status = std::get_if<executive::FunctionalStatus>(&input)) {
      change(status->id, status->state, status->reason);
    }
  }

  bool stops(executive::TaskId) const override { return false; }
  std::vector<mission::HeldTask> held() const override {
    std::vector<mission::HeldTask> all;
    for (const auto& [id, task] : tasks_) all.push_back(task);
    return all;
  }
  executive::TaskId first_role_id() const override { return kFirstPlayedId; }
  void serves(executive::TaskId, executive::TaskId) override {}

  // Nobody plans here: what is loaded is due.
  void answered(const supervisor::JointTaskAnswered& answer) override {
    if (!answer.loaded) return change(answer.task, TaskState::kAborted, answer.why);
    interaction_.due(answer.task, false);
  }

  world::VehicleState when_it_begins(executive::TaskId,
                                     const world::VehicleState& seen) const override {
    return seen;
  }

  std::string why_not(const Joint& joint, const std::string& role) const override {
    return joint.variant->by_ground.contains(role) ? "" : kNotAllowed;
  }

 private:
  void change(executive::TaskId joint, TaskState state, const std::string& why) {
    const auto known = joints_.find(joint);
    if (known == joints_.end()) return;
    effects_.changed.push_back({joint, known->second, state, why});
    if (!is_terminal(state)) return;
    joints_.erase(known);
    if (joints_.empty()) heard_.clear();
  }

  void on(const PlayJointTask& play) {
    const mission::ElementaryTask task = as_planned(play.task, *config_.interaction);
    if (!std::exchange(started_, true)) {
      partners_.start(bus_.now());
      interaction_.start();
    }
    joints_[task.id] = task.type;
    change(task.id, TaskState::kScheduled, "");
    change(task.id, TaskState::kStarted, "");
    for (const std::string& other : config_.others.names()) hear_of(other);
    interaction_.load({task, {start_of(play.task, bus_.now())}});
  }

  void on(const StopPlaying& stop) {
    stop.task ? interaction_.leave(*stop.task, stop.why) : interaction_.leave_all(stop.why);
    // Of one that was never due nothing is told.
    for (const auto& [joint, type] : std::map(joints_)) {
      if (interaction_.is_over(joint)) change(joint, TaskState::kAborted, stop.why);
    }
  }

  // Those that it never had are not told of as tasks: the role hears of it at once.
  void on(const TaskRefused& refused) {
    const auto task = tasks_.find(refused.task);
    if (task == tasks_.end()) return;
    on(executive::TaskEvent{refused.task, task->second.task.type, TaskState::kAborted,
                            refused.why});
  }

  void on(const executive::TaskEvent& event) {
    const auto task = tasks_.find(event.id);
    if (task == tasks_.end()) return;
    task->second.state = event.state;
    if (is_terminal(event.state)) tasks_.erase(task);
    interaction_.task_changed(event);
  }

  void on(const world::Telemetry& telemetry) { interaction_.vehicle_told(telemetry); }
  void on(const PartnerSeen& seen) {
    hear_of(seen.telemetry.uav);
    interaction_.hear(seen);
  }
  void on(const JointTaskTold& told) {
    hear_of(told.status.uav);
    interaction_.hear(told);
  }
  void on(const interaction::SessionMessage& message) {
    hear_of(message.from);
    interaction_.hear(message);
  }
  void on(const PartnerLost& lost) {
    partners_.declare_lost(lost.uav);
    interaction_.time_passes();
  }
  void on(const Tick&) { interaction_.time_passes(); }

  void on(const PlaceTold& told) {
    auto changed = std::make_shared<world::World>(*world_);
    const mission::ChangeWorld& change = told.place;
    if (change.place) {
      changed->places[change.place->name] = change.place->at;
    } else if (!change.ground) {
      std::erase_if(changed->volumes,
                    [&](const auto& one) { return one.name == change.volume.name; });
      if (!change.remove) changed->volumes.push_back(change.volume);
    }
    world_ = std::move(changed);
    interaction_.place_told(change);
  }

  // ---- who is in reach ----

  void hear_of(const std::string& partner) {
    std::optional<MissionTime>& at = heard_[partner];
    if (!at) partners_.contact({partner, false, true}, bus_.now());
    at = bus_.now();
  }

  void lose_the_silent() {
    for (auto& [partner, at] : heard_) {
      if (!at || *at + kHeard > bus_.now()) continue;
      at.reset();
      partners_.contact({partner, false, false}, bus_.now());
    }
  }

  Config config_;
  Bus bus_;
  std::shared_ptr<const world::World> world_;
  Partners partners_;
  Interaction interaction_;
  bool started_ = false;
  std::map<executive::TaskId, std::string> joints_;  ///< not over; their types
  std::map<executive::TaskId, mission::HeldTask> tasks_;
  std::map<std::string, std::optional<MissionTime>> heard_;  ///< when last; absent: out of reach
  StandInEffects effects_;
};

StandIn::StandIn(Config uav) {
  SKEIN_EXPECTS(uav.knowledge != nullptr && uav.world != nullptr && uav.interaction != nullptr);
  host_ = std::make_unique<Host>(std::move(uav));
}
StandIn::~StandIn() = default;
StandIn::StandIn(StandIn&&) noexcept = default;
StandIn& StandIn::operator=(StandIn&&) noexcept = default;

StandInEffects StandIn::handle(const StandInInput& input, MissionTime now) {
  return host_->handle(input, now);
}
std::optional<MissionTime> StandIn::next_wakeup() const { return host_->next_wakeup(); }
bool StandIn::plays() const { return host_->plays(); }
bool StandIn::plays(executive::TaskId task) const { return host_->plays(task); }

}  // namespace skein::decision_node
