// SPDX-License-Identifier: Apache-2.0
// A mission in parts that can be left out one by one, and as the text of a scenario file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace skein::mission_lab {

/// A high-level task: "[perceive, P1, 30]" and its times, "end_before: 300".
struct Task {
  int id = 0;
  std::string words;
  std::string times;
};

/// A step of the ground's script: a unit mission, or another action as it is written.
struct Step {
  std::string name;
  std::string when;  ///< "{time: 5}"
  double after = 0;
  std::string uav;
  int mission = 0;
  std::string placement;  ///< "first, interrupt: true"; empty: the default
  bool evaluate = false;  ///< the mission is only evaluated, not executed
  std::vector<Task> tasks;
  std::string action;        ///< if there are no tasks: "cancel: {…}"
  bool repeats = false;      ///< it is armed again after it was done
  bool by_operator = false;  ///< a scripted operator does it: an action
};

struct Member {
  std::string name, model;
  std::string more;  ///< "start: [0, 0], energy: 0.4"
  double altitude = 40;
  int first_id = 100;
  std::string folder = "comets";  ///< of scenarios/, in which its model is
  int degree = 0;                 ///< 0: 5 in a mission with a global one, 4 in others
  std::string device = {};        ///< of its model, by which operators look; empty: none is known
};

struct Mission {
  std::uint64_t seed = 1;
  double limit = 2000;  ///< [s]
  std::string hills, wind;
  std::vector<std::string> zones, places, volumes;  ///< "Z1: [[…]]"
  std::vector<std::string> objects;                 ///< "hot: {kind: fire, …}"
  /// What moves and is followed by what sensors tell: "F1: {kind: fire, reach: 60, drift: 0.5}".
  std::vector<std::string> followed;
  std::vector<Member> team;
  std::vector<std::string> cuts;    ///< "{between: [...], from: 300, until: 330}"
  std::vector<std::string> relays;  ///< who passes on what is for others
  std::vector<std::string> links;   ///< unlike the others: "{between: [...], capacity: 19200}"
  std::vector<std::string> radio;   ///< further properties: "capacity: 19200", "silent: true"
  double latency = 0.02;            ///< of every link [s]
  double loss = 0;                  ///< of samples of streams, [0, 1)
  double range = 3000;              ///< of the radio [m]
  std::vector<Step> steps;
  std::vector<std::string> faults;
  /// Tasks of one global mission, at degree 5: "{id: 11, task: [perceive, P1, 20]}".
  std::vector<std::string> global;
  std::vector<std::string> bidders;   ///< who shares it out; empty: everybody
  std::string sharing;                ///< how they do it: "equity: 0.2, ahead: 2"
  std::string separation;             ///< "{merge: true}"; empty: nobody asks for it
  std::string consistency = "dip-m";  ///< by which UAVs know when others come to meet them
  double partner_lease = 0;           ///< [s]; 0: as scenarios have it unasked
  double planning_takes = 0;          ///< at most, in virtual time [s]; 0: as scenarios have it
  int shared_pads = 0;                ///< UAVs that start a few metres beside another
  bool joint = false;                 ///< there are interaction models
  double finish_after = 30;  ///< [s] after the last goal is settled; negative: at the limit
  std::string interaction = "monitoring-with-relay";  ///< the model, where there is one
};

/// The scenario's text. `scenarios`: the path from where it will stand to the folder scenarios/.
std::string to_yaml(const Mission& mission, const std::string& scenarios);

/// All missions with one part (step, task, fault, cut, volume, UAV) less. Some are not meaningful:
/// a trigger may wait for a removed part.
std::vector<Mission> smaller(const Mission& mission);

}  // namespace skein::mission_lab
