// SPDX-License-Identifier: Apache-2.0
// What comes in: commands of the ground, words of the functional layer and of other UAVs.
#include "skein/ddn/ddn_node.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ddn {

namespace {

using translation::from_wire;

constexpr const char* kOwnIds = "ids from 1000000000 are the decision node's own";
constexpr const char* kAtDegree1 = "at degree 1 the ground station runs the plan";

executive::TaskEvent event_of(const wire::FunctionalStatus& status, const std::string& type) {
  return {executive::TaskId(status.id), type, from_wire(status.state), status.reason};
}

}  // namespace

// ---- commands: answered once ----

// Nothing: it has been answered, and the answer goes out again.
template <class Sample>
std::optional<DdnNode::Command> DdnNode::new_command(const Sample& sample, wire::RequestKind kind,
                                                     std::uint64_t id) {
  const auto known = answered_.find({sample.header.incarnation, sample.command});
  if (known == answered_.end()) {
    return Command{sample.header.incarnation, sample.command, kind, id};
  }
  send_to_ground(known->second);
  return std::nullopt;
}

void DdnNode::answer(const Command& command, bool accepted, const std::string& why) {
  wire::RequestReply reply;
  reply.command = command.number;
  reply.kind = command.kind;
  reply.id = command.id;
  reply.accepted = accepted;
  reply.why = why;
  answered_.emplace(std::pair(command.incarnation, command.number), reply);
  send_to_ground(std::move(reply));
}

void DdnNode::take(const wire::TaskRequest& request) {
  const bool starts = request.kind == wire::RequestKind::kStart;
  const auto command = new_command(request, request.kind, starts ? request.task.id : request.id);
  if (!command) return;
  if (degree_ == mission::kLeastDegree) return refuse(*command, kAtDegree1);
  if (request.kind > wire::RequestKind::kSuppress) {
    return refuse(*command, "not a request to an executive");
  }
  if (starts && own_task(request.task.id)) return refuse(*command, kOwnIds);
  run(ForExecutive{translation::to_input(from_wire(request)), false, command});
}

// What was handed over can be cancelled at any degree.
void DdnNode::take(const wire::MissionRequest& request) {
  const auto kind = request.cancel ? wire::RequestKind::kCancel : wire::RequestKind::kMission;
  const auto command = new_command(request, kind, request.unit_mission);
  if (!command) return;
  const auto read = from_wire(request);
  if (!read) return refuse(*command, translation::to_text(read.error()));
  const std::string why = why_not_planned();
  if (!why.empty() && (!request.cancel || !supervisor_)) return refuse(*command, why);
  std::visit(Overloaded{[&](const mission::UnitMission& mission) {
                          tell(supervisor::AddMission{mission}, command);
                        },
                        [&](const mission::CancelGoals& goals) {
                          tell(supervisor::CancelMission{goals, request.asked_by}, command);
                        }},
             *read);
}

std::string DdnNode::why_not_planned() const {
  if (!supervisor_) return "no planning domain in the scenario: no missions are planned on board";
  if (degree_ < mission::kGreatestDegree) {
    return "degree " + std::to_string(degree_) + ": missions are planned at degree 4";
  }
  if (!engaged())
    return "deliberation stopped when contact was lost: degree 4 is to be given again";
  return "";
}

// Known for later too: the degree may go up.
void DdnNode::take(const wire::WorldChange& change) {
  const auto command = new_command(change, wire::RequestKind::kWorld, 0);
  if (!command) return;
  const auto read = from_wire(change);
  if (!read) return refuse(*command, translation::to_text(read.error()));
  if (!supervisor_) return answer(*command, true, "");
  tell(supervisor::WorldChanged{*read}, command);
}

// An alarm is a place that missions may name.
void DdnNode::take(const wire::Alarm& alarm) {
  if (!supervisor_ || alarm.id == 0) return;
  tell(supervisor::WorldChanged{translation::change_of(alarm)});
}

// ---- elementary requests at degree 1, and statuses ----

void DdnNode::take(const wire::FunctionalRequest& request) {
  const bool own = own_task(request.id);
  if (degree_ > mission::kLeastDegree || own) {
    wire::FunctionalStatus refusal;
    refusal.uav = config_.uav;
    refusal.id = request.id;
    refusal.state = wire::TaskState::kAborted;
    refusal.reason = own ? kOwnIds : "elementary requests are taken at degree 1 only";
    return send_to_ground(refusal);
  }
  if (request.kind == wire::FunctionalRequestKind::kInterrupt) {
    return interrupt_functional(request.id);
  }
  if (passed_through_.insert_or_assign(request.id, request.type).second) {
    tell(supervisor::TaskSeen{
        {executive::TaskId(request.id), request.type, executive::TaskState::kStarted, ""}});
  }
  dispatch_functional(request);
}

void DdnNode::take(const wire::FunctionalStatus& status) {
  const bool ground_runs_it = passed_through_.contains(status.id) ||
                              (degree_ == mission::kLeastDegree && !own_task(status.id));
  if (!executive_holds(status.id) && ground_runs_it) return see_passed_through(status);
  run(executive::FunctionalStatus{executive::TaskId(status.id), from_wire(status.state),
                                  status.reason});
}

// The supervisor goes on hearing of tasks that were its own.
void DdnNode::see_passed_through(const wire::FunctionalStatus& status) {
  const auto known = passed_through_.find(status.id);
  const std::string type = known == passed_through_.end() ? "" : known->second;
  if (known != passed_through_.end() && status.state != wire::TaskState::kRunning) {
    passed_through_.erase(known);
  }
  send_to_ground(status);
  if (!type.empty()) tell(supervisor::TaskSeen{event_of(status, type)});
  start_safe_tasks();
}

void DdnNode::take(const wire::SyncMessage& message) {
  wire::SyncMessage& last = syncs_[{message.id, message.from}];
  if (last.said <= message.said) last = message;
  if (degree_ == mission::kLeastDegree) return send_to_ground(message);
  const executive::SyncReceived received = from_wire(message);
  log(translation::sync_line(writer(),
                             {message.id, message.from, message.to, false, received.word}));
  run(received);
}

// At degree 1 the ground's executive has the tasks; what does not go through the functional layer
// is known there only.
void DdnNode::take(const wire::TaskEvent& event) { tell(supervisor::TaskSeen{from_wire(event)}); }

void DdnNode::take(const wire::Telemetry& telemetry) {
  if (telemetry.airborne != airborne_) {
    airborne_ = telemetry.airborne;
    run(executive::Flight{airborne_});
  }
  send_to_ground(telemetry);
  tell(supervisor::VehicleSeen{from_wire(telemetry), telemetry.failed});
  come_home_in_time(telemetry);
}

void DdnNode::take(const wire::PerceptionReport& report) { send_to_ground(report); }

// ---- the degree ----

void DdnNode::take(const wire::DegreeCommand& sample) {
  const auto command = new_command(sample, wire::RequestKind::kDegree, 0);
  if (!command) return;
  const auto read = from_wire(sample);
  if (!read) return refuse(*command, translation::to_text(read.error()));
  if (read->degree == mission::kGreatestDegree && !supervisor_) {
    return refuse(*command, "no planning domain in the scenario: degree 4 cannot be had");
  }
  answer(*command, true, "");
  change_degree(*read, sample.asked_by);
}

}  // namespace skein::ddn
