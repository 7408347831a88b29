// SPDX-License-Identifier: Apache-2.0
#include "unit.hpp"

#include <algorithm>
#include <utility>

#include "skein/functional/task_types.hpp"

namespace skein::sim {
namespace {

using elementary::ElementaryTask;
using elementary::GotoTask;
using elementary::LandTask;
using elementary::PerceiveTask;
using elementary::TakeoffTask;
using elementary::WaitTask;
using world::Vector2;
using world::Vector3;

/// Lower than this a landing is not stopped any more [m].
constexpr double kCommittedHeight = 3;
constexpr double kCommittedHeightTurning = 20;
constexpr const char* kTakeshot = "takeshot";

Vector3 on_ground(const world::Terrain& terrain, const Vector2& at) {
  return {at.x(), at.y(), terrain.elevation(at.x(), at.y())};
}

/// The goal of guidance for a task that begins in some state; a wait goes on holding where it
/// holds.
Goal goal_of(const ElementaryTask& task, const world::VehicleState& state, const Goal& now) {
  const Vector2 at = state.position.head<2>();
  if (const auto* takeoff = std::get_if<TakeoffTask>(&task)) return Rise{at, takeoff->height};
  if (const auto* go = std::get_if<GotoTask>(&task)) return Fly{go->waypoints, go->speed};
  if (std::holds_alternative<LandTask>(task)) {
    const auto* hold = std::get_if<Hold>(&now);
    return Descend{hold != nullptr ? Vector2(hold->at.head<2>()) : at};
  }
  if (std::holds_alternative<Hold>(now) || std::holds_alternative<Stay>(now)) return now;
  return Brake{};
}

}  // namespace

Unit::Unit(const SimulatedVehicle& vehicle, const SimulatorConfig& config, const Scene& scene)
    : model_(vehicle.model),
      scene_(scene),
      vehicle_(vehicle.model, on_ground(scene.terrain, vehicle.start), vehicle.heading,
               vehicle.energy),
      guidance_(vehicle.model, scene.terrain, config.wind),
      pilot_(vehicle.model, Random(config.seed, vehicle.name + "/pilot")),
      gusts_(config.wind, Random(config.seed, vehicle.name + "/gusts")),
      sensors_(vehicle.model, vehicle.name, config.seed),
      board_(vehicle.name),
      patience_(config.patience),
      speed_factor_(vehicle.speed_factor) {
  vehicle_.state().activity = activity();
}

void Unit::handle(const functional::Request& request, MissionTime now,
                  std::vector<Effect>& effects) {
  if (request.verb == functional::Verb::kInterrupt)
    interrupt(request.id, now, effects);
  else
    dispatch(request, now, effects);
}

void Unit::dispatch(const functional::Request& request, MissionTime now,
                    std::vector<Effect>& effects) {
  if (board_.knows(request.id)) return board_.repeat(request.id, now, effects);
  const auto refuse = [&](const std::string& why) {
    board_.tell(request.id, TaskState::kAborted, why, now, effects);
  };
  auto task =
      elementary::checked_task(request.type, request.parameters,
                               {model_, scene_.terrain, vehicle_.state(), vehicle_.engine_works()});
  if (!task) return refuse(task.error().why);
  if (auto* shot = std::get_if<TakeshotTask>(&*task)) {
    if (const auto why = sensors_.refusal(shot->device)) return refuse(*why);
    if (takes_abort(request.type, now)) return refuse(kAbortedByFault);
    return sensors_.start(request.id, std::move(*shot), now, board_, effects);
  }
  if (motion_) return refuse("motion task " + to_text(motion_->id) + " is still active");
  if (const auto* stay = std::get_if<PerceiveTask>(&*task)) {
    if (const auto why = sensors_.refusal(stay->shot.device)) return refuse(*why);
  }
  if (takes_abort(request.type, now)) return refuse(kAbortedByFault);
  board_.note(request.id);
  motion_ = MotionTask{request.id, request.type, std::move(*task)};
  motion_->begins = now + pilot_.reaction();
  if (motion_->begins <= now) begin(now, effects);
}

void Unit::interrupt(TaskId task, MissionTime now, std::vector<Effect>& effects) {
  if (motion_ && motion_->id == task) {
    if (motion_->stops) return;
    motion_->stops = now + pilot_.reaction();
    if (*motion_->stops <= now) stop(now, effects);
    return;
  }
  if (sensors_.interrupt(task, now, board_, effects)) return;
  if (board_.knows(task)) return board_.repeat(task, now, effects);
  board_.tell(task, TaskState::kAborted, "no such task here", now, effects);
}

void Unit::begin(MissionTime now, std::vector<Effect>& effects) {
  motion_->phase = MotionTask::Phase::kActive;
  guidance_.set(goal_of(motion_->task, vehicle_.state(), guidance_.goal()));
  if (const auto* wait = std::get_if<WaitTask>(&motion_->task); wait != nullptr && wait->duration)
    motion_->ends = now + *wait->duration;
  if (const auto* stay = std::get_if<PerceiveTask>(&motion_->task)) {
    if (const auto why = sensors_.refusal(stay->shot.device))
      return finish(TaskState::kAborted, *why, now, effects);
    return sensors_.start(motion_->id, stay->shot, now, board_, effects);
  }
  board_.tell(motion_->id, TaskState::kRunning, "", now, effects);
}

void Unit::stop(MissionTime now, std::vector<Effect>& effects) {
  if (looks()) return finish(TaskState::kAborted, "interrupted", now, effects);
  const bool landing = std::holds_alternative<Descend>(guidance_.goal());
  motion_->phase = MotionTask::Phase::kStopping;
  come_to_rest();
  if (landing && std::holds_alternative<Descend>(guidance_.goal()))
    motion_->stopped_because = "interrupted too low to stop the landing: landed";
}

/// Stops where it is, unless it holds already; a landing that is nearly done is done.
void Unit::come_to_rest() {
  if (std::holds_alternative<Hold>(guidance_.goal())) return;
  if (std::holds_alternative<Descend>(guidance_.goal()) &&
      height() < (model_.hovers ? kCommittedHeight : kCommittedHeightTurning))
    return;
  if (vehicle_.state().airborne)
    guidance_.set(Brake{});
  else
    guidance_.set(Stay{});
}

void Unit::advance_task(MissionTime now, std::vector<Effect>& effects) {
  if (!motion_) return;
  if (motion_->stops && *motion_->stops <= now && motion_->phase != MotionTask::Phase::kStopping)
    stop(now, effects);
  if (!motion_) return;
  if (motion_->phase == MotionTask::Phase::kStopping) {
    if (guidance_.done()) finish(TaskState::kAborted, motion_->stopped_because, now, effects);
    return;
  }
  if (motion_->phase == MotionTask::Phase::kPending && motion_->begins <= now) begin(now, effects);
  if (!motion_ || motion_->phase != MotionTask::Phase::kActive || looks()) return;
  const bool waits = std::holds_alternative<WaitTask>(motion_->task);
  if (waits ? now >= motion_->ends : guidance_.done()) finish(TaskState::kEnded, "", now, effects);
}

void Unit::finish(TaskState state, std::string reason, MissionTime now,
                  std::vector<Effect>& effects) {
  // A perception under way is told of by the sensors.
  const bool told = looks() && sensors_.abort(motion_->id, reason, now, board_, effects);
  if (!told) board_.tell(motion_->id, state, std::move(reason), now, effects);
  motion_.reset();
}

bool Unit::looks() const { return motion_ && std::holds_alternative<PerceiveTask>(motion_->task); }

/// What it looked at has been seen, or its device failed.
void Unit::release_perception() {
  if (!looks() || motion_->phase != MotionTask::Phase::kActive) return;
  if (!sensors_.runs(motion_->id)) motion_.reset();
}

void Unit::abort_everything(const std::string& reason, MissionTime now,
                            std::vector<Effect>& effects) {
  if (motion_) finish(TaskState::kAborted, reason, now, effects);
  sensors_.abort_all(reason, now, board_, effects);
}

void Unit::handle(const Fault& fault, MissionTime now, std::vector<Effect>& effects) {
  switch (fault.kind) {
    case FaultKind::kSensor:
      sensors_.break_device(fault.device, now, board_, effects);
      return release_perception();
    case FaultKind::kAbort:
      return abort_one(fault, now, effects);
    case FaultKind::kSlow:
      slowed_by_ = fault.factor;
      slow_until_ = now + fault.lasts;
      return;
    case FaultKind::kEnergy:
      vehicle_.state().energy = std::min(vehicle_.state().energy, fault.left);
      break;
    case FaultKind::kEngine:
      vehicle_.break_engine();
      break;
  }
  watch_breakdowns(now, effects);
}

void Unit::abort_one(const Fault& fault, MissionTime now, std::vector<Effect>& effects) {
  const std::string& type = fault.type;
  if (fault.lasts > Duration()) aborts_until_[type] = now + fault.lasts;
  if (motion_ && motion_->type == type && motion_->phase != MotionTask::Phase::kStopping) {
    finish(TaskState::kAborted, kAbortedByFault, now, effects);
    return come_to_rest();
  }
  const auto along = sensors_.oldest(looks() ? std::optional(motion_->id) : std::nullopt);
  if (type == kTakeshot && along) {
    sensors_.abort(*along, kAbortedByFault, now, board_, effects);
    return;
  }
  if (fault.lasts <= Duration()) aborts_.insert(type);
}

/// True once for each fault that waits for a task of the type, and always while one lasts.
bool Unit::takes_abort(const std::string& type, MissionTime now) {
  const auto lasting = aborts_until_.find(type);
  if (lasting != aborts_until_.end() && now < lasting->second) return true;
  const auto found = aborts_.find(type);
  if (found == aborts_.end()) return false;
  aborts_.erase(found);
  return true;
}

double Unit::pace_at(MissionTime now) const {
  return now < slow_until_ ? speed_factor_ / slowed_by_ : speed_factor_;
}

std::vector<std::string> Unit::failed() const {
  std::set<std::string> names = sensors_.broken();
  if (!vehicle_.engine_works()) names.emplace(world::kEngineDevice);
  return {names.begin(), names.end()};
}

void Unit::handle(const ContactLost& contact, MissionTime now, std::vector<Effect>& effects) {
  if (contact.forgotten) give_up("the decision node has forgotten it", now, effects);
  if (!contact.lost) silent_since_.reset();
  if (contact.lost && !silent_since_) silent_since_ = now;
}

void Unit::forget(MissionTime now, std::vector<Effect>& effects) {
  give_up("the functional layer has forgotten it", now, effects);
  board_.forget();
  silent_since_.reset();
}

void Unit::watch_contact(MissionTime now, std::vector<Effect>& effects) {
  if (!silent_since_ || now - *silent_since_ < patience_) return;
  give_up("contact with the decision node lost", now, effects);
}

void Unit::give_up(const char* reason, MissionTime now, std::vector<Effect>& effects) {
  const bool moving = motion_ && !std::holds_alternative<WaitTask>(motion_->task);
  abort_everything(reason, now, effects);
  if (moving) come_to_rest();
}

void Unit::watch_breakdowns(MissionTime now, std::vector<Effect>& effects) {
  if (vehicle_.state().energy <= 0) vehicle_.break_engine();
  if (vehicle_.engine_works() || breakdown_told_) return;
  breakdown_told_ = true;
  const char* reason = vehicle_.crashed()             ? "the vehicle met the ground"
                       : vehicle_.state().energy <= 0 ? "energy used up"
                                                      : "engine failure";
  abort_everything(reason, now, effects);
  guidance_.set(Descend{vehicle_.state().position.head<2>()});
}

void Unit::step(MissionTime now, double dt, std::vector<Effect>& effects) {
  pilot_.attend(now);
  guidance_.look_at(sensors_.target());
  guidance_.set_pace(pace_at(now));
  const Command command = guidance_.next(vehicle_, pilot_.position_error(), pilot_.heading_error());
  const bool still = !vehicle_.state().airborne && command.climb <= 0;
  vehicle_.step(command, still ? Vector3(Vector3::Zero()) : gusts_.next(dt), scene_.terrain, dt);
  guidance_.update(vehicle_, dt);
  watch_breakdowns(now, effects);
  watch_contact(now, effects);
  advance_task(now, effects);
  sensors_.step(vehicle_.state(), pilot_.heading_error(), scene_, now, board_, effects);
  release_perception();
  vehicle_.state().activity = activity();
}

std::string Unit::activity() const {
  if (vehicle_.crashed()) return "crashed";
  if (!vehicle_.engine_works()) return "engine failure";
  const bool stays =
      motion_ && motion_->phase == MotionTask::Phase::kActive &&
      functional::TaskTypes::shipped().of(motion_->type).motion == functional::Motion::kKeeps;
  return stays ? motion_->type + ", " + guidance_.activity() : guidance_.activity();
}

double Unit::height() const {
  const Vector3& at = vehicle_.state().position;
  return at.z() - scene_.terrain.elevation(at.x(), at.y());
}

}  // namespace skein::sim
