// SPDX-License-Identifier: Apache-2.0
#include "skein/ddn/ddn_node.hpp"

#include <algorithm>

#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ddn {

namespace {

using translation::from_wire;
using translation::to_wire;

constexpr const char* kOwnIds = "ids from 1000000000 are the decision node's own";

executive::Config executive_config(const DdnConfig& config) {
  executive::Config result;
  result.name = config.uav;
  result.functional_timeout = config.functional_timeout;
  result.background_type = config.background_type;
  return result;
}

const char* name_of(ContactPolicy policy) {
  switch (policy) {
    case ContactPolicy::kHold:
      return "hold";
    case ContactPolicy::kReturn:
      return "return";
    case ContactPolicy::kContinue:
      break;
  }
  return "continue";
}

}  // namespace

DdnNode::DdnNode(DdnConfig config, node::Roster roster)
    : config_(std::move(config)),
      roster_(std::move(roster)),
      executive_(executive_config(config_)),
      contact_(config_.contact_policy, config_.contact_after) {}

node::Effects DdnNode::handle(const node::Input& input, MissionTime now) {
  now_ = now;
  out_.clear();
  std::visit([this](const auto& one) { on(one); }, input);
  if (const auto policy = contact_.due(now_); policy) carry_out_contact_policy();
  send_board_if_changed();
  return std::move(out_);
}

std::optional<MissionTime> DdnNode::next_wakeup() const {
  return earliest(executive_.next_wakeup(), contact_.next_wakeup());
}

void DdnNode::on(const node::Started&) {
  wire::AutonomyDegree degree;
  degree.uav = config_.uav;
  degree.degree = static_cast<std::uint8_t>(config_.degree);
  degree.contact_policy = name_of(config_.contact_policy);
  send_to_ground(degree);
  log(record("degree").with("uav", config_.uav).with("degree", config_.degree));
}

void DdnNode::on(const node::Received& received) {
  if (const std::string why = why_not(received); !why.empty()) {
    const wire::Slot slot = wire::slot_of(received.sample);
    if (!dropped_.emplace(received.from, slot).second) return;
    log(record("dropped")
            .with("slot", wire::slot_name(slot))
            .with("origin", roster_.name_of(received.from))
            .with("field", "header.origin")
            .with("why", why));
    return;
  }
  std::visit([this](const auto& sample) { take(sample); }, received.sample);
}

void DdnNode::on(const node::Reachability& reach) {
  if (reach.peer == roster_.ground()) contact_.ground_heard(reach.reachable, now_);
  if (reach.reachable) run(executive::PeerReachable{roster_.name_of(reach.peer)});
}

void DdnNode::on(const node::Wakeup&) { run(executive::Tick{}); }

// ---- what comes in ----

// Every node of the radio can write to this one; who commands it and who moves it is fixed.
std::string DdnNode::why_not(const node::Received& received) const {
  switch (wire::slot_of(received.sample)) {
    case wire::Slot::kTaskRequest:
    case wire::Slot::kFunctionalRequest:
      return received.from == roster_.ground() ? "" : "only the ground station makes requests";
    case wire::Slot::kFunctionalStatus:
    case wire::Slot::kTelemetry:
    case wire::Slot::kPerceptionReport:
      return received.from == roster_.sim() ? "" : "only the functional layer tells of the vehicle";
    default:
      return "";
  }
}

void DdnNode::take(const wire::TaskRequest& request) {
  const auto known = answered_.find({request.header.incarnation, request.command});
  if (known != answered_.end()) return send_to_ground(known->second);
  if (config_.degree == 1) return refuse(request, "at degree 1 the ground station runs the plan");
  if (request.kind == wire::RequestKind::kStart && own_task(request.task.id)) {
    return refuse(request, kOwnIds);
  }
  mode_of_request_ = static_cast<executive::InsertionMode>(request.mode);
  const executive::Effects effects =
      executive_.handle(translation::to_input(from_wire(request)), now_);
  for (const executive::Effect& effect : effects) {
    if (const auto* answered = std::get_if<executive::Reply>(&effect)) {
      wire::RequestReply reply;
      reply.id = answered->id.value_or(executive::TaskId()).value();
      reply.accepted = answered->accepted;
      reply.why = answered->why;
      answer(request, std::move(reply));
    }
  }
  carry_out(effects);
}

