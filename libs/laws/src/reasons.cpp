// SPDX-License-Identifier: Apache-2.0
// What failed says why, and what it says is true.
#include <algorithm>
#include <array>
#include <set>
#include <variant>

#include "checks.hpp"
#include "scripted.hpp"

namespace skein::laws {

namespace {

bool is_bounded(const Goal& goal) { return goal.task.time.any() || !goal.task.after.empty(); }

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

bool has_bounds(const Uav& uav, double at) {
  return std::any_of(uav.goals.begin(), uav.goals.end(), [&](const auto& one) {
    return one.second.received() <= at && is_bounded(one.second);
  });
}

// "…, which 'heliv' needs"; empty: nobody does.
std::string who_needs(const std::string& why) {
  const std::size_t end = why.find("' needs");
  const std::size_t quote = end == std::string::npos ? end : why.rfind('\'', end - 1);
  return quote == std::string::npos ? "" : why.substr(quote + 1, end - quote - 1);
}

// Of something that has a time, or that somebody has a time for.
std::optional<std::string> untimely(const History& history, const Uav& uav, const std::string& why,
                                    double at) {
  const bool of_time = says(why, "must end before") || says(why, "must start before") ||
                       says(why, "after the end of goal");
  if (!of_time || says(why, "runs") || has_bounds(uav, at)) return std::nullopt;
  const auto other = history.uavs.find(who_needs(why));
  if (other == history.uavs.end()) return "nothing asked of it has a time";
  if (has_bounds(other->second, at)) return std::nullopt;
  return "nothing asked of " + other->first + " has a time";
}

// A joint task may fail by what a partner has not any more.
const Uav& whose_device(const History& history, const Uav& uav, const std::string& why) {
  for (const auto& [name, partner] : history.uavs)
    if (says(why, "'" + name + "' left: ") || says(why, name + ": it can play no role"))
      return partner;
  return uav;
}

bool names_a_goal_twice(const Uav& uav, const std::string& why) {
  return std::any_of(uav.goals.begin(), uav.goals.end(), [&](const auto& one) {
    const std::string name = " (" + mission::to_text(one.second.task) + ")";
    return why.find(name + name) != std::string::npos;
  });
}

// Of air that the scenario closes later it knows from the start: it plans for then.
bool knows_closed_air(const History& history, const Uav& uav, double at) {
  const auto& volumes = history.scenario->world.volumes;
  return std::ranges::any_of(volumes,
                             [&](const auto& one) { return one.when.until.to_seconds() > at; }) ||
         std::ranges::any_of(uav.closings, [&](const Closing& one) { return one.known <= at + 1; });
}

/// Without what it passes on of a partner's goal that failed: that is judged where it did.
std::string own_words(const History& history, const std::string& why) {
  for (const auto& [name, partner] : history.uavs) {
    const std::string before = "'" + name + "' takes no part: ";
    const std::size_t at = why.find(before);
    if (at == std::string::npos) continue;
    const std::string quoted = why.substr(at + before.size());
    for (const auto& [id, goal] : partner.goals)
      for (const Change& one : goal.changes)
        if (!one.why.empty() && quoted.starts_with(one.why))
          return why.substr(0, at) + before + quoted.substr(one.why.size());
  }
  return why;
}

// Why a reason cannot be true; nothing when truth does not contradict it.
std::optional<std::string> contradiction(const History& history, const Uav& uav,
                                         const std::string& said, double at) {
  const std::string why = own_words(history, said);
  if (why.empty()) return "it gives no reason";
  if (names_a_goal_twice(uav, why)) return "it names a goal twice over";
  // A plan of one UAV that contradicts itself is the planner's, not the mission's.
  if (says(why, "must start while")) return "tasks of its own plan contradict each other";
  if (says(why, "half a cell")) return "nobody can set that cell";
  if (auto untrue = untimely(history, uav, why, at)) return untrue;
  if (auto untrue = untrue_silence(history, uav, why, at)) return untrue;
  if (says(why, "closed air") && !knows_closed_air(history, uav, at)) return "no air is closed";
  if (says(why, "has failed") && says(why, "device") &&
      !whose_device(history, uav, why).had_fault("sensor", at))
    return "no device failed";
  return std::nullopt;
}

}  // namespace

std::vector<Violation> untrue_reasons(const History& history) {
  std::vector<Violation> result;
  for (const auto& [name, uav] : history.uavs) {
    std::set<std::pair<double, std::string>> told;  // one reason for a whole mission counts once
    for (const auto& [id, goal] : uav.goals) {
      if (goal.state() != "failed" || history.was_killed(name)) continue;
      const Change& last = goal.changes.back();
      if (!told.emplace(last.at, last.why).second) continue;
      const auto why = contradiction(history, uav, last.why, last.at);
      if (!why) continue;
      result.push_back({"", last.at, name, id,
                        mission::to_text(goal.task) + " failed, \"" + last.why + "\": " + *why});
    }
  }
  return result;
}

namespace {

using ground_station::Action;

bool is_trouble(const Action& action) {
  return std::holds_alternative<ground_station::CancelMission>(action) ||
         std::holds_alternative<ground_station::CloseAir>(action) ||
         std::holds_alternative<ground_station::SetDegree>(action) ||
         std::holds_alternative<ground_station::TakeInHand>(action) ||
         std::holds_alternative<ground_station::AbortTasks>(action);
}

bool has_trouble(const scenario::Scenario& s) {
  bool found = false;
  for_actions(s, [&](const Action& action) { found = found || is_trouble(action); });
  return found;
}

}  // namespace

bool is_clean(const scenario::Scenario& s) {
  const auto& faults = s.faults;
  const bool sound = faults.kills.empty() && faults.breaks.empty() && faults.slows.empty() &&
                     faults.aborts.empty() && faults.energies.empty();
  const bool quiet = s.radio.cuts.empty() && s.world.volumes.empty();
  const bool full = std::all_of(s.uavs.begin(), s.uavs.end(),
                                [](const auto& uav) { return uav.energy >= 1 && uav.degree >= 4; });
  return sound && quiet && full && !has_trouble(s);
}

namespace {

// Whoever plays a role of it hovers and has a visible camera.
bool can_watch_together(const world::VehicleModel& model) {
  return model.hovers && world::find_sensor(model, "visible") != nullptr;
}

bool equipped(const Uav& uav, const Goal& goal) {
  const world::VehicleModel& model = uav.spec->model;
  if (goal.task.name == "monitoring-with-relay") return can_watch_together(model);
  if (goal.task.name == "perform-mapping") {
    return world::find_sensor(model, "mapping") != nullptr ||
           world::find_sensor(model, "singlecam") != nullptr;
  }
  return !model.sensors.empty();
}

// No place that it is to come to is higher over the ground than it flies.
bool flies_so_high(const History& history, const Uav& uav, const Goal& goal) {
  const auto& arguments = goal.task.arguments;
  return uav.spec->model.ground ||
         std::none_of(arguments.begin(), arguments.end(), [&](const mission::Argument& one) {
           const auto place = history.place(one, goal.received());
           return place && history.in_the_air(*place) &&
                  place->z() - history.terrain.elevation(place->x(), place->y()) >
                      uav.spec->model.ceiling;
         });
}

// Orders, or a partner, that never come: the wait ends, as it must, when what it may take is spent.
// Whose fault that is, the partner's own goal tells. When such a wait began, or was given up; never
// for every other goal.
double waits_in_vain_from(const History& history, const Uav& uav, const Goal& goal) {
  const bool given_up =
      goal.state() == "failed" && says(goal.changes.back().why, "waits no longer");
  if (!given_up && goal.state() != "under-way") return kNever;
  const bool in_vain =
      goal.task.name == "wait-for-orders" ? given_up : partner_never_comes(history, uav, goal);
  return in_vain ? goal.changes.back().at : kNever;
}

// From when on its energy is what such a wait has left.
double spent_from(const History& history, const Uav& uav) {
  double from = kNever;
  for (const auto& [id, goal] : uav.goals)
    from = std::min(from, waits_in_vain_from(history, uav, goal));
  return from;
}

bool is_the_same(const Goal& one, const Goal& other) {
  return one.task.name == other.task.name && one.task.arguments == other.task.arguments;
}

// A partner of the joint task had failed before, for a reason of its own: it makes no offer.
bool has_failed_before(const Uav& partner, const Goal& goal) {
  return goal.task.name == "monitoring-with-relay" &&
         std::ranges::any_of(partner.goals, [&](const auto& one) {
           const Change& end = one.second.changes.back();
           return is_the_same(one.second, goal) && one.second.state() == "failed" &&
                  end.at < goal.changes.back().at && !says(end.why, "offer");
         });
}

// It is a member by a list among the arguments, and nobody asked it for the same.
bool was_never_asked(const Uav& partner, const Goal& goal) {
  const auto names_it = [&](const mission::Argument& argument) {
    const auto* members = std::get_if<std::vector<std::string>>(&argument);
    return members != nullptr && std::ranges::count(*members, partner.name()) > 0;
  };
  return std::ranges::any_of(goal.task.arguments, names_it) &&
         std::ranges::none_of(partner.goals,
                              [&](const auto& one) { return is_the_same(one.second, goal); });
}

bool left_alone(const History& history, const Uav& uav, const Goal& goal) {
  return says(goal.changes.back().why, "without an offer") &&
         std::ranges::any_of(history.uavs, [&](const auto& other) {
           return other.first != uav.name() &&
                  (has_failed_before(other.second, goal) || was_never_asked(other.second, goal));
         });
}

bool has_deadline(const Uav& uav) {
  return std::any_of(uav.goals.begin(), uav.goals.end(),
                     [](const auto& one) { return is_bounded(one.second); });
}

// Another one of whom something is asked by a date needs this UAV before: the law `reasons` judges
// whether that is so.
bool would_make_another_late(const History& history, const Goal& goal) {
  return std::any_of(history.uavs.begin(), history.uavs.end(), [&](const auto& other) {
    const std::string needed = "which '" + other.first + "' needs";
    return says(goal.changes.back().why, needed.c_str()) && has_deadline(other.second);
  });
}

// Over ground that is steeper than it climbs a vehicle may find no way at the height, or with the
// turns, that it needs; behind it, it may be heard by nobody (whether it was, `reasons` judges).
bool is_too_steep_for(const History& history, const Uav& uav, const std::string& why) {
  static constexpr std::array kWhys{
      "ground",          "no free way with turns", "no free air",      "contact",
      "come into reach", "does not plan to come",  "without an offer", "depends on what failed"};
  const bool of_it =
      std::any_of(kWhys.begin(), kWhys.end(), [&](const char* one) { return says(why, one); });
  return of_it && !rises_everywhere(history, uav.spec->model);
}

}  // namespace

// In a run in which nothing goes wrong nothing fails, but what has a deadline or no device, is to
// fly higher than it can, or would make another miss one, waits for who never comes, was not asked
// or has failed itself, what has no energy left after those, and what one is to do that keeps to
// ground of which some is too steep for it, or flies over or behind such and says so.
std::vector<Violation> feasible_but_failed(const History& history) {
  std::vector<Violation> result;
  if (!is_clean(*history.scenario)) return result;
  for (const auto& [name, uav] : history.uavs) {
    const bool able =
        std::all_of(uav.goals.begin(), uav.goals.end(), [&, &uav = uav](const auto& one) {
          return equipped(uav, one.second) && flies_so_high(history, uav, one.second);
        });
    if (has_deadline(uav) || !able || !climbs_everything(history, uav.spec->model)) continue;
    for (const auto& [id, goal] : uav.goals) {
      const Change& last = goal.changes.back();
      const bool spent = last.at >= spent_from(history, uav) && says(last.why, "energy");
      const bool in_vain = says(last.why, "does not plan to come to synchronisation") &&
                           partner_never_comes(history, uav, goal);
      if (goal.state() != "failed" || spent || in_vain || left_alone(history, uav, goal) ||
          would_make_another_late(history, goal) || is_too_steep_for(history, uav, last.why))
        continue;
      result.push_back({"", goal.changes.back().at, name, id,
                        mission::to_text(goal.task) + " failed though nothing went wrong: \"" +
                            goal.changes.back().why + "\""});
    }
  }
  return result;
}

}  // namespace skein::laws
