// SPDX-License-Identifier: Apache-2.0
#include "core_inputs.hpp"

#include "routes.hpp"
#include "skein/mission/degree.hpp"

namespace skein::decision_node {

namespace {

/// At every degree they are here: a wait in place, the way home, what a role that was left still
/// ends.
bool aborts_own(const mission::Request& request) {
  const auto* abort = std::get_if<executive::Abort>(&request);
  return abort != nullptr && abort->id >= functional::kFirstRoleId;
}

}  // namespace

void Core::Inputs::operator()(const Started& started) const {
  core_.partners_.start(core_.bus_.now());
  core_.merging_.begin(started);
  core_.deliberation_.begin(started);
  core_.interaction_.start();
  core_.autonomy_.start();
  core_.team_.start();
}

void Core::Inputs::operator()(const Resumed&) const {
  core_.partners_.resume(core_.bus_.now());
  core_.interaction_.refusals().resume(core_.bus_.now());
  core_.execution_.run(executive::Tick{.after_silence = true});
}

// ---- commands ----

void Core::Inputs::operator()(const Command& command) const {
  if (!core_.commands_.is_new(command.key)) return;
  const Route& route = route_of(kind_of(command.request));
  if (core_.degree() < route.least_degree && !aborts_own(command.request))
    return core_.commands_.refuse(command, route.refusal);
  switch (route.to) {
    case Addressee::kExecution:
      return core_.execution_.take(command);
    case Addressee::kDeliberation:
      return core_.deliberation_.take(command);
    case Addressee::kAutonomy:
      return core_.autonomy_.take(command);
  }
}

void Core::Inputs::operator()(const UnreadableCommand& command) const {
  if (core_.commands_.is_new(command.key)) core_.commands_.refuse(command);
}

// ---- elementary requests at degree 1, and statuses ----

void Core::Inputs::operator()(const ElementaryRequest& asked) const {
  const functional::Request& request = asked.request;
  const bool own = is_own(request.id);
  if (!mission::runs_at_ground(core_.degree()) || own) {
    const char* why = own ? kOwnIds : "elementary requests are taken at degree 1 only";
    return core_.bus_.emit(StatusPassedOn{{request.id, functional::TaskState::kAborted, why}});
  }
  if (request.verb == functional::Verb::kInterrupt) return core_.interrupt(request.id);
  if (core_.vehicle_.ground_has(request.id, request.type)) {
    core_.tell_task({request.id, request.type, functional::TaskState::kStarted, ""});
  }
  core_.vehicle_.dispatch(request);
}

void Core::Inputs::operator()(const PlaceTold& told) const {
  for (Component* one : core_.components()) one->place_told(told.place);
}

void Core::Inputs::operator()(const world::Telemetry& telemetry) const {
  core_.bus_.emit(TelemetryPassedOn{telemetry});
  for (Component* one : core_.components()) one->vehicle_told(telemetry);
  core_.safekeeping_.look_after(telemetry);
}

void Core::Inputs::operator()(const Contact& contact) const {
  core_.partners_.contact(contact, core_.bus_.now());
  core_.voice_.contact(contact);
  core_.team_.contact(contact);
  core_.merging_.contact(contact);
  core_.meetings_.contact(contact);
  if (contact.ground) core_.safekeeping_.ground_heard(contact.reachable, core_.bus_.now());
  if (!contact.reachable) return;
  for (Component* one : core_.components()) one->peer_in_reach(contact.peer);
}

// It is asked, not supposed: one that has not forgotten after all says what it told before.
void Core::Inputs::operator()(const LayerForgot&) const {
  for (const functional::TaskId task : core_.vehicle_.under_way()) {
    const bool wanted = core_.execution_.holds(task) || core_.vehicle_.is_of_ground(task) ||
                        (mission::runs_at_ground(core_.degree()) && !is_own(task));
    core_.vehicle_.ask_again(task, wanted);
  }
}

void Core::Inputs::operator()(const Tick&) const {
  for (Component* one : core_.components()) one->time_passes();
}

}  // namespace skein::decision_node
