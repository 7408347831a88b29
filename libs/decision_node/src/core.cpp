// SPDX-License-Identifier: Apache-2.0
#include "core.hpp"

#include "core_inputs.hpp"
#include "skein/mission/degree.hpp"

namespace skein::decision_node {

Core::Core(Config config)
    : config_(std::move(config)),
      commands_(bus_),
      partners_(config_.partner_lease),
      own_tasks_(bus_, execution_),
      vehicle_(bus_, own_tasks_, merging_),
      merging_(*this),
      execution_(*this),
      deliberation_(*this),
      joint_host_(*this),
      interaction_(joint_host_),
      voice_(*this),
      team_(*this),
      meetings_(*this),
      autonomy_(*this),
      safekeeping_(*this) {}

Effects Core::handle(const Input& input, MissionTime now) {
  bus_.begin(now);
  std::visit(Inputs(*this), input);
  team_.settle();
  safekeeping_.time_passes();
  vehicle_.release();
  tell_board_if_changed();
  return bus_.end();
}

std::optional<MissionTime> Core::next_wakeup() const {
  std::optional<MissionTime> next = safekeeping_.next_wakeup();
  for (const Component* one : components()) next = earliest(next, one->next_wakeup());
  return next;
}

void Core::interrupt(functional::TaskId task) {
  if (const auto status = vehicle_.interrupt(task)) told(*status);
}

void Core::post_status(functional::Status status) {
  bus_.post([this, status = std::move(status)] { told(status); });
}

void Core::told(const functional::Status& status) {
  const functional::TaskId id = status.id;
  vehicle_.told(status);
  if (merging_.told(status)) return;
  const bool ground_runs_it =
      vehicle_.is_of_ground(id) || (mission::runs_at_ground(degree()) && !is_own(id));
  if (!execution_.holds(id) && ground_runs_it) return pass_on(status);
  execution_.run(status);
}

// The supervisor goes on hearing of tasks that were its own. From degree 2 on the executive that
// had the task at degree 1 may have let go of it, and nobody else says how it ended.
void Core::pass_on(const functional::Status& status) {
  const executive::TaskEvent event{status.id, vehicle_.pass_on(status), status.state, status.reason,
                                   status.cause};
  const bool is_known = !event.type.empty();
  if (is_known && is_terminal(status.state) && !mission::runs_at_ground(degree()))
    bus_.emit(TaskChanged{event, {}});
  if (is_known && status.state != functional::TaskState::kStarted) tell_task(event);
  safekeeping_.start_pending();
}

void Core::tell_task(const executive::TaskEvent& event) {
  for (Component* one : components()) one->task_changed(event);
}

void Core::declare_lost(const std::string& uav) {
  if (!config_.others.contains(uav)) return;
  partners_.declare_lost(uav);
  bus_.emit(Notice{"'" + uav + "' is declared lost: nobody here waits for it any more"});
  bus_.post([this] {
    execution_.give_up_on_partners();
    interaction_.time_passes();
  });
}

void Core::declare_found(const std::string& uav) {
  if (!partners_.is_declared_lost(uav)) return;
  partners_.declare_found(uav);
  bus_.emit(Notice{"'" + uav + "' is found again: it is waited for as others are"});
}

void Core::tell_board_if_changed() {
  const BoardMark mark{degree(), execution_.airborne(), execution_.changes()};
  if (board_mark_ == mark) return;  // as after most inputs: a board is some hundred tasks
  board_mark_ = mark;
  BoardChanged board{mark.degree, mark.airborne, execution_.tasks()};
  if (last_board_ == board) return;
  last_board_ = board;
  bus_.emit(std::move(board));
}

}  // namespace skein::decision_node
