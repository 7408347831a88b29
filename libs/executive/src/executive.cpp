// SPDX-License-Identifier: Apache-2.0
#include "skein/executive/executive.hpp"

#include <utility>

#include "core.hpp"

namespace skein::executive {

Executive::Executive(Config config) : core_(std::make_unique<Core>(std::move(config))) {}
Executive::~Executive() = default;
Executive::Executive(Executive&&) noexcept = default;
Executive& Executive::operator=(Executive&&) noexcept = default;

Effects Executive::handle(const Input& input, MissionTime now) { return core_->handle(input, now); }

Effects Executive::give_up(TaskId synchronisation, const std::string& why, MissionTime now) {
  return core_->give_up(synchronisation, why, now);
}

std::optional<MissionTime> Executive::next_wakeup() const { return core_->next_wakeup(); }

std::vector<TaskStatus> Executive::tasks() const {
  std::vector<TaskStatus> all;
  all.reserve(core_->plan().slots().size());
  for (const auto& [id, slot] : core_->plan().slots()) {
    const TaskRecord& record = core_->plan()[slot];
    all.push_back(TaskStatus{id, record.type, record.state, record.reason});
  }
  return all;
}

std::vector<Wait> Executive::waits() const { return core_->waits(); }

std::uint64_t Executive::changes() const { return core_->plan().changes(); }

std::optional<TaskView> Executive::find(TaskId id) const {
  const std::optional<Plan::Slot> slot = core_->plan().find(id);
  if (!slot) return std::nullopt;
  const TaskRecord& record = core_->plan()[*slot];
  return TaskView{record.id,    record.type,   record.parameters, record.synchronisation.get(),
                  record.state, record.reason, record.cause,      record.idle};
}

Formula Executive::preconditions(TaskId id) const {
  const std::optional<Plan::Slot> slot = core_->plan().find(id);
  return slot ? core_->conditions().formula_of(*slot, Role::kPreconditions) : Formula();
}

Formula Executive::exit_conditions(TaskId id) const {
  const std::optional<Plan::Slot> slot = core_->plan().find(id);
  return slot ? core_->conditions().formula_of(*slot, Role::kExit) : Formula();
}

}  // namespace skein::executive
