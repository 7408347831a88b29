// SPDX-License-Identifier: Apache-2.0
#include "commitment/committer.hpp"

#include <algorithm>
#include <map>

#include "flight/flight_times.hpp"
#include "skein/supervisor/commitment.hpp"

namespace skein::supervisor {

using mission::Dependence;
using mission::DependenceKind;

Committer::Committer(const world::VehicleModel& vehicle, Duration horizon, const Agenda& agenda,
                     Dates& dates, Outbox& out, Book& book)
    : vehicle_(vehicle),
      horizon_(horizon),
      agenda_(agenda),
      dates_(dates),
      out_(out),
      book_(book),
      joint_tasks_(out, book) {}

// ---- when ----

std::optional<GoalId> Committer::next_to_give() const {
  for (const GoalId id : book_.order) {
    if (book_.goals.at(id).open() && book_.is_planned(id)) return id;
  }
  return std::nullopt;
}

// It begins some time after the end of another goal, which is to come.
bool Committer::is_undated(GoalId goal) const {
  const auto& after = book_.goals.at(goal).task.after;
  return std::any_of(after.begin(), after.end(), [&](const auto& bound) {
    const auto other = book_.goals.find(bound.goal);
    return !bound.on_end && bound.least > Duration() && other != book_.goals.end() &&
           !is_settled(other->second.state);
  });
}

// What comes behind a wait for orders comes when it may start at once, since it ends the wait;
// never before the wait is under way. So does what comes behind a safe wait, but for the instant
// that this takes to end. While a job runs, what it plans is not taken from it early. What is to
// begin some time after another goal has no date until that is over. While an operator moves the
// vehicle, where the plan begins is not known: it is made anew then. What another executive is to
// give back, a condition can name once it is here.
std::optional<MissionTime> Committer::due(GoalId goal) const {
  if (book_.is_led_away() || !book_.elsewhere.empty()) return std::nullopt;
  MissionTime first = MissionTime::max();
  for (const Entry* entry : book_.of(goal)) first = std::min(first, entry->dates.earliest_start);
  const auto waits = book_.waits_for_orders();
  for (const Entry* wait : waits) {
    if (!wait->seen.started) return std::nullopt;
  }
  if (!waits.empty()) return first;
  if (is_undated(goal)) return std::nullopt;
  if (book_.waits_safely()) return first - safe_wait_ends_within();
  return agenda_.plans() ? first : first - horizon_;
}

void Committer::commit() {
  if (!agenda_.repairing()) joint_tasks_.renew();
  while (!agenda_.repairing()) {
    const auto goal = next_to_give();
    if (!goal) return;
    const auto at = due(*goal);
    if (!at || *at > now()) return;
    give(*goal);
  }
}

// ---- what ----

// Tasks beside the plan that have what this one is the first of its goal to need.
std::set<TaskId> Committer::loose_before(const mission::ElementaryTask& task) const {
  const auto is_first = [&](auto&& uses) {
    return std::none_of(task.dependences.begin(), task.dependences.end(),
                        [&](const Dependence& one) {
                          const Entry* other = book_.find(one.task);
                          return other != nullptr && other->live() &&
                                 other->task.origin == task.origin && uses(other->task);
                        });
  };
  std::set<TaskId> result;
  if (holds_vehicle(task) && is_first(mission::holds_vehicle)) result = book_.loose_motion(task.id);
  for (const std::string& device : devices_of(task)) {
    const auto uses = [&](const mission::ElementaryTask& other) {
      const auto devices = devices_of(other);
      return std::find(devices.begin(), devices.end(), device) != devices.end();
    };
    if (is_first(uses)) result.merge(book_.loose_users_of(device));
  }
  return result;
}

mission::ElementaryTask Committer::as_given(const mission::ElementaryTask& task) const {
  mission::ElementaryTask result = task;
  auto& on = result.dependences;
  const auto unknown = [this](const Dependence& one) {
    const Entry* other = book_.find(one.task);
    const bool here = other != nullptr && other->given() && !other->over_elsewhere;
    const auto loose = book_.loose.find(one.task);
    const bool beside = loose != book_.loose.end() && !loose->second.gives_way;
    return !here && !beside && !book_.forgotten.knows(one.task.value());
  };
  on.erase(std::remove_if(on.begin(), on.end(), unknown), on.end());
  for (const TaskId id : loose_before(result)) {
    const bool named =
        std::any_of(on.begin(), on.end(), [&](const auto& d) { return d.task == id; });
    if (id != task.id && !named) on.push_back({DependenceKind::kOver, id});
  }
  return result;
}

void Committer::give(GoalId goal) {
  std::vector<TaskId> ids;
  std::vector<mission::ElementaryTask> tasks;
  std::map<TaskId, mission::TaskDates> windows;
  std::vector<TaskId> waits;
  for (const Entry* wait : book_.waits_for_orders()) waits.push_back(wait->task.id);
  for (const Entry* one : book_.of(goal)) {
    Entry& entry = book_.tasks.at(one->task.id);
    tasks.push_back(as_given(entry.task));
    entry.advance(Step::kGive);
    ids.push_back(entry.task.id);
    entry.told_window = entry.window;
    windows[entry.task.id] = entry.window;
  }
  Holds holds;
  for (const TaskId id : ids) {
    Entry& entry = book_.tasks.at(id);
    entry.holds = dates_.holds_of(id);
    entry.was_held = !entry.holds.empty();
    if (entry.was_held) holds[id] = entry.holds;
  }
  for (executive::Input& request : to_requests(tasks, windows, book_.ending_by_order(), holds)) {
    out_.send(std::move(request));
  }
  ever_gave_ = true;
  end_waits(waits);
  out_.decide({"5 execute", "commitment horizon", "goals " + to_text(goal),
               list_of("given: tasks", ids), now()});
}

// Orders have come: waits for them, and safe waits, end.
void Committer::end_waits(const std::vector<TaskId>& waits) {
  for (auto it = waits.rbegin(); it != waits.rend(); ++it) {
    book_.tasks.at(*it).advance(Step::kOrder);
    abort(*it);
  }
  stop_safe_waits();
}

Duration Committer::safe_wait_ends_within() const {
  return kStopReaction + Duration::seconds(longest_reaction(vehicle_));
}

// When it is to end, so that the first of the tasks that the executive has may begin in time.
std::optional<MissionTime> Committer::end_of_safe_wait() const {
  std::optional<MissionTime> first;
  if (!book_.waits_safely()) return first;
  for (const auto& [id, entry] : book_.tasks) {
    if (!entry.in_hand() || entry.seen.started || entry.by_others || entry.stopping()) continue;
    first = earliest(first, entry.dates.earliest_start - safe_wait_ends_within());
  }
  return first;
}

// ---- what it has ----

void Committer::reschedule() {
  dates_.update(now());
  for (const TaskId id : dates_.renew_holds(now())) send_preconditions(book_.tasks.at(id));
  tell_what_is_back();
}

// Conditions name other tasks: they are told once all of these are back.
void Committer::tell_what_is_back() {
  for (auto& [id, entry] : book_.tasks) {
    const bool is_here = entry.told_when_back && !book_.elsewhere.contains(id);
    if (!is_here || (!entry.stopping() && !entry.over() && !book_.elsewhere.empty())) continue;
    entry.told_when_back = false;
    if (entry.over()) continue;
    if (entry.stopping())
      out_.send(executive::Abort{id});
    else if (!entry.seen.started)
      send_preconditions(entry);
  }
}

// The executive here knows nothing of what another one has.
bool Committer::is_told_later(Entry& entry) const {
  const bool is_away = book_.elsewhere.contains(entry.task.id);
  entry.told_when_back = entry.told_when_back || is_away;
  return is_away;
}

void Committer::abort(TaskId id) {
  if (!is_told_later(book_.tasks.at(id))) out_.send(executive::Abort{id});
}

void Committer::send_preconditions(Entry& entry) {
  if (is_told_later(entry)) return;
  entry.told_window = entry.window;
  executive::Start start =
      to_start(as_given(entry.task), entry.window, book_.ending_by_order(), entry.holds);
  out_.send(executive::UpdateConditions{entry.task.id, std::move(start.task.preconditions),
                                        std::nullopt});
}

void Committer::stop(const std::vector<TaskId>& tasks) {
  for (const TaskId id : tasks) {
    book_.tasks.at(id).advance(Step::kStop);
    abort(id);
  }
}

void Committer::retire(const std::set<GoalId>& goals) { stop(book_.withdraw(goals)); }

TaskId Committer::start_loose(const std::string& type) {
  const TaskId id = book_.add_loose(type);
  executive::Task task;
  task.id = id;
  task.type = type;
  out_.send(executive::Start{std::move(task), executive::InsertionMode::kVut});
  return id;
}

void Committer::renew_motions() {
  for (auto& [task, entry] : book_.tasks) {
    const bool held = entry.in_hand() && !entry.seen.started && !entry.by_others;
    if (held && holds_vehicle(entry.task)) send_preconditions(entry);
  }
}

// What the executive has begins when the safe wait is over.
TaskId Committer::start_safe_wait() {
  const TaskId id = start_loose("wait");
  renew_motions();
  return id;
}

void Committer::stop_safe_waits() {
  for (auto it = book_.loose.rbegin(); it != book_.loose.rend(); ++it) {
    if (!it->second.ours || it->second.stopping) continue;
    it->second.stopping = true;
    out_.send(executive::Abort{it->first});
  }
}

}  // namespace skein::supervisor