void DdnNode::refuse(const wire::TaskRequest& request, const char* why) {
  wire::RequestReply reply;
  reply.id = request.kind == wire::RequestKind::kStart ? request.task.id : request.id;
  reply.why = why;
  answer(request, std::move(reply));
}

void DdnNode::take(const wire::FunctionalRequest& request) {
  const bool own = own_task(request.id);
  if (config_.degree == 1 && !own) {
    const bool dispatch = request.kind == wire::FunctionalRequestKind::kDispatch;
    if (dispatch) passed_through_.insert(request.id);
    out_.push_back(node::Send{roster_.sim(), request, MissionTime::max()});
    return;
  }
  wire::FunctionalStatus refusal;
  refusal.uav = config_.uav;
  refusal.id = request.id;
  refusal.state = wire::TaskState::kAborted;
  refusal.reason = own ? kOwnIds : "elementary requests are taken at degree 1 only";
  send_to_ground(refusal);
}

void DdnNode::take(const wire::FunctionalStatus& status) {
  if (config_.degree == 1 && !own_task(status.id)) {
    if (status.state != wire::TaskState::kRunning) passed_through_.erase(status.id);
    send_to_ground(status);
    start_safe_tasks();
    return;
  }
  run(executive::FunctionalStatus{executive::TaskId(status.id), from_wire(status.state),
                                  status.reason});
}

void DdnNode::take(const wire::SyncMessage& message) {
  if (config_.degree == 1) {
    send_to_ground(message);
    return;
  }
  log(record("sync")
          .with("id", message.id)
          .with("from", message.from)
          .with("to", message.to)
          .with("direction", "received"));
  run(executive::SyncReceived{message.id, message.from});
}

void DdnNode::take(const wire::Telemetry& telemetry) {
  if (telemetry.airborne != airborne_) {
    airborne_ = telemetry.airborne;
    run(executive::Flight{airborne_});
  }
  send_to_ground(telemetry);
}

void DdnNode::take(const wire::PerceptionReport& report) { send_to_ground(report); }

// ---- what the executive asks for ----

void DdnNode::run(const executive::Input& input) { carry_out(executive_.handle(input, now_)); }

void DdnNode::carry_out(const executive::Effects& effects) {
  for (const executive::Effect& effect : effects) {
    std::visit([this](const auto& one) { carry_out(one); }, effect);
  }
}

void DdnNode::carry_out(const executive::TaskEvent& event) {
  journal::Record line = record("task")
                             .with("uav", config_.uav)
                             .with("task", event.id.value())
                             .with("type", event.type)
                             .with("state", to_text(event.state));
  if (!event.reason.empty()) line.with("reason", event.reason);
  log(line);
  send_to_ground(to_wire(config_.uav, event, now_));
}

void DdnNode::carry_out(const executive::Dispatch& dispatch) {
  const auto task = executive_.find(dispatch.id);
  if (!task) return;  // over within the same call
  if (dispatch.joint) {
    run(executive::FunctionalStatus{dispatch.id, executive::TaskState::kAborted,
                                    "joint tasks need a deliberative layer"});
    return;
  }
  wire::FunctionalRequest request;
  request.uav = config_.uav;
  request.kind = wire::FunctionalRequestKind::kDispatch;
  request.id = dispatch.id.value();
  request.type = task->type;
  request.parameters = to_wire(task->parameters);
  out_.push_back(node::Send{roster_.sim(), request, MissionTime::max()});
}

void DdnNode::carry_out(const executive::Interrupt& interrupt) {
  interrupt_functional(interrupt.id.value());
}

void DdnNode::interrupt_functional(std::uint64_t task) {
  wire::FunctionalRequest request;
  request.uav = config_.uav;
  request.kind = wire::FunctionalRequestKind::kInterrupt;
  request.id = task;
  out_.push_back(node::Send{roster_.sim(), request, MissionTime::max()});
}

