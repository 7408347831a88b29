// SPDX-License-Identifier: Apache-2.0
#include "watch/contingencies.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "planning/terms.hpp"
#include "schedule/plan_links.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::supervisor {

namespace {

// Nearer than this it is the same place [m]: for what is planned, for what is under way.
constexpr double kSamePlace = 5, kStillInView = 15;
/// So much of the half angle of its view a head is aimed past its place before it is aimed anew.
constexpr double kOfItsView = 0.5;
constexpr double kAimedAt = 1;             // [m]
constexpr double kShows = 1, kBehind = 1;  // [m]
/// So much later others may come without dates being promised anew.
constexpr Duration kOthersVary = Duration::milliseconds(5000);

bool names(const mission::HighLevelTask& task, const std::string& place) {
  const auto is_it = [&](const std::string& name) { return same_name(name, place); };
  return std::any_of(task.arguments.begin(), task.arguments.end(), [&](const auto& argument) {
    return std::visit(Overloaded{[&](const std::string& name) { return is_it(name); },
                                 [&](const std::vector<std::string>& all) {
                                   return std::any_of(all.begin(), all.end(), is_it);
                                 },
                                 [](const auto&) { return false; }},
                      argument);
  });
}

/// The goal that has it.
std::optional<GoalId> goal_meeting(const Book& book, temporal::MeetingId meeting) {
  for (const auto& [id, entry] : book.tasks) {
    if (!book.counts(entry)) continue;
    const auto one = meeting_of(entry.task);
    if (one && one->what.id == meeting) return entry.task.origin;
  }
  return std::nullopt;
}

}  // namespace

Contingencies::Contingencies(Limits limits, const Rooms& rooms)
    : limits_(limits),
      beliefs_(rooms.beliefs),
      dates_(rooms.dates),
      committer_(rooms.committer),
      agenda_(rooms.agenda),
      out_(rooms.out),
      book_(rooms.book) {}

// ---- dates ----

void Contingencies::absorb_or_shift(const std::string& cause) {
  if (!dates_.controllable()) return check_network(cause);
  if (dates_.keeps_promises(Duration())) {
    return out_.decide(
        {"6 repair: absorb", cause, out_.plan_text(), "the promised dates hold", now()});
  }
  dates_.promise();
  out_.decide({"6 repair: shift", cause, out_.plan_text(), dates_.extent(), now()});
}

void Contingencies::check_network(const std::string& cause) { check_dates(cause, limits_.grace); }

void Contingencies::check_meetings() {
  check_dates("others' dates changed", kOthersVary);
  give_way();
  if (dates_.risk() == risk_told_) return;
  risk_told_ = dates_.risk();
  if (!risk_told_.empty()) out_.notice("the plan may fail because of others: " + risk_told_);
}

// Others wait for it where it is to come later. It goes there first; what it cannot do in that
// order is given up.
void Contingencies::give_way() {
  if (agenda_.repairing()) return;
  for (const auto& [meeting, dates] : book_.meetings.of) {
    if (!dates.behind) continue;
    const auto here = goal_meeting(book_, meeting), there = goal_meeting(book_, *dates.behind);
    if (!here || !there) continue;
    if (book_.is_given(*here)) committer_.retire(book_.falling_with({*here}));
    auto& order = book_.order;
    const auto from = std::find(order.begin(), order.end(), *here);
    const auto to = std::find(from, order.end(), *there);
    if (to == order.end() || to == from) continue;
    std::rotate(from, std::next(from), std::next(to));
    const std::string who = dates.last.empty() ? "another" : "'" + dates.last + "'";
    return fail_goal(*here, who + " waits for it in turn: goal " + to_text(*here) +
                                " goes behind goal " + to_text(*there));
  }
}

void Contingencies::check_dates(const std::string& cause, Duration tolerance) {
  committer_.reschedule();
  if (agenda_.repairing()) return;
  if (dates_.controllable()) {
    if (!dates_.keeps_promises(tolerance)) absorb_or_shift(cause);
    return;
  }
  if (dates_.schedule().conflicts.empty()) return;
  const Conflict conflict = dates_.schedule().conflicts.front();
  const std::string what = cause + "; task " + to_text(conflict.task) + " " + conflict.why;
  if (const Entry* entry = book_.find(conflict.task); entry != nullptr) {
    fail_goal(entry->task.origin, what);
  }
}

void Contingencies::check_slips() {
  const Dates::Slips slips = dates_.slips(now());
  if (slips.what.empty() || agenda_.repairing()) return;
  committer_.reschedule();
  absorb_or_shift(slips.what);
  dates_.keep_told(slips.late);
}

// ---- goals ----

void Contingencies::fail_goal(GoalId id, const std::string& cause) {
  if (book_.is_given(id)) committer_.retire(book_.falling_with({id}));
  Goal& goal = book_.goals.at(id);
  const bool refine = goal.refined < limits_.refinements;
  if (agenda_.needed() && agenda_.needed()->failed && *agenda_.needed()->failed != id && !refine) {
    committer_.retire({id});
    out_.set_state(goal, GoalState::kFailed, cause);
    return agenda_.plan_anew(std::nullopt, false, cause);
  }
  if (refine) ++goal.refined;
  agenda_.plan_anew(id, refine, cause);
}

void Contingencies::cancel_goal(GoalId id, const std::string& cause) {
  committer_.retire(book_.falling_with({id}));
  out_.set_state(book_.goals.at(id), GoalState::kCancelled, cause);
  committer_.reschedule();
  const std::vector<GoalId> left = book_.free_goals();
  out_.decide({"2 cancel", cause, "goals " + to_text(id),
               left.empty() ? "nothing is to be planned anew" : list_of("to plan anew:", left),
               now()});
  if (!left.empty()) agenda_.plan_anew(std::nullopt, false, cause);
}

