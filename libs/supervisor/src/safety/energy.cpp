// SPDX-License-Identifier: Apache-2.0
// What the UAV really holds, against what its plan and the way home still take.
#include <algorithm>
#include <cmath>

#include "core.hpp"

namespace skein::supervisor {

namespace {

constexpr double kRoom = 0.005;       // after which a shortage may be told again
constexpr double kTouchDown = 0.004;  // above the reserve, beside the descent: it is time

}  // namespace

Whereabouts Supervisor::Core::end_of(const std::vector<mission::ElementaryTask>& tasks) const {
  return after({vehicle_.position, vehicle_.airborne}, tasks);
}

double Supervisor::Core::energy_above_reserve() const {
  return vehicle_.energy - config_.knowledge->vehicle.energy.reserve;
}

// Of a flight that takes longer than it should, at least what is left of its way.
double Supervisor::Core::energy_to_come(const Entry& entry) const {
  return energy_to_come(entry, retreat());
}

double Supervisor::Core::energy_to_come(const Entry& entry, const Retreat& retreat) const {
  const double expected = entry.task.energy * energy_share(entry, now_);
  const bool flies = entry.task.type == "goto" && !entry.task.way.empty();
  if (!flies || !entry.under_way()) return expected;
  return std::max(expected, retreat.flight({vehicle_.position, entry.task.way.back()}));
}

double Supervisor::Core::energy_in_hand() const {
  double taken = 0;
  for (const auto& [id, entry] : book_.tasks) {
    if (entry.in_hand()) taken += energy_to_come(entry);
  }
  return taken + retreat().after(end_of(book_.standing().tasks));
}

// Of all that is planned, and of the way home after it.
double Supervisor::Core::energy_wanted(const Retreat& retreat) const {
  double wanted = 0;
  for (const auto& [id, entry] : book_.tasks) {
    if (book_.counts(entry)) wanted += energy_to_come(entry, retreat);
  }
  return wanted + retreat.after(end_of(book_.open_tasks()));
}

// Told once; again only after what remains fitted with some room. It is asked with every state of
// the vehicle: flights are flown in thought only where a rough sum does not fit already.
void Supervisor::Core::check_energy() {
  if (repairing()) return;
  come_down_at_once();
  const double left = energy_above_reserve() - kSpareEnergy / 2;
  if (energy_wanted(retreat().at_most()) <= left - kRoom) {
    energy_told_ = false;
    return;
  }
  const double wanted = energy_wanted(retreat());
  if (wanted <= left - kRoom) energy_told_ = false;
  if (wanted <= std::max(left, 0.0) || energy_told_) return;
  energy_told_ = true;
  run_short(wanted);
}

// What is only planned is planned anew as long as what is under way and the way home fit; else that
// is given up too.
void Supervisor::Core::run_short(double wanted) {
  const std::string cause =
      "energy short: what is planned and the way home take " + percent(wanted) + ", " +
      percent(std::max(0.0, energy_above_reserve())) + " are left above the reserve";
  const std::vector<GoalId> free = book_.free_goals();
  const double left = energy_above_reserve() - kSpareEnergy / 2;
  if (!free.empty() && energy_in_hand() <= left) return need(std::nullopt, false, cause);
  std::set<GoalId> in_hand, landings;
  for (const TaskId id : book_.in_hand()) {
    const mission::ElementaryTask& task = book_.tasks.at(id).task;
    in_hand.insert(task.origin);
    if (task.type == "land") landings.insert(task.origin);
  }
  if (in_hand != landings) return give_up(in_hand, cause);
  if (!landings.empty()) return divert(cause);
  need(std::nullopt, false, cause);
  need_->home = vehicle_.airborne;
}

// A wait without end is over; what else was in hand is planned anew, as far as there is energy.
void Supervisor::Core::give_up(const std::set<GoalId>& in_hand, const std::string& cause) {
  const auto waiting = waiting_in(in_hand);
  retire(book_.falling_with(in_hand));
  need(waiting, false, waiting ? cause + "; " + named(*waiting) + " waits no longer" : cause);
  need_->home = vehicle_.airborne;
}

// It was to come home, and the energy does not last so far.
void Supervisor::Core::divert(const std::string& cause) {
  const auto descends = [](const auto& one) {
    return one.second.under_way() && one.second.task.type == "land";
  };
  const bool down = std::any_of(book_.tasks.begin(), book_.tasks.end(), descends);
  const bool lasts = retreat().home(vehicle_.position) <= energy_above_reserve();
  if (down || lasts || !vehicle_.airborne) return notice(cause + "; it is on its way down");
  std::set<GoalId> landings;
  for (const TaskId id : book_.in_hand()) landings.insert(book_.tasks.at(id).task.origin);
  retire(book_.falling_with(landings));
  need(std::nullopt, false, cause + "; it lands nearer");
  need_->home = true;
}

// The goal whose task, under way, ends when others say so.
std::optional<GoalId> Supervisor::Core::waiting_in(const std::set<GoalId>& goals) const {
  for (const auto& [id, entry] : book_.tasks) {
    if (!entry.under_way() || goals.count(entry.task.origin) == 0) continue;
    const bool waits = ends_by_order(entry.task) || entry.task.synchronisation ||
                       entry.task.duration.most == Duration::max();
    if (waits && stand_of(entry)) return entry.task.origin;
  }
  return std::nullopt;
}

// A landing that has begun, with the way to it.
bool Supervisor::Core::comes_down() const {
  std::set<GoalId> begun;
  for (const auto& [id, entry] : book_.tasks) {
    if (entry.under_way()) begun.insert(entry.task.origin);
  }
  const bool planned = std::any_of(book_.tasks.begin(), book_.tasks.end(), [&](const auto& one) {
    const Entry& entry = one.second;
    return entry.in_hand() && entry.task.type == "land" && begun.count(entry.task.origin) != 0;
  });
  return planned || std::any_of(book_.loose.begin(), book_.loose.end(), [](const auto& one) {
           return one.second.type == "land" && !one.second.stopping;
         });
}

// The last of all: no plan has brought it down, and the reserve is near.
void Supervisor::Core::come_down_at_once() {
  if (!vehicle_.airborne || !ever_gave_ || comes_down()) return;
  const double needed = retreat().descent(vehicle_.position);
  if (needed <= 0 || energy_above_reserve() > needed + kTouchDown) return;
  if (wait_again_ && now_ < *wait_again_) return;
  const std::string why = "the energy lasts no longer than to come down here";
  std::vector<GoalId> open;
  for (const GoalId id : book_.order) {
    const GoalState state = book_.goals.at(id).state;
    if (!is_settled(state) && state != GoalState::kHandedOver) open.push_back(id);
  }
  retire({open.begin(), open.end()});
  for (const GoalId id : open) set_state(book_.goals.at(id), GoalState::kFailed, why);
  const TaskId id = book_.next_id;
  book_.next_id = TaskId(id.value() + 1);
  executive::Task task;
  task.id = id;
  task.type = "land";
  book_.loose[id] = {"land", true, true, false, false};
  send(executive::Start{std::move(task), executive::InsertionMode::kVut});
  notice(why + ": lands at once, task " + to_text(id));
}

}  // namespace skein::supervisor
