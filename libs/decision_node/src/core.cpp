// SPDX-License-Identifier: Apache-2.0
#include "core.hpp"

#include <algorithm>

#include "routes.hpp"
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
  std::visit([this](const auto& one) { on(one); }, input);
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

void Core::on(const Started& started) {
  partners_.start(bus_.now());
  merging_.begin(started);
  deliberation_.begin(started);
  interaction_.start();
  autonomy_.start();
  team_.start();
}

// ---- commands ----

void Core::on(const Command& command) {
  if (!commands_.is_new(command.key)) return;
  const Route& route = route_of(kind_of(command.request));
  if (degree() < route.least_degree) return commands_.refuse(command, route.refusal);
  switch (route.to) {
    case Addressee::kExecution:
      return execution_.take(command);
    case Addressee::kDeliberation:
      return deliberation_.take(command);
    case Addressee::kAutonomy:
      return autonomy_.take(command);
  }
}

void Core::on(const UnreadableCommand& command) {
  if (commands_.is_new(command.key)) commands_.refuse(command);
}

// ---- elementary requests at degree 1, and statuses ----

void Core::on(const ElementaryRequest& asked) {
  const functional::Request& request = asked.request;
  const bool own = is_own(request.id);
  if (!mission::runs_at_ground(degree()) || own) {
    const char* why = own ? kOwnIds : "elementary requests are taken at degree 1 only";
    return bus_.emit(StatusPassedOn{{request.id, functional::TaskState::kAborted, why}});
  }
  if (request.verb == functional::Verb::kInterrupt) return interrupt(request.id);
  if (vehicle_.ground_has(request.id, request.type)) {
    tell_task({request.id, request.type, functional::TaskState::kStarted, ""});
  }
  vehicle_.dispatch(request);
}

void Core::interrupt(functional::TaskId task) {
  if (const auto status = vehicle_.interrupt(task)) on(StatusTold{*status});
}

void Core::post_status(functional::Status status) {
  bus_.post([this, status = std::move(status)] { on(StatusTold{status}); });
}

void Core::on(const StatusTold& told) {
  const functional::TaskId id = told.status.id;
  vehicle_.told(told.status);
  if (merging_.told(told.status)) return;
  const bool ground_runs_it =
      vehicle_.is_of_ground(id) || (mission::runs_at_ground(degree()) && !is_own(id));
  if (!execution_.holds(id) && ground_runs_it) return pass_on(told.status);
  execution_.run(told.status);
}

// The supervisor goes on hearing of tasks that were its own.
void Core::pass_on(const functional::Status& status) {
  const std::string type = vehicle_.pass_on(status);
  const bool waits = status.state == functional::TaskState::kStarted;
  if (!type.empty() && !waits)
    tell_task({status.id, type, status.state, status.reason, status.cause});
  safekeeping_.start_pending();
}

// ---- what all components hear ----

void Core::tell_task(const executive::TaskEvent& event) {
  for (Component* one : components()) one->task_changed(event);
}

void Core::on(const PlaceTold& told) {
  for (Component* one : components()) one->place_told(told.place);
}

void Core::on(const world::Telemetry& telemetry) {
  bus_.emit(TelemetryPassedOn{telemetry});
  for (Component* one : components()) one->vehicle_told(telemetry);
  safekeeping_.look_after(telemetry);
}

void Core::on(const Contact& contact) {
  partners_.contact(contact, bus_.now());
  voice_.contact(contact);
  team_.contact(contact);
  merging_.contact(contact);
  meetings_.contact(contact);
  if (contact.ground) safekeeping_.ground_heard(contact.reachable, bus_.now());
  if (!contact.reachable) return;
  for (Component* one : components()) one->peer_in_reach(contact.peer);
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

// It is asked, not supposed: one that has not forgotten after all says what it told before.
void Core::on(const LayerForgot&) {
  for (const functional::TaskId task : vehicle_.under_way()) {
    const bool wanted = execution_.holds(task) || vehicle_.is_of_ground(task) ||
                        (mission::runs_at_ground(degree()) && !is_own(task));
    vehicle_.ask_again(task, wanted);
  }
}

void Core::on(const Tick&) {
  for (Component* one : components()) one->time_passes();
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