void Contingencies::check_devices(const std::set<std::string>& newly) {
  const auto failed = [&](const Entry* entry) {
    if (!book_.counts(*entry)) return std::string();
    const auto devices = devices_of(entry->task);
    const auto hit = std::find_if(devices.begin(), devices.end(),
                                  [&](const auto& one) { return newly.count(one) != 0; });
    return hit == devices.end() ? std::string() : *hit;
  };
  for (const GoalId id : std::vector<GoalId>(book_.order)) {
    const auto tasks = book_.of(id);
    const auto hit = std::find_if(tasks.begin(), tasks.end(),
                                  [&](const Entry* entry) { return !failed(entry).empty(); });
    if (hit == tasks.end()) continue;
    fail_goal(id, "device " + failed(*hit) + " of task " + to_text((*hit)->task.id) + " failed");
  }
}

namespace {

/// The ground hides it now, and did not before. What is seen of it moves about a little: it counts
/// as hidden behind so much ground.
bool is_hidden(const world::Terrain& terrain, const world::Vector3& eye,
               const world::Vector3& before, const world::Vector3& now) {
  const auto sees = [&](world::Vector3 at) {
    at.z() = std::max(at.z(), terrain.elevation(at.x(), at.y())) + kShows;
    return terrain.line_of_sight(eye, at, -kBehind);
  };
  return sees(before) && !sees(now);
}

// Roles of a joint task see to what moves, from when they are negotiated: to plan it anew would be
// to leave those who have agreed on it.
bool is_with_its_roles(const std::vector<const Entry*>& tasks) {
  return std::ranges::any_of(tasks, [](const Entry* one) {
    return executive::is_joint(one->task.type) && !one->over();
  });
}

}  // namespace

/// Of one that is given; the others are planned with where it is now.
bool Contingencies::is_out_of_view(GoalId goal, const std::string& place,
                                   const world::Vector3& moved) {
  world::Vector3& all = moved_.try_emplace(goal, world::Vector3::Zero()).first->second;
  all += moved;
  if (all.norm() > kStillInView) return true;
  const auto known = beliefs_.world().places.find(place);
  return known != beliefs_.world().places.end() &&
         is_aimed_past(goal, known->second - all, known->second);
}

std::vector<Contingencies::Look> Contingencies::looks_at(GoalId goal,
                                                         const world::Vector3& place) const {
  std::vector<Look> looks;
  world::Vector3 from = beliefs_.vehicle().position;
  for (const Entry* one : book_.of(goal)) {
    if (!one->task.way.empty() && !one->done()) from = one->task.way.back();
    const executive::Parameter* target = one->task.parameters.find("target");
    const executive::Parameter* device = one->task.parameters.find("device");
    if (one->over() || target == nullptr || device == nullptr) continue;
    const world::SensorModel* sensor = world::find_sensor(beliefs_.model(), device->text);
    const world::Vector2 aim(target->numbers.at(0), target->numbers.at(1));
    if (sensor == nullptr || (aim - place.head<2>()).norm() > kAimedAt) continue;
    looks.push_back({world::eye_of(beliefs_.model(), from), sensor});
  }
  return looks;
}

/// Some look of the goal is aimed at where the place was `before`, and has it no longer well within
/// its view, or behind the ground.
bool Contingencies::is_aimed_past(GoalId goal, const world::Vector3& before,
                                  const world::Vector3& now) const {
  const world::Terrain& terrain = beliefs_.world().terrain;
  return std::ranges::any_of(looks_at(goal, before), [&](const Look& one) {
    if (is_hidden(terrain, one.eye, before, now)) return true;
    const double off = std::acos(
        std::clamp((before - one.eye).normalized().dot((now - one.eye).normalized()), -1.0, 1.0));
    return one.sensor->gimballed && off > kOfItsView * one.sensor->aperture;
  });
}

bool Contingencies::loses_sight_of(const std::string& place, const world::Vector3& now) const {
  const auto known = beliefs_.world().places.find(place);
  if (known == beliefs_.world().places.end()) return false;
  return std::ranges::any_of(book_.order, [&](GoalId id) {
    const Goal& goal = book_.goals.at(id);
    if (!goal.open() || !names(goal.task, place) || !book_.is_given(id)) return false;
    if (is_with_its_roles(book_.of(id))) return false;
    const auto moved = moved_.find(id);
    const world::Vector3 before =
        moved == moved_.end() ? known->second : world::Vector3(known->second - moved->second);
    return std::ranges::any_of(looks_at(id, before), [&](const Look& one) {
      return is_hidden(beliefs_.world().terrain, one.eye, before, now);
    });
  });
}

void Contingencies::look_elsewhere(const std::string& place, const world::Vector3& moved,
                                   const std::string& cause) {
  std::erase_if(moved_, [&](const auto& one) {
    return book_.goals.count(one.first) == 0 || !book_.is_given(one.first);
  });
  std::optional<GoalId> first;
  std::set<GoalId> stopped;
  for (const GoalId id : book_.order) {
    const Goal& goal = book_.goals.at(id);
    const bool given = book_.is_given(id);
    if (!goal.open() || goal.queued || !names(goal.task, place)) continue;
    if (given ? !is_out_of_view(id, place, moved) : moved.norm() <= kSamePlace) continue;
    if (is_with_its_roles(book_.of(id))) continue;
    if (!first) first = id;
    if (given) stopped.insert(id);
  }
  if (!first) return;
  for (const GoalId id : stopped) moved_.erase(id);
  committer_.retire(book_.falling_with(stopped));
  agenda_.plan_anew(first, true, cause + ", which goal " + to_text(*first) + " is about");
}

}  // namespace skein::supervisor
