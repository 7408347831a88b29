// SPDX-License-Identifier: Apache-2.0
// The laws, one file of functions per subject.
#pragma once

#include <functional>
#include <vector>

#include "skein/laws/history.hpp"
#include "skein/laws/violation.hpp"

namespace skein::laws {

// laws.cpp
std::vector<Violation> lines_unread(const History& history);
// achieved.cpp
std::vector<Violation> perceptions_not_done(const History& history);
std::vector<Violation> places_not_reached(const History& history);
std::vector<Violation> waits_not_done(const History& history);
std::vector<Violation> done_twice(const History& history);
// coverage.cpp
/// Time during which the device had the zone in view [s]; absent: the goal is no detection.
std::optional<double> seconds_detected(const History& history, const Uav& uav, const Goal& goal);
std::vector<Violation> detections_not_done(const History& history);
std::vector<Violation> mappings_not_done(const History& history);
inline constexpr double kMapPart = 0.99;  ///< part of a zone that a mapping must cover
/// An activity of a UAV with a device.
struct Look {
  const Uav* uav = nullptr;
  const Activity* look = nullptr;
};
/// The part of a zone that was in view during one of `looks` at some time, [0, 1].
double part_in_view(const History& history, const std::vector<Look>& looks,
                    const world::Polygon& zone);
/// The part that was in view during one of `some` and during one of `others`, [0, 1], where that is
/// wider than both see to one side together: so much do both see along a border of their parts.
double part_mapped_twice(const History& history, const std::vector<Look>& some,
                         const std::vector<Look>& others, const world::Polygon& zone);
// synchronisation.cpp
std::vector<Violation> synchronisations_apart(const History& history);
std::vector<Violation> partners_too_near(const History& history);
std::vector<Violation> come_before_foretold(const History& history);
std::vector<Violation> waits_in_circles(const History& history);
/// Whether the links between all UAVs are up during [from, until].
bool all_hear_each_other(const History& history, double from, double until);
std::vector<Violation> plan_words_unheard(const History& history);
/// A partner does not come to the meeting of a goal: its own goal for it failed, or it has none, or
/// it waits at another meeting for one that never comes.
bool partner_never_comes(const History& history, const Uav& uav, const Goal& goal);
/// Since when no goal of the partner has the meeting of this goal: those that had failed or were
/// cancelled; 0: there was none. Absent: the partner comes, or came, or the goal has no meeting.
std::optional<double> stays_away_since(const Uav& uav, const Goal& goal, const Uav& partner);
// partners.cpp
std::vector<Violation> absent_partners_awaited(const History& history);
/// Why it is untrue that a partner has been silent since then, if the reason says so.
std::optional<std::string> untrue_silence(const History& history, const Uav& uav,
                                          const std::string& why, double at);
// joint_tasks.cpp
std::vector<Violation> roles_held_twice(const History& history);
std::vector<Violation> agreements_apart(const History& history);
std::vector<Violation> restless_negotiations(const History& history);
std::vector<Violation> activations_without_end(const History& history);
std::vector<Violation> roles_at_a_standstill(const History& history);
std::vector<Violation> joint_tasks_without_end(const History& history);
std::vector<Violation> joint_tasks_apart(const History& history);
// joint_places.cpp
std::vector<Violation> places_against_constraints(const History& history);
// joint_truth.cpp
std::vector<Violation> joint_tasks_not_done(const History& history);
std::vector<Violation> areas_mapped_twice(const History& history);
// taking_in.cpp
std::vector<Violation> newcomers_left_out(const History& history);
// team.cpp
std::vector<Violation> team_sales_nobody_bid_in(const History& history);
std::vector<Violation> granted_and_not_begun(const History& history);
std::vector<Violation> not_asked_in_sales(const History& history);
std::vector<Violation> team_tasks_begun_twice(const History& history);
std::vector<Violation> team_tasks_without_owner(const History& history);
std::vector<Violation> left_aloft(const History& history);
std::vector<Violation> team_delays_not_kept(const History& history);
std::vector<Violation> team_abilities_lacking(const History& history);
std::vector<Violation> team_sales_unexplained(const History& history);
std::vector<Violation> kept_while_late(const History& history);
// motion.cpp
std::vector<Violation> motions_at_once(const History& history);
std::vector<Violation> motions_under_tasks(const History& history);
std::vector<Violation> motions_never_begun(const History& history);
std::vector<Violation> statuses_unfit(const History& history);
// promises.cpp
std::vector<Violation> times_not_kept(const History& history);
std::vector<Violation> goals_without_end(const History& history);
std::vector<Violation> idle_without_word(const History& history);
std::vector<Violation> idling_untold(const History& history);
// reasons.cpp
std::vector<Violation> untrue_reasons(const History& history);
std::vector<Violation> feasible_but_failed(const History& history);
/// Whether the scenario has no faults, no cut links, no closed air, only UAVs at degree 4 or 5 with
/// full energy, and no requests that revoke others.
bool is_clean(const scenario::Scenario& scenario);
// requests.cpp
/// Whether the word is a decision to plan anew.
bool is_repair(const Word& word);
std::vector<Violation> asked_again_and_again(const History& history);
// estimates.cpp
std::vector<Violation> evaluations_off(const History& history);
std::vector<Violation> winds_off(const History& history);
// objects.cpp
std::vector<Violation> objects_elsewhere(const History& history);
std::vector<Violation> fires_that_shrink(const History& history);
// safety.cpp
/// Whether the UAV has lost control by then: engine failure, energy used up, or ground contact.
bool out_of_control(const Uav& uav, double at);
std::vector<Violation> in_closed_air(const History& history);
std::vector<Violation> closed_air_untold(const History& history);
std::vector<Violation> flown_into_the_ground(const History& history);
std::vector<Violation> energy_short(const History& history);
// on_the_ground.cpp
std::vector<Violation> off_its_ground(const History& history);
/// Whether no ground of the world is too steep for the vehicle; always true if it flies.
bool climbs_everything(const History& history, const world::VehicleModel& vehicle);
/// Whether no ground is steeper than the vehicle climbs in flight.
bool rises_everywhere(const History& history, const world::VehicleModel& vehicle);
// air.cpp
/// For how much of [from, until] the UAV waited for others to leave its air [s].
double seconds_waited_for_air(const History& history, const std::string& uav, double from,
                              double until);
std::vector<Violation> waits_for_each_other(const History& history);
std::vector<Violation> waits_for_unused_air(const History& history);
// separation.cpp
std::vector<Violation> encounters(const History& history);
std::vector<Violation> too_near_in_the_air(const History& history);

/// Calls `check` with each UAV and each of its goals that was achieved, and when.
void for_achieved(const History& history,
                  const std::function<void(const Uav&, const Goal&, double)>& check);

/// "12.5".
std::string figure(double number);

/// Bound on a vehicle's distance from its intended position [m]: its tracking error and the wind's
/// displacement, both doubled; plus the waiting circle if it cannot hover.
double wander(const History& history, const Uav& uav);

}  // namespace skein::laws
