// SPDX-License-Identifier: Apache-2.0
#include "interaction/on_board.hpp"

#include "core.hpp"
#include "interaction/planned_state.hpp"

namespace skein::decision_node {

Bus& OnBoard::bus() { return core_.bus(); }
const Config& OnBoard::config() const { return core_.config(); }
Partners& OnBoard::partners() { return core_.partners(); }

std::shared_ptr<const world::World> OnBoard::world() const {
  return core_.deliberation().possible() ? core_.deliberation().world() : nullptr;
}

void OnBoard::run(executive::Input input) { core_.execution().run(std::move(input)); }
bool OnBoard::stops(executive::TaskId joint) const { return core_.execution().stops(joint); }
std::vector<mission::HeldTask> OnBoard::held() const { return core_.execution().held(); }

void OnBoard::serves(executive::TaskId role_task, executive::TaskId joint) {
  core_.deliberation().serves(role_task, joint);
}

void OnBoard::answered(const supervisor::JointTaskAnswered& answer) {
  core_.deliberation().joint_task_answered(answer);
}

world::VehicleState OnBoard::when_it_begins(executive::TaskId joint,
                                            const world::VehicleState& seen) const {
  if (!core_.deliberation().engaged()) return seen;
  return planned_state(seen, core_.deliberation().report(), joint,
                       core_.config().knowledge->vehicle, core_.bus().now());
}

std::vector<executive::TaskId> OnBoard::joint_tasks_before(executive::TaskId joint) const {
  if (!core_.deliberation().engaged()) return {};
  return decision_node::joint_tasks_before(core_.deliberation().report(), joint);
}

std::function<bool(const world::Vector3&)> OnBoard::free_to_stay() const {
  return core_.merging().free_to_stay();
}

}  // namespace skein::decision_node
