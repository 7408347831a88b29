// SPDX-License-Identifier: Apache-2.0
#include "testing/handover_rig.hpp"

#include <algorithm>
#include <type_traits>

namespace skein::ground_station::testing {

using executive::TaskId;
using executive::TaskState;

namespace {

constexpr double kRadio = 2;       // [s] greatest latency between ground and UAV
constexpr double kOnBoard = 0.05;  // between decision node and functional layer

}  // namespace

HandoverRig::HandoverRig(Random random, Degree degree)
    : random_(std::move(random)), degree_(degree) {
  GroundConfig config;
  config.uavs = {{"marvin", degree, {}}};
  ground_ = std::make_unique<GroundControl>(config, flat_terrain());
  make_mle();
}

void HandoverRig::make_mle() {
  executive::Config config;
  config.name = "marvin";
  mle_ = std::make_unique<executive::Executive>(config);
}

void HandoverRig::plan(const std::vector<RigTask>& tasks) {
  for (const RigTask& task : tasks) {
    tasks_[id(task.id)] = task;
    executive::Start start{a_task(task.id, "takeshot"), executive::InsertionMode::kSeq};
    for (const std::uint64_t other : task.after) {
      start.task.preconditions.push_back(in_state(other, TaskState::kEnded));
    }
    if (task.until > 0) start.task.exit = {in_state(task.until, TaskState::kEnded)};
    at_time(at(task.asked_at), [this, start] {
      tell_ground(OperatorCommand{"marvin", start, Duration::seconds(300)});
    });
  }
}

void HandoverRig::change_degree(double when, Degree degree) {
  at_time(at(when), [this, degree] {
    const mission::ChangeDegree change{degree, false, true};
    tell_ground(OperatorCommand{"marvin", change, Duration::seconds(300)});
  });
}

void HandoverRig::at_time(MissionTime when, Deed deed) {
  queue_.emplace(std::pair(std::max(when, now_), sequence_++), std::move(deed));
}

void HandoverRig::in_order(Channel& channel, double most, Deed deed) {
  channel.last = std::max(channel.last, now_ + Duration::seconds(random_.uniform(0.001, most)));
  at_time(channel.last, std::move(deed));
}

void HandoverRig::play(double until) {
  while (true) {
    std::optional<MissionTime> next = earliest(ground_->next_wakeup(), mle_->next_wakeup());
    if (!queue_.empty()) next = earliest(next, queue_.begin()->first.first);
    if (!next || *next > at(until)) return;
    now_ = std::max(now_, *next);
    if (!queue_.empty() && queue_.begin()->first.first <= now_) {
      const Deed deed = std::move(queue_.begin()->second);
      queue_.erase(queue_.begin());
      deed();
      continue;
    }
    tell_ground(Tick{});
    to_mle(executive::Tick{});
  }
}

// ---- ground ----

void HandoverRig::tell_ground(const GroundControl::Input& input) {
  for (const auto& effect : ground_->handle(input, now_)) {
    if (const auto* request = std::get_if<SendRequest>(&effect)) {
      in_order(up_, kRadio, [this, it = *request] { to_uav(it); });
    } else if (const auto* functional = std::get_if<SendFunctional>(&effect)) {
      in_order(up_, kRadio, [this, it = *functional] { to_uav(it); });
    }
  }
}

void HandoverRig::to_ground(const GroundControl::Input& input) {
  in_order(down_, kRadio, [this, input] { tell_ground(input); });
}

// A state, not an event: it may come before and after what was sent with it.
void HandoverRig::send_board() {
  PlanBoardReceived board{"marvin", degree_, true, {}, now_};
  for (const executive::TaskStatus& task : mle_->tasks()) {
    board.tasks.push_back({task.id, task.type, task.state});
  }
  at_time(now_ + Duration::seconds(random_.uniform(0.001, kRadio)),
          [this, board] { tell_ground(board); });
}

// ---- the decision node ----

void HandoverRig::to_uav(const SendRequest& request) {
  if (const auto* it = std::get_if<mission::ChangeDegree>(&request.request)) {
    return change(request, *it);
  }
  if (degree_ == 1) {
    return to_ground(RequestReplyReceived{request.command, false, "at degree 1"});
  }
  std::visit(
      [&](const auto& it) {
        if constexpr (std::is_constructible_v<executive::Input, decltype(it)>) {
          to_mle(it, request.command);
        }
      },
      request.request);
}

void HandoverRig::change(const SendRequest& request, const mission::ChangeDegree& change) {
  const Degree before = degree_;
  degree_ = change.degree;
  const RequestReplyReceived reply{request.command, true, ""};
  const bool reply_first = random_.chance(0.5);
  if (reply_first) to_ground(reply);
  if (before != degree_) {
    HandOverReceived handed{"marvin", {degree_, {}, {}}, now_};
    for (const executive::TaskStatus& status : mle_->tasks()) {
      if (executive::is_terminal(status.state)) continue;
      const executive::TaskView view = *mle_->find(status.id);
      mission::HeldTask held;
      held.task = {view.id,
                   view.type,
                   view.parameters,
                   mle_->preconditions(view.id),
                   mle_->exit_conditions(view.id),
                   std::nullopt};
      held.state = view.state;
      held.in_executive = true;
      handed.hand_over.tasks.push_back(held);
    }
    to_ground(handed);
  }
  if (!reply_first) to_ground(reply);
  if (degree_ == 1) to_mle(executive::Relinquish{});
  send_board();
}

void HandoverRig::to_uav(const SendFunctional& request) {
  if (degree_ == 1) {
    return to_vehicle(request.request.id, request.request.verb == functional::Verb::kInterrupt);
  }
  const executive::FunctionalStatus refusal{request.request.id, TaskState::kAborted,
                                            "not degree 1"};
  to_ground(FunctionalStatusReceived{"marvin", refusal});
}

void HandoverRig::to_mle(const executive::Input& input, CommandNumber command) {
  for (const auto& effect : mle_->handle(input, now_)) {
    if (const auto* event = std::get_if<executive::TaskEvent>(&effect)) {
      to_ground(TaskEventReceived{"marvin", event->id, event->type, event->state, event->reason});
    } else if (const auto* reply = std::get_if<executive::Reply>(&effect)) {
      to_ground(RequestReplyReceived{command, reply->accepted, reply->why});
    } else if (const auto* dispatch = std::get_if<executive::Dispatch>(&effect)) {
      to_vehicle(dispatch->id, false);
    } else if (const auto* interrupt = std::get_if<executive::Interrupt>(&effect)) {
      to_vehicle(interrupt->id, true);
    }
  }
  if (random_.chance(0.3)) send_board();
}

// ---- the functional layer: what it knows it answers and does not do again ----

void HandoverRig::to_vehicle(TaskId task, bool interrupt) {
  in_order(to_vehicle_, kOnBoard, [this, task, interrupt] {
    const auto known = statuses_.find(task);
    if (known != statuses_.end() && (!interrupt || executive::is_terminal(known->second))) {
      from_vehicle({task, known->second, ""});
    } else if (interrupt) {
      finish(task, TaskState::kAborted);
    } else {
      work(task);
    }
  });
}

void HandoverRig::work(TaskId task) {
  begun_[task] += 1;
  for (const std::uint64_t other : tasks_[task].after) {
    if (ended_[id(other)] == 0) {
      violations_.push_back("task " + skein::to_text(task) + " began before the end of " +
                            std::to_string(other));
    }
  }
  statuses_[task] = TaskState::kRunning;
  from_vehicle({task, TaskState::kRunning, ""});
  const double seconds = tasks_[task].seconds;
  if (seconds <= 0) return;
  at_time(now_ + Duration::seconds(seconds), [this, task] {
    if (!executive::is_terminal(statuses_[task])) finish(task, TaskState::kEnded);
  });
}

void HandoverRig::finish(TaskId task, TaskState state) {
  statuses_[task] = state;
  if (state == TaskState::kEnded) ended_[task] += 1;
  from_vehicle({task, state, ""});
}

void HandoverRig::from_vehicle(const executive::FunctionalStatus& status) {
  in_order(from_vehicle_, kOnBoard, [this, status] {
    if (degree_ == 1) {
      to_ground(FunctionalStatusReceived{"marvin", status});
    } else {
      to_mle(status);
    }
  });
}

// ---- the verdict ----

std::vector<std::string> HandoverRig::faults() const {
  std::vector<std::string> out = violations_;
  const Board board = ground_->board(now_);
  const UavOnBoard& uav = board.uavs[0];
  if (uav.commands_pending > 0) out.emplace_back("commands are pending");
  if (uav.degree != degree_) out.emplace_back("the board has another degree");
  for (const auto& [task, about] : tasks_) {
    const std::string name = "task " + skein::to_text(task);
    const auto begun = begun_.find(task);
    const int times = begun == begun_.end() ? 0 : begun->second;
    const auto shown = uav.tasks.find(task);
    if (!shown) {
      out.push_back(name + " is not on the board");
      continue;
    }
    const TaskState wanted = about.seconds > 0 ? TaskState::kEnded : TaskState::kAborted;
    if (shown->state != wanted) {
      out.push_back(name + " is " + std::string(executive::to_text(shown->state)) + " " +
                    shown->reason);
    }
    if (times > 1) out.push_back(name + " was begun twice");
    if (about.seconds > 0 && times == 0) out.push_back(name + " was lost");
  }
  return out;
}

}  // namespace skein::ground_station::testing
