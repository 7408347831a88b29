// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/laws.hpp"

#include <algorithm>

#include "checks.hpp"

namespace skein::laws {

std::vector<Violation> lines_unread(const History& history) {
  std::vector<Violation> result;
  for (const Word& line : history.unread)
    result.push_back({"", line.at, "", 0, "this line lacks something: " + line.text});
  return result;
}

namespace {

std::vector<Law> team_laws() {
  return {
      {"team-asked",
       "what the team sells is owned under the number of a sale in which UAVs bid for it",
       team_sales_nobody_bid_in},
      {"team-called", "who takes part in a team is asked in each of its sales", not_asked_in_sales},
      {"team-once", "a task of the team is begun by its owners alone, and again if it is put back",
       team_tasks_begun_twice},
      {"team-owned", "a task of the team finds an owner once the network has healed",
       team_tasks_without_owner},
      {"team-explained", "who has a task of the team, and why, is said", team_sales_unexplained},
      {"team-late", "who is late keeps nothing of the team that it has not begun", kept_while_late},
      {"team-begun", "who is granted a task of the team and has nothing else to do begins it",
       granted_and_not_begun},
      {"team-delays", "what is to begin some time after another task of the team does so",
       team_delays_not_kept},
      {"team-abilities", "who begins a task of the team has what it needs", team_abilities_lacking},
      {"team-home", "who is out of reach of most and has nothing to do comes home", left_aloft}};
}

/// Of flights and drives, by where the vehicles truly were.
std::vector<Law> motion_laws() {
  return {
      {"closed-air", "not in closed air but on the way out", in_closed_air},
      {"closed-air-told", "who is in closed air below degree 4 says so", closed_air_untold},
      {"above-ground", "who plans flies into no ground", flown_into_the_ground},
      {"separation", "where it is asked for, UAVs in the air keep the separation of their models",
       too_near_in_the_air},
      {"energy", "never below the reserve in the air, nor on a drive", energy_short},
      {"on-the-ground", "what keeps to the ground is on it, and on none that is too steep for it",
       off_its_ground}};
}

std::vector<Law> task_laws() {
  return {
      {"lines", "every line that these laws read has what one of its kind must have", lines_unread},
      {"perceived", "a perception achieved looked from its place, for its time",
       perceptions_not_done},
      {"reached", "places, takeoffs and landings achieved came true then", places_not_reached},
      {"waited", "a wait achieved was waited", waits_not_done},
      {"progress", "what was perceived before an interruption is not perceived again", done_twice},
      {"detected", "a detection achieved looked at its zone for its time", detections_not_done},
      {"mapped", "a mapping achieved saw its zone", mappings_not_done},
      {"synchronised", "partners of a synchronisation achieved were in it at one time",
       synchronisations_apart},
      {"foretold", "nobody comes to a meeting before it was foretold", come_before_foretold},
      {"healed", "a second after two UAVs reach each other, each has heard the other's last word",
       plan_words_unheard},
      {"parted", "nobody waits for ever for one who waits for it elsewhere", waits_in_circles},
      {"awaited", "nobody waits for long for who is silent, lost or stays away",
       absent_partners_awaited},
      {"partners-apart", "partners of a synchronisation keep apart", partners_too_near},
      {"roles", "no two UAVs hold a role that is for one", roles_held_twice},
      {"agreements", "a negotiation comes out alike wherever it is decided", agreements_apart},
      {"restless", "roles that all have just kept are not asked for again", restless_negotiations},
      {"activations", "all of a role is over when its joint task is", activations_without_end},
      {"standstill", "who cannot go on with its role leaves it", roles_at_a_standstill},
      {"joint", "no joint task ends at one and is aborted at another", joint_tasks_apart},
      {"joint-ends", "each joint task ends, and says why if not done", joint_tasks_without_end},
      {"joint-done", "a joint task achieved was truly done by its members", joint_tasks_not_done},
      {"twice-mapped", "an area is shared with who came back, not mapped twice",
       areas_mapped_twice},
      {"taken-in", "who asks for a joint task that others are at takes part", newcomers_left_out},
      {"places", "where a role sends a UAV its constraints hold, by truth",
       places_against_constraints},
      {"one-motion", "one motion at a time, one use of a device", motions_at_once},
      {"held", "no motion begins under a task of another goal", motions_under_tasks},
      {"begins", "a motion that is given to the vehicle begins", motions_never_begun},
      {"fits", "what is told of a task can be so", statuses_unfit},
      {"mutual", "UAVs wait for each other's air for 2 s at the most, longer on narrow links",
       waits_for_each_other},
      {"unused-air", "nobody is kept from air by one who stays far from there",
       waits_for_unused_air},
      {"times", "times of goals achieved are kept, or it is said", times_not_kept},
      {"ends", "each goal ends, or something is still done at the run's end", goals_without_end},
      {"idle", "in the air with open goals and nothing to do, it names one and says why",
       idle_without_word},
      {"idle-told", "who is in the air below degree 4 with nothing under way says so",
       idling_untold},
      {"reasons", "what fails says why, and truly", untrue_reasons},
      {"feasible", "where nothing goes wrong nothing fails", feasible_but_failed},
      {"asked", "what is refused is not asked for again and again", asked_again_and_again},
      {"evaluated", "a mission takes what its evaluation said", evaluations_off},
      {"wind", "the wind that is felt blows", winds_off},
      {"seen", "objects that are followed were where they are said to be", objects_elsewhere},
      {"fires", "what has burnt goes on to belong to its fire", fires_that_shrink}};
}

}  // namespace

const std::vector<Law>& all_laws() {
  static const std::vector<Law> kLaws = [] {
    std::vector<Law> all = task_laws();
    for (std::vector<Law> more : {motion_laws(), team_laws()})
      for (Law& law : more) all.push_back(std::move(law));
    return all;
  }();
  return kLaws;
}

std::vector<Violation> broken_laws(const scenario::Scenario& scenario,
                                   const std::vector<journal::Record>& records,
                                   const std::vector<std::string>& only, Duration late) {
  History history = history_of(scenario, records);
  history.late = late.to_seconds();
  std::vector<Violation> result;
  for (const Law& law : all_laws()) {
    if (!only.empty() && std::find(only.begin(), only.end(), law.name) == only.end()) continue;
    for (Violation& violation : law.broken(history)) {
      violation.law = law.name;
      result.push_back(std::move(violation));
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Violation& a, const Violation& b) { return a.at < b.at; });
  return result;
}

std::string to_text(const Violation& violation) {
  std::string text = figure(violation.at) + " s";
  if (!violation.uav.empty()) text += ", " + violation.uav;
  if (violation.goal != 0) text += ", goal " + std::to_string(violation.goal);
  return text + ": " + violation.law + ": " + violation.sentence;
}

std::string to_text(const std::vector<Violation>& violations) {
  std::string text;
  for (const Violation& violation : violations) text += to_text(violation) + "\n";
  return text;
}

GoalCount count_goals(const History& history) {
  GoalCount count;
  for (const auto& [name, uav] : history.uavs) {
    for (const auto& [id, goal] : uav.goals) {
      ++count.all;
      count.achieved += goal.state() == "achieved" ? 1 : 0;
      count.failed += goal.state() == "failed" ? 1 : 0;
    }
  }
  return count;
}

std::optional<Nearest> nearest(const History& history) {
  Nearest result;
  for (auto a = history.uavs.begin(); a != history.uavs.end(); ++a) {
    for (auto b = std::next(a); b != history.uavs.end(); ++b) {
      for (const Sample& sample : a->second.samples) {
        const auto other = b->second.at(sample.at);
        if (!sample.airborne || !other || !other->airborne) continue;
        const double distance = (sample.position - other->position).norm();
        if (distance < result.distance) result = {distance, sample.at, a->first, b->first};
      }
    }
  }
  if (result.distance == kNever) return std::nullopt;
  return result;
}

}  // namespace skein::laws
