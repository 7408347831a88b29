// SPDX-License-Identifier: Apache-2.0
// Pieces of a mission that are drawn by themselves.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/mission_lab/mission.hpp"

namespace skein::mission_lab {

/// Rounded to a whole number.
std::string whole(double number);
/// "[10, 20]".
std::string point(double x, double y);
/// Rounded to one decimal.
std::string tenths(double number);
/// Rounded to two.
std::string hundredths(double number);
/// A new place on the ground, "P1", "P2", … in their order: its name.
std::string add_place(Random& random, Mission& mission);
/// Which of the team a step is for.
std::size_t member_of(const Mission& mission, const Step& step);
/// Times of a high-level task.
std::string draw_times(Random& random);
/// A high-level task of which it is asked what it would take.
std::string draw_question_task(Random& random);
/// A fault: for a while, or for good, the UAV takes no task of a type.
std::string draw_refusals(Random& random, const std::string& uav, double latest);

/// Words and times of two tasks asked for at that time [s]: a mapping, and a look with a date that
/// may be long before its end.
std::vector<std::pair<std::string, std::string>> draw_look_amid_mapping(Random& random, double at);

/// Four corners, turned a little.
std::string draw_zone(Random& random);

/// Two UAVs watch a place together: where, and the words of the task.
struct JointTask {
  std::vector<std::string> places;  ///< "J1: [10, 20, 0]"
  std::string words;
};
JointTask draw_joint_task(Random& random, const std::vector<std::string>& uavs);

/// A fault: one of the daemons dies in [3, latest] s and comes back with what it knew.
std::string draw_death(Random& random, const std::vector<std::string>& daemons, double latest);
/// The same, but it comes back with nothing.
std::string forgetting(std::string death);

/// One to three deaths of daemons in a mission, in [3, latest] s, drawn from its seed beside all
/// else: the mission is the one without them, and so is most of what it comes to. A functional
/// layer may come back with nothing it knew; its vehicles are where they are.
void add_deaths(Mission& mission, double latest);

/// A device of the UAV that the fault is of.
using DrawDevice = std::function<std::string(Random&)>;
/// A fault of the vehicle, in [10, latest] s: slow, a task that aborts, a device that breaks,
/// energy.
std::string draw_fault(Random& random, const std::string& uav, const DrawDevice& device,
                       double latest);

/// The same of a vehicle of COMETS, by the devices of its model.
std::string draw_fault(Random& random, const Member& uav, double latest);

/// The radio between two nodes is cut, from [10, latest] s on.
std::string draw_cut(Random& random, const std::string& one, const std::string& other,
                     double latest);
/// Fewer than `limit` cuts between any two of a team, or one of them and the ground.
std::vector<std::string> draw_cuts(Random& random, const std::vector<Member>& team,
                                   std::size_t limit, double latest);

}  // namespace skein::mission_lab
