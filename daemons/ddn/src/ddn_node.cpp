// SPDX-License-Identifier: Apache-2.0
// Inputs to the components, errands between them, and the ways out.
#include "skein/ddn/ddn_node.hpp"

#include "skein/foundation/contract.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ddn {

namespace {

executive::Config executive_config(const DdnConfig& config) {
  executive::Config result;
  result.name = config.uav;
  result.functional_timeout = config.functional_timeout;
  result.sync_validity = config.sync_validity;
  result.background_type = config.background_type;
  return result;
}

std::optional<supervisor::Supervisor> supervisor_of(const DdnConfig& config) {
  if (config.knowledge == nullptr) return std::nullopt;
  SKEIN_EXPECTS(config.world != nullptr);
  SKEIN_EXPECTS(config.first_task.value() < DdnNode::kFirstOwnTask);
  supervisor::Config result;
  result.knowledge = config.knowledge;
  result.world = config.world;
  result.horizon = config.horizon;
  result.first_id = config.first_task;
  return supervisor::Supervisor(std::move(result));
}

}  // namespace

DdnNode::DdnNode(DdnConfig config, node::Roster roster)
    : config_(std::move(config)),
      roster_(std::move(roster)),
      degree_(config_.degree),
      executive_(executive_config(config_)),
      supervisor_(supervisor_of(config_)),
      contact_(config_.contact_policy, config_.contact_after) {
  SKEIN_EXPECTS(degree_ >= mission::kLeastDegree && degree_ <= mission::kGreatestDegree);
  SKEIN_EXPECTS(degree_ < mission::kGreatestDegree || supervisor_.has_value());
}

node::Effects DdnNode::handle(const node::Input& input, MissionTime now) {
  now_ = now;
  out_.clear();
  std::visit([this](const auto& one) { on(one); }, input);
  if (contact_.due(now_)) carry_out_contact_policy();
  release_waiting();
  send_board_if_changed();
  return std::move(out_);
}

std::optional<MissionTime> DdnNode::next_wakeup() const {
  const auto next = earliest(executive_.next_wakeup(), contact_.next_wakeup());
  return supervisor_ ? earliest(next, supervisor_->next_wakeup()) : next;
}

void DdnNode::on(const node::Started&) {
  tell_degree();
  log(record("degree").with("uav", config_.uav).with("degree", degree_));
  if (degree_ == mission::kGreatestDegree) tell(supervisor::Engage{true, "start at degree 4"});
}

void DdnNode::on(const node::Received& received) {
  if (const std::string why = why_not(received); !why.empty()) return drop(received, why);
  std::visit([this](const auto& sample) { take(sample); }, received.sample);
}

void DdnNode::on(const node::Reachability& reach) {
  if (reach.peer == roster_.ground()) contact_.ground_heard(reach.reachable, now_);
  if (reach.reachable) run(executive::PeerReachable{roster_.name_of(reach.peer)});
}

void DdnNode::on(const node::JobDone& done) {
  const auto* result = std::any_cast<supervisor::DeliberationResult>(&done.result);
  if (result != nullptr) tell(supervisor::JobFinished{done.id, *result});
}

void DdnNode::on(const node::Wakeup&) {
  run(executive::Tick{});
  tell(supervisor::Tick{});
}

// Every node of the radio can write to this one; who commands it and who moves it is fixed.
std::string DdnNode::why_not(const node::Received& received) const {
  switch (wire::slot_of(received.sample)) {
    case wire::Slot::kTaskRequest:
    case wire::Slot::kFunctionalRequest:
    case wire::Slot::kMissionRequest:
    case wire::Slot::kDegreeCommand:
    case wire::Slot::kWorldChange:
    case wire::Slot::kAlarm:
      return received.from == roster_.ground() ? "" : "only the ground station makes requests";
    case wire::Slot::kTaskEvent:
      return received.from == roster_.ground() ? "" : "only the ground station has tasks of others";
    case wire::Slot::kFunctionalStatus:
    case wire::Slot::kTelemetry:
    case wire::Slot::kPerceptionReport:
      return received.from == roster_.sim() ? "" : "only the functional layer tells of the vehicle";
    default:
      return "";
  }
}

void DdnNode::drop(const node::Received& received, const std::string& why) {
  const wire::Slot slot = wire::slot_of(received.sample);
  if (!dropped_.emplace(received.from, slot).second) return;
  log(record("dropped")
          .with("slot", wire::slot_name(slot))
          .with("origin", roster_.name_of(received.from))
          .with("field", "header.origin")
          .with("why", why));
}

// ---- errands ----

void DdnNode::run(executive::Input input) {
  run(ForExecutive{std::move(input), false, std::nullopt});
}

void DdnNode::run(ForExecutive errand) {
  errands_.emplace_back(std::move(errand));
  do_errands();
}

void DdnNode::tell(supervisor::Input input, std::optional<Command> command) {
  if (!supervisor_) return;
  errands_.emplace_back(ForSupervisor{std::move(input), command});
  do_errands();
}

// What one component asks of the other comes after all that it asked for before: an interruption
// never overtakes the dispatch of its task.
void DdnNode::do_errands() {
  if (doing_errands_) return;
  doing_errands_ = true;
  while (!errands_.empty()) {
    const auto errand = std::move(errands_.front());
    errands_.pop_front();
    std::visit([this](const auto& one) { do_errand(one); }, errand);
  }
  doing_errands_ = false;
}

void DdnNode::do_errand(const ForExecutive& errand) {
  asked_executive_ = &errand;
  for (const executive::Effect& effect : executive_.handle(errand.input, now_)) {
    std::visit([this](const auto& one) { carry_out(one); }, effect);
  }
  asked_executive_ = nullptr;
}

void DdnNode::do_errand(const ForSupervisor& errand) {
  asked_supervisor_ = &errand;
  for (const supervisor::Effect& effect : supervisor_->handle(errand.input, now_)) {
    std::visit([this](const auto& one) { carry_out(one); }, effect);
  }
  asked_supervisor_ = nullptr;
}

// ---- what goes out ----

void DdnNode::send_to_ground(wire::Sample sample) {
  wire::header_of(sample) = {};
  out_.push_back(node::Send{roster_.ground(), std::move(sample), MissionTime::max()});
}

void DdnNode::send_board_if_changed() {
  wire::PlanBoard board;
  board.uav = config_.uav;
  board.degree = static_cast<std::uint8_t>(degree_);
  board.airborne = airborne_;
  for (const executive::TaskStatus& task : executive_.tasks()) {
    board.tasks.push_back(
        {task.id.value(), task.type, translation::to_wire(task.state), task.reason});
  }
  if (last_board_ == board) return;
  last_board_ = board;
  send_to_ground(board);
}

void DdnNode::log(journal::Record line) { out_.push_back(node::Log{std::move(line)}); }

journal::Record DdnNode::record(const char* kind) const { return {now_, config_.uav, kind}; }

}  // namespace skein::ddn
