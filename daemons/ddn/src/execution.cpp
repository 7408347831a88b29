// SPDX-License-Identifier: Apache-2.0
// What the executive asks of the functional layer, of other UAVs and of the supervisor.
#include <algorithm>

#include "skein/ddn/ddn_node.hpp"
#include "skein/functional/task_types.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ddn {

namespace {

using translation::to_wire;

bool holds_vehicle(const std::string& type) {
  return functional::TaskTypes::shipped().of(type).holds_vehicle();
}

}  // namespace

void DdnNode::carry_out(const executive::TaskEvent& event) {
  log(translation::task_line(writer(), config_.uav, event));
  send_to_ground(to_wire(config_.uav, event, now_));
  if (own_task(event.id.value()) && event.id < executive::kFirstBackgroundId) {
    if (is_terminal(event.state)) {
      own_open_.erase(event.id.value());
    } else {
      own_open_.insert(event.id.value());
    }
  }
  tell(supervisor::TaskSeen{event});
}

void DdnNode::carry_out(const executive::Dispatch& dispatch) {
  const auto task = executive_.find(dispatch.id);
  if (!task) return;  // over within the same call
  if (dispatch.joint && supervisor_) return tell(supervisor::JointTaskDue{dispatch.id, false});
  if (dispatch.joint) {
    return run(executive::FunctionalStatus{dispatch.id, executive::TaskState::kAborted,
                                           "joint tasks need a deliberative layer"});
  }
  wire::FunctionalRequest request;
  request.uav = config_.uav;
  request.kind = wire::FunctionalRequestKind::kDispatch;
  request.id = dispatch.id.value();
  request.type = task->type;
  request.parameters = to_wire(task->parameters);
  dispatch_functional(std::move(request));
}

void DdnNode::carry_out(const executive::Interrupt& interrupt) {
  if (interrupt.joint && supervisor_) return tell(supervisor::JointTaskDue{interrupt.id, true});
  interrupt_functional(interrupt.id.value());
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
  log(translation::sync_line(writer(), {sync.id, config_.uav, sync.to, true}));
  const node::NodeNumber next = degree_ >= 3 ? to->number : roster_.ground();
  out_.push_back(node::Send{next, message, MissionTime::max()});
}

void DdnNode::carry_out(const executive::Reply& reply) {
  const auto* start = std::get_if<executive::Start>(&asked_executive_->input);
  if (const auto& command = asked_executive_->command) answer(*command, reply.accepted, reply.why);
  log(translation::request_line(writer(), config_.uav, reply,
                                start == nullptr ? executive::InsertionMode::kSeq : start->mode));
  if (start != nullptr && reply.accepted) passed_through_.erase(start->task.id.value());
  if (asked_executive_->by_supervisor) tell(supervisor::RequestAnswered{reply});
}

void DdnNode::carry_out(const executive::Notice& notice) {
  log(record("notice").with("uav", config_.uav).with("text", notice.text));
}

// ---- the functional layer ----

// Own tasks give way; the functional layer moves for one task at a time.
void DdnNode::dispatch_functional(wire::FunctionalRequest request) {
  if (own_task(request.id) || own_open_.empty() || !holds_vehicle(request.type)) {
    out_.push_back(node::Send{roster_.sim(), std::move(request), MissionTime::max()});
    return;
  }
  waiting_.push_back(std::move(request));
  const std::set<std::uint64_t> open = own_open_;
  for (auto id = open.rbegin(); id != open.rend(); ++id) {
    run(executive::Abort{executive::TaskId(*id)});
  }
}

void DdnNode::interrupt_functional(std::uint64_t task) {
  const auto waits = std::find_if(waiting_.begin(), waiting_.end(),
                                  [&](const auto& request) { return request.id == task; });
  if (waits != waiting_.end()) {
    waiting_.erase(waits);
    wire::FunctionalStatus status;
    status.uav = config_.uav;
    status.id = task;
    status.state = wire::TaskState::kAborted;
    status.reason = "interrupted before it began";
    return take(status);
  }
  wire::FunctionalRequest request;
  request.uav = config_.uav;
  request.kind = wire::FunctionalRequestKind::kInterrupt;
  request.id = task;
  out_.push_back(node::Send{roster_.sim(), request, MissionTime::max()});
}

void DdnNode::release_waiting() {
  if (!own_open_.empty()) return;
  for (wire::FunctionalRequest& request : waiting_) {
    out_.push_back(node::Send{roster_.sim(), std::move(request), MissionTime::max()});
  }
  waiting_.clear();
}

bool DdnNode::executive_holds(std::uint64_t id) const {
  const auto task = executive_.find(executive::TaskId(id));
  return task && !is_terminal(task->state);
}

}  // namespace skein::ddn
