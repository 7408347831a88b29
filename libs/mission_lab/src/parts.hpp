// SPDX-License-Identifier: Apache-2.0
// Generators of single parts of a mission.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/mission_lab/mission.hpp"

namespace skein::mission_lab {

/// A number rounded to an integer, as text.
std::string whole(double number);
/// "[10, 20]".
std::string point(double x, double y);
/// The corners of a rectangle 2a by 2b around a point: "[[0, 0], …]".
std::string rectangle(double x, double y, double a, double b);
/// A number rounded to one decimal, as text.
std::string tenths(double number);
/// A number rounded to two decimals, as text.
std::string hundredths(double number);
/// A number in [least, most), rounded to an integer, as text.
std::string whole_between(Random& random, double least, double most);
/// How long a task is to take [s]: a figure, or a range of a minute.
std::string draw_length(Random& random);
/// A UAV's contact-loss policy and after how long [s], to follow its other properties:
/// ", contact_loss: {…}".
std::string contact_loss(const std::string& policy, double after);
/// A volume of air around a point, from the ground or higher up, to the sky or lower down.
std::string draw_box(Random& random, double x, double y);
/// Adds a random place on the ground to the mission; returns its name ("P1", "P2", …).
std::string add_place(Random& random, Mission& mission);
/// x and y of "…[x, y…" [m].
std::pair<double, double> point_in(const std::string& text);
/// x and y of one of the mission's places [m]. Precondition: there is one.
std::pair<double, double> draw_place_of(Random& random, const Mission& mission);
/// Adds a step that carries out one action `after` seconds, rounded, behind its trigger.
void add_action(Mission& mission, const std::string& name, const std::string& when, double after,
                std::string action);
/// Index of the team member that a step is for.
std::size_t member_of(const Mission& mission, const Step& step);
/// Random time constraints of a high-level task.
std::string draw_times(Random& random);
/// A random high-level task for a request that only evaluates it.
std::string draw_question_task(Random& random);
/// A fault: the UAV refuses tasks of a type, for a while or permanently.
std::string draw_refusals(Random& random, const std::string& uav, double latest);

/// Statements and time constraints of two tasks requested at the time `at` [s]: a mapping, and a
/// perception task whose date may be long before the end of the mapping.
std::vector<std::pair<std::string, std::string>> draw_look_amid_mapping(Random& random, double at);

/// A random zone: a slightly rotated quadrilateral.
std::string draw_zone(Random& random);

/// A joint task of two UAVs that observe a place: its places and its statement.
struct JointTask {
  std::vector<std::string> places;  ///< "J1: [10, 20, 0]"
  std::string words;
};
JointTask draw_joint_task(Random& random, const std::vector<std::string>& uavs);

/// A fault: one of the daemons is killed in [3, latest] s and restarts with its stored state.
std::string draw_death(Random& random, const std::vector<std::string>& daemons, double latest);
/// The same fault with a restart without stored state.
std::string forgetting(std::string death);

/// Adds one to three kills of daemons in [3, latest] s, drawn from the mission's seed by a separate
/// sequence, so that the rest of the mission is unchanged. A functional layer may restart without
/// its stored state; its vehicles stay where they are.
void add_deaths(Mission& mission, double latest);

/// A member of the team.
const Member& any_of(Random& random, const Mission& mission);
/// Sometimes a narrow radio, losses, fewer than four cuts, and a member cut off from the others for
/// minutes, each from before `latest` s on.
void add_radio_troubles(Random& random, Mission& mission, double latest);
/// An operator takes the UAV in hand before `latest` s, for a moment or for minutes.
void add_hands(Random& random, Mission& mission, const std::string& who, double latest);
/// A volume V1 of air near a point [m] that is closed for up to five minutes from before `latest`
/// s.
void add_closing_air(Random& random, Mission& mission, double east, double north, double latest);
/// A member dies before `latest` s, for good or for minutes.
void add_death_of_one(Random& random, Mission& mission, double latest);

/// People change their minds: they cancel missions and give them again, take UAVs in hand and give
/// them back in every order, and tell UAVs that places lie elsewhere. Drawn from the mission's seed
/// by a separate sequence, so that the rest of the mission is unchanged.
void change_minds(Mission& mission);

/// An operator flies UAVs by hand in the middle of their tasks and gives them back, stops them
/// until a word comes, aborts all, gives elementary tasks to those who plan for themselves, and
/// closes and opens air; as a step of the script or as a scripted operator. Drawn like
/// change_minds().
void keep_an_operator_busy(Mission& mission);

/// Draws a device of the UAV.
using DrawDevice = std::function<std::string(Random&)>;
/// A fault of the vehicle in [10, latest] s: slow flight, an aborted task, a broken device, or a
/// loss of energy.
std::string draw_fault(Random& random, const std::string& uav, const DrawDevice& device,
                       double latest);

/// The same for a vehicle of COMETS, with the devices of its model.
std::string draw_fault(Random& random, const Member& uav, double latest);

/// The radio between two nodes is cut, from [10, latest] s on.
std::string draw_cut(Random& random, const std::string& one, const std::string& other,
                     double latest);
/// Cuts off a member of the team from all others for that time [s], and from the ground or not.
void add_cut_off(Mission& mission, const std::string& who, double from, double until,
                 bool from_ground);
/// Fewer than `limit` cuts between any two of a team, or one of them and the ground.
std::vector<std::string> draw_cuts(Random& random, const std::vector<Member>& team,
                                   std::size_t limit, double latest);

}  // namespace skein::mission_lab
