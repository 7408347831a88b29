// SPDX-License-Identifier: Apache-2.0
#include "safety/energy_watch.hpp"

#include <algorithm>

#include "safety/energy_use.hpp"
#include "watch/stand.hpp"

namespace skein::supervisor {

namespace {

constexpr double kRoom = 0.005;       // by which a shortage is another one
constexpr double kTouchDown = 0.004;  // above the reserve, beside the descent: it is time

}  // namespace

EnergyWatch::EnergyWatch(const Beliefs& beliefs, SafeMode& safe_mode, Committer& committer,
                         Agenda& agenda, Outbox& out, Book& book)
    : beliefs_(beliefs),
      safe_mode_(safe_mode),
      committer_(committer),
      agenda_(agenda),
      out_(out),
      book_(book) {}

Whereabouts EnergyWatch::end_of(const std::vector<mission::ElementaryTask>& tasks) const {
  return after({beliefs_.vehicle().position, beliefs_.vehicle().airborne}, tasks);
}

double EnergyWatch::in_hand() const {
  const Retreat home = retreat();
  double taken = 0;
  for (const auto& [id, entry] : book_.tasks) {
    if (entry.in_hand()) taken += energy_to_come(entry, beliefs_, home, now());
  }
  return taken + home.after(end_of(book_.standing().tasks));
}

// Of all that is planned, and of the way home after it.
double EnergyWatch::wanted(const Retreat& retreat) const {
  double sum = 0;
  for (const auto& [id, entry] : book_.tasks) {
    if (book_.counts(entry)) sum += energy_to_come(entry, beliefs_, retreat, now());
  }
  return sum + retreat.after(end_of(book_.open_tasks()));
}

void EnergyWatch::check() {
  const bool pauses = agenda_.needed() && !agenda_.job() && !agenda_.repair_is_due();
  if (agenda_.repairing() && !pauses) return;
  come_down_at_once();
  if (agenda_.repairing()) return;
  const double left = beliefs_.energy_above_reserve() - kSpareEnergy / 2;
  if (wanted(retreat().at_most()) <= left - kRoom) {
    told_.reset();
    return;
  }
  const double needed = wanted(retreat());
  if (needed <= left - kRoom) told_.reset();
  const double missing = needed - std::max(left, 0.0);
  if (told_) told_ = std::min(*told_, std::max(missing, 0.0));
  if (missing <= 0 || (told_ && (left <= 0 || missing <= *told_ + kRoom))) return;
  told_ = missing;
  run_short(needed);
}

// What is only planned is planned anew as long as what is under way and the way home fit; else that
// is given up too.
void EnergyWatch::run_short(double wanted) {
  const std::string cause =
      "energy short: what is planned and the way home take " + percent(wanted) + ", " +
      percent(std::max(0.0, beliefs_.energy_above_reserve())) + " are left above the reserve";
  const std::vector<GoalId> free = book_.free_goals();
  const double left = beliefs_.energy_above_reserve() - kSpareEnergy / 2;
  if (!free.empty() && in_hand() <= left) return agenda_.plan_anew(std::nullopt, false, cause);
  std::set<GoalId> held, landings;
  for (const TaskId id : book_.in_hand()) {
    const mission::ElementaryTask& task = book_.tasks.at(id).task;
    held.insert(task.origin);
    if (task.type == "land") landings.insert(task.origin);
  }
  if (held != landings) return give_up(held, cause);
  if (!landings.empty()) return divert(cause);
  bring_down(std::nullopt, cause);
}

void EnergyWatch::bring_down(std::optional<GoalId> waiting, const std::string& cause) {
  agenda_.plan_anew(waiting, false, cause);
  agenda_.bring_down(beliefs_.vehicle().airborne);
}

// A wait without end is over; what else was in hand is planned anew, as far as there is energy.
void EnergyWatch::give_up(const std::set<GoalId>& in_hand, const std::string& cause) {
  const auto waiting = waiting_in(in_hand);
  committer_.retire(book_.falling_with(in_hand));
  bring_down(waiting, waiting ? cause + "; " + book_.named(*waiting) + " waits no longer" : cause);
}

// It was to come home, and the energy does not last so far.
void EnergyWatch::divert(const std::string& cause) {
  const auto descends = [](const auto& one) {
    return one.second.under_way() && one.second.task.type == "land";
  };
  const bool down = std::any_of(book_.tasks.begin(), book_.tasks.end(), descends);
  const bool lasts = retreat().home(beliefs_.vehicle().position) <= beliefs_.energy_above_reserve();
  if (down || lasts || !beliefs_.vehicle().airborne)
    return out_.notice(cause + "; it is on its way down");
  std::set<GoalId> landings;
  for (const TaskId id : book_.in_hand()) landings.insert(book_.tasks.at(id).task.origin);
  committer_.retire(book_.falling_with(landings));
  bring_down(std::nullopt, cause + "; it lands nearer");
}

// The goal whose task, under way, ends when others say so.
std::optional<GoalId> EnergyWatch::waiting_in(const std::set<GoalId>& goals) const {
  for (const auto& [id, entry] : book_.tasks) {
    if (!entry.under_way() || goals.count(entry.task.origin) == 0) continue;
    const bool waits = ends_by_order(entry.task) || entry.task.synchronisation ||
                       entry.task.duration.most == Duration::max();
    if (waits && stand_of(entry, book_, beliefs_)) return entry.task.origin;
  }
  return std::nullopt;
}

// A landing that has begun, with the way to it.
bool EnergyWatch::comes_down() const {
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
void EnergyWatch::come_down_at_once() {
  if (!beliefs_.vehicle().airborne || comes_down()) return;
  const double needed = retreat().descent(beliefs_.vehicle().position);
  if (needed <= 0 || beliefs_.energy_above_reserve() > needed + kTouchDown) return;
  if (safe_mode_.pauses()) return;
  const std::string why = "the energy lasts no longer than to come down here";
  std::vector<GoalId> open;
  for (const GoalId id : book_.order)
    if (book_.goals.at(id).open()) open.push_back(id);
  committer_.retire({open.begin(), open.end()});
  agenda_.forget_need();
  for (const GoalId id : open) out_.set_state(book_.goals.at(id), GoalState::kFailed, why);
  const TaskId id = committer_.start_loose("land");
  out_.notice(why + ": lands at once, task " + to_text(id));
}

}  // namespace skein::supervisor