void DdnNode::carry_out(const executive::SendSync& sync) {
  const node::Member* to = roster_.find(sync.to);
  if (to == nullptr) {
    log(record("notice").with("text", "no UAV '" + sync.to + "' to synchronise with"));
    return;
  }
  wire::SyncMessage message;
  message.id = sync.id;
  message.from = config_.uav;
  message.to = sync.to;
  log(record("sync")
          .with("id", sync.id)
          .with("from", config_.uav)
          .with("to", sync.to)
          .with("direction", "sent"));
  const node::NodeNumber next = config_.degree >= 3 ? to->number : roster_.ground();
  out_.push_back(node::Send{next, message, MissionTime::max()});
}

void DdnNode::carry_out(const executive::Reply& reply) {
  journal::Record line = record("request").with("uav", config_.uav);
  line.with("request", to_text(reply.request));
  if (reply.request == executive::RequestKind::kStart) line.with("mode", to_text(mode_of_request_));
  if (reply.id) line.with("task", reply.id->value());
  line.with("accepted", reply.accepted);
  if (!reply.accepted) line.with("why", reply.why);
  log(line);
}

void DdnNode::carry_out(const executive::Notice& notice) {
  log(record("notice").with("uav", config_.uav).with("text", notice.text));
}

// ---- contact ----

// What is planned is given up and what flies the vehicle is interrupted, so that nothing of the
// plan moves it while the ground is silent. At degree 1 the ground's own requests are interrupted
// first.
void DdnNode::carry_out_contact_policy() {
  log(record("contact").with("uav", config_.uav).with("policy", name_of(config_.contact_policy)));
  if (!airborne_) return;
  for (const std::uint64_t task : passed_through_) interrupt_functional(task);
  const std::vector<executive::TaskStatus> tasks = executive_.tasks();
  for (auto task = tasks.rbegin(); task != tasks.rend(); ++task) {
    if (task->state == executive::TaskState::kScheduled) run(executive::Abort{task->id});
  }
  safe_tasks_pending_ = true;
  start_safe_tasks();
}

void DdnNode::start_safe_tasks() {
  if (!safe_tasks_pending_ || !passed_through_.empty()) return;
  safe_tasks_pending_ = false;
  if (config_.contact_policy == ContactPolicy::kHold) {
    start_own("wait", {}, executive::InsertionMode::kVut);
    return;
  }
  start_own("goto", {{"waypoints", "", config_.home}}, executive::InsertionMode::kVut);
  start_own("land", {}, executive::InsertionMode::kNut);
}

void DdnNode::start_own(const std::string& type, executive::Parameters parameters,
                        executive::InsertionMode mode) {
  const std::int64_t milliseconds = std::max<std::int64_t>(now_.count(), 0) / 1'000'000;
  next_own_task_ =
      std::max(next_own_task_, kFirstOwnTask + static_cast<std::uint64_t>(milliseconds));
  executive::Task task;
  task.id = executive::TaskId(next_own_task_++);
  task.type = type;
  task.parameters = std::move(parameters);
  mode_of_request_ = mode;
  run(executive::Start{std::move(task), mode});
}

// ---- what goes out ----

void DdnNode::answer(const wire::TaskRequest& request, wire::RequestReply reply) {
  reply.command = request.command;
  reply.kind = request.kind;
  answered_.emplace(std::pair(request.header.incarnation, request.command), reply);
  send_to_ground(std::move(reply));
}

void DdnNode::send_to_ground(wire::Sample sample) {
  wire::header_of(sample) = {};
  out_.push_back(node::Send{roster_.ground(), std::move(sample), MissionTime::max()});
}

void DdnNode::send_board_if_changed() {
  wire::PlanBoard board;
  board.uav = config_.uav;
  board.degree = static_cast<std::uint8_t>(config_.degree);
  board.airborne = airborne_;
  for (const executive::TaskStatus& task : executive_.tasks()) {
    board.tasks.push_back({task.id.value(), task.type, to_wire(task.state), task.reason});
  }
  if (last_board_ == board) return;
  last_board_ = board;
  send_to_ground(board);
}

void DdnNode::log(journal::Record line) { out_.push_back(node::Log{std::move(line)}); }

journal::Record DdnNode::record(const char* kind) const { return {now_, config_.uav, kind}; }

}  // namespace skein::ddn
