// SPDX-License-Identifier: Apache-2.0
#include "skein/autopilot/bridge.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "commands.hpp"
#include "flight.hpp"
#include "hand.hpp"
#include "listener.hpp"
#include "looks.hpp"
#include "mav.hpp"
#include "picture.hpp"
#include "skein/elementary/task_checks.hpp"
#include "skein/foundation/contract.hpp"
#include "status_board.hpp"

namespace skein::autopilot {

namespace {

using elementary::ElementaryTask;
using functional::Request;

constexpr Duration kSecond = Duration::milliseconds(1'000);
constexpr Duration kAskAgainAfter = Duration::milliseconds(10'000);
/// Lower than this a landing is not stopped any more [m].
constexpr double kCommittedHeight = 3;

/// What we want to hear: message and period [µs].
constexpr std::array kIntervals = {std::pair(mavlink::GlobalPositionInt::kId, 200'000),
                                   std::pair(mavlink::Attitude::kId, 500'000),
                                   std::pair(mavlink::ExtendedSysState::kId, 500'000),
                                   std::pair(mavlink::SysStatus::kId, 1'000'000),
                                   std::pair(mavlink::BatteryStatus::kId, 2'000'000)};

template <class Task>
bool is(const ElementaryTask& task) {
  return std::holds_alternative<Task>(task);
}

}  // namespace

class Bridge::Implementation {
 public:
  explicit Implementation(BridgeConfig config)
      : config_(std::move(config)),
        picture_(config_),
        listener_(config_, picture_),
        out_(config_.own),
        commands_(config_.own),
        flight_(config_.model),
        looks_(config_) {}
  // Its parts refer to each other.
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  std::vector<Effect> handle(const Input& input, Duration now) {
    now_ = std::max(now_, now);
    std::visit([&](const auto& one) { take(one); }, input);
    watch_link();
    watch_hand();
    watch_contact();
    settle(commands_.step(now_, out_));
    fly();
    looks_.step(system(), now_, commands_, board_, out_);
    release_perception();
    tell();
    return out_.take();
  }

  bool is_ready() const { return picture_.is_located(now_); }
  const mavlink::ParserCounts& counts() const { return listener_.counts(); }

 private:
  /// | from | when | to | told |
  /// | – | request accepted | asked | – |
  /// | asked | the autopilot has taken it (a wait, a perception: at once) | active | running |
  /// | active | what was asked for has come true, or the duration is over | – | ended |
  /// | asked, active | the autopilot refuses, or does not answer | – | aborted |
  /// | asked, active | interrupted | stopping | – |
  /// | stopping | at rest; a landing too low: on the ground | – | aborted |
  struct Motion {
    enum class Phase : std::uint8_t { kAsked, kActive, kStopping };
    TaskId id;
    ElementaryTask task;
    Phase phase = Phase::kAsked;
    Duration ends = Duration::max();  ///< of a wait
    std::string stopped_because = "interrupted";
  };

  std::uint8_t system() const { return listener_.system().value_or(0); }
  Pilotage pilotage() const { return {config_, picture_, system()}; }

  void take(const Tick&) {}
  void take(const Heard& heard) {
    for (const auto& [ack, from] : listener_.take(heard.bytes, now_, out_)) {
      settle(commands_.hear(ack, from, now_, out_));
    }
  }
  void take(const ContactLost& contact) {
    if (contact.forgotten) give_up("the decision node has forgotten it");
    if (!contact.lost) silent_since_.reset();
    if (contact.lost && !silent_since_) silent_since_ = now_;
  }
  void take(const Request& request) {
    if (request.verb == functional::Verb::kInterrupt) return interrupt(request.id);
    if (board_.knows(request.id)) return board_.repeat(request.id, out_);
    if (const auto why = dispatch(request))
      board_.tell(request.id, TaskState::kAborted, *why, out_);
  }

  /// Why it is refused; absent when it has begun.
  std::optional<std::string> dispatch(const Request& request) {
    auto task = elementary::checked_task(request.type, request.parameters,
                                         {config_.model, config_.terrain, picture_.state(), true});
    if (!picture_.is_linked(now_)) return "no autopilot is heard";
    if (!picture_.is_located(now_)) return "the autopilot does not say where the vehicle is";
    if (!task) return task.error().why;
    if (hand_.taken()) return *hand_.taken();
    if (auto* shot = std::get_if<elementary::TakeshotTask>(&*task)) {
      if (const auto why = looks_.refusal(shot->device)) return why;
      looks_.start(request.id, std::move(*shot), now_, board_, out_);
      return std::nullopt;
    }
    if (motion_) return "motion task " + to_text(motion_->id) + " is still active";
    if (const auto* stay = std::get_if<elementary::PerceiveTask>(&*task)) {
      if (const auto why = looks_.refusal(stay->shot.device)) return why;
    }
    board_.note(request.id);
    motion_ = Motion{request.id, std::move(*task)};
    begin();
    return std::nullopt;
  }

  void begin() {
    const ElementaryTask& task = motion_->task;
    if (const auto* up = std::get_if<elementary::TakeoffTask>(&task))
      return flight_.begin(pilotage().take_off(up->height));
    if (const auto* go = std::get_if<elementary::GotoTask>(&task))
      return flight_.begin(pilotage().fly(go->waypoints, go->speed));
    if (is<elementary::LandTask>(task)) return flight_.begin(pilotage().land());
    motion_->phase = Motion::Phase::kActive;
    if (const auto* stay = std::get_if<elementary::PerceiveTask>(&task))
      return looks_.start(motion_->id, stay->shot, now_, board_, out_);
    const auto& duration = std::get<elementary::WaitTask>(task).duration;
    if (duration) motion_->ends = now_ + *duration;
    board_.tell(motion_->id, TaskState::kRunning, "", out_);
  }

  void interrupt(TaskId task) {
    if (motion_ && motion_->id == task) return stop();
    if (looks_.abort(task, "interrupted", board_, out_)) return;
    if (board_.knows(task)) return board_.repeat(task, out_);
    board_.tell(task, TaskState::kAborted, "no such task here", out_);
  }

  void stop() {
    if (motion_->phase == Motion::Phase::kStopping) return;
    if (!moves() || !(picture_.is_armed() || picture_.state().airborne)) {
      commands_.drop();
      flight_.drop();
      return finish(TaskState::kAborted, "interrupted");
    }
    const world::Vector3& at = picture_.state().position;
    const double height = at.z() - config_.terrain.elevation(at.x(), at.y());
    const bool lands = is<elementary::LandTask>(motion_->task);
    if (lands && motion_->phase == Motion::Phase::kActive && height < kCommittedHeight) {
      motion_->stopped_because = "interrupted too low to stop the landing: landed";
    } else {
      flight_.begin(pilotage().come_to_rest());
    }
    motion_->phase = Motion::Phase::kStopping;
  }

  /// The autopilot is to do something for the task.
  bool moves() const {
    return motion_ && !is<elementary::WaitTask>(motion_->task) &&
           !is<elementary::PerceiveTask>(motion_->task);
  }

  void settle(const std::vector<Commands::Outcome>& outcomes) {
    for (const Commands::Outcome& one : outcomes) {
      flight_.hear(one);
      looks_.hear(one, picture_.state(), board_, out_);
    }
  }

  void fly() {
    const Flight::Stage stage = flight_.step(picture_, now_, commands_, hand_, out_);
    if (motion_ && !moves()) {
      if (now_ >= motion_->ends) finish(TaskState::kEnded, "");
    } else if (motion_) {
      advance(stage);
    }
    const bool over = stage == Flight::Stage::kDone || stage == Flight::Stage::kFailed;
    if (over) flight_.drop();
  }

  void advance(Flight::Stage stage) {
    const bool stops = motion_->phase == Motion::Phase::kStopping;
    const bool begun = stage == Flight::Stage::kUnderWay || stage == Flight::Stage::kDone;
    if (begun && motion_->phase == Motion::Phase::kAsked) {
      motion_->phase = Motion::Phase::kActive;
      board_.tell(motion_->id, TaskState::kRunning, "", out_);
    }
    if (stage == Flight::Stage::kFailed) {
      return finish(TaskState::kAborted,
                    stops ? motion_->stopped_because + "; " + flight_.why() : flight_.why());
    }
    if (stage != Flight::Stage::kDone) return;
    if (stops) return finish(TaskState::kAborted, motion_->stopped_because);
    finish(TaskState::kEnded, "");
  }

  void finish(TaskState state, std::string reason) {
    const TaskId id = motion_->id;
    motion_.reset();
    // A perception under way is told of by the looks.
    if (looks_.abort(id, reason, board_, out_)) return;
    board_.tell(id, state, std::move(reason), out_);
  }

  void release_perception() {
    if (motion_ && is<elementary::PerceiveTask>(motion_->task) && !looks_.runs(motion_->id))
      motion_.reset();
  }

  void abort_everything(const std::string& reason) {
    if (motion_) finish(TaskState::kAborted, reason);
    looks_.abort_all(reason, board_, out_);
    commands_.drop();
    flight_.drop();
  }

  /// The vehicle stays where it is.
  void give_up(const std::string& reason) {
    const bool moving = moves() && picture_.state().airborne;
    abort_everything(reason);
    if (moving) flight_.begin(pilotage().come_to_rest());
  }

  void watch_contact() {
    if (!silent_since_ || now_ - *silent_since_ < config_.patience) return;
    if (motion_) give_up("contact with the decision node lost");
    looks_.abort_all("contact with the decision node lost", board_, out_);
  }

  void watch_link() {
    const bool linked = picture_.is_linked(now_);
    if (linked && !picture_.is_located(now_) && now_ >= ask_again_at_) ask_for_messages();
    if (linked == std::exchange(was_linked_, linked)) return;
    if (linked) {
      out_.say("the autopilot of system " + std::to_string(system()) + " is heard, in mode " +
               name_of(picture_.dialect(), picture_.mode()));
      return;
    }
    out_.say("the autopilot is not heard any more");
    abort_everything("the autopilot is not heard any more");
  }

  void watch_hand() {
    const bool was_taken = hand_.taken().has_value();
    if (hand_.look_at(picture_, now_)) {
      out_.say(*hand_.taken());
      abort_everything(*hand_.taken());
    } else if (was_taken && !hand_.taken()) {
      out_.say("the vehicle may be asked for tasks again");
    }
    const bool critical = picture_.is_critical();
    if (critical && !std::exchange(was_critical_, critical))
      out_.say("the autopilot says that its state is critical");
    was_critical_ = critical;
  }

  /// Again as long as no position comes: an autopilot may have been started anew.
  void ask_for_messages() {
    ask_again_at_ = now_ + kAskAgainAfter;
    for (const auto& [message, period] : kIntervals) {
      mavlink::CommandLong command;
      command.command = mav::kSetMessageInterval;
      command.target_system = system();
      command.target_component = mav::kAutopilotComponent;
      command.param1 = static_cast<float>(message);
      command.param2 = static_cast<float>(period);
      commands_.ask(command, now_, out_);
    }
  }

  void tell() {
    if (now_ < next_second_) return;
    next_second_ = now_ + kSecond;
    mavlink::Heartbeat heartbeat;
    heartbeat.type = mav::kTypeOnboardController;
    heartbeat.autopilot = mav::kNoAutopilot;
    heartbeat.system_status = mav::kStateActive;
    out_.send(heartbeat);
    if (!picture_.is_located(now_)) return;
    world::Telemetry telemetry{config_.uav, picture_.state(), {}, {}};
    telemetry.state.activity = activity();
    out_.add(std::move(telemetry));
  }

  std::string activity() const {
    if (hand_.taken()) return *hand_.taken();
    const std::string flies = flight_.activity();
    if (!flies.empty()) return flies;
    return picture_.state().airborne ? "hold" : "on the ground";
  }

  BridgeConfig config_;
  Picture picture_;
  Listener listener_;
  Outbox out_;
  Commands commands_;
  Hand hand_;
  Flight flight_;
  Looks looks_;
  StatusBoard board_;
  std::optional<Motion> motion_;
  Duration now_{};
  Duration next_second_{};
  Duration ask_again_at_{};
  std::optional<Duration> silent_since_;
  bool was_linked_ = false;
  bool was_critical_ = false;
};

Bridge::Bridge(BridgeConfig config) {
  SKEIN_EXPECTS(config.model.hovers);
  implementation_ = std::make_unique<Implementation>(std::move(config));
}
Bridge::~Bridge() = default;
Bridge::Bridge(Bridge&&) noexcept = default;
Bridge& Bridge::operator=(Bridge&&) noexcept = default;

std::vector<Effect> Bridge::handle(const Input& input, Duration now) {
  return implementation_->handle(input, now);
}

bool Bridge::is_ready() const { return implementation_->is_ready(); }

const mavlink::ParserCounts& Bridge::counts() const { return implementation_->counts(); }

}  // namespace skein::autopilot
