// SPDX-License-Identifier: Apache-2.0
// What UAVs told of their joint tasks.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/world/geometry.hpp"

namespace skein::journal {
struct Written;
namespace lines {
struct Joint;
struct Link;
struct Negotiation;
struct Place;
struct Role;
struct RoleTask;
}  // namespace lines
}  // namespace skein::journal

namespace skein::laws {

/// What one UAV told of one joint task.
struct JointTold {
  struct Phase {
    double at = 0;
    std::string phase, role;  ///< `role`: its own
    std::string why;
    bool over() const { return phase == "ended" || phase == "aborted" || phase == "not-loaded"; }
  };
  struct Componel {
    double at = 0;
    std::string role, componel, state;
  };
  std::string uav, joint;
  std::int64_t task = 0;  ///< of its executive; the last
  std::string variant;
  std::vector<Phase> phases;
  std::vector<Componel> componels;
};

/// A task that a role asked for.
struct RoleTaskTold {
  std::string uav, joint, role, componel;
  std::int64_t task = 0;
};

/// How a session came out at one UAV.
struct SessionTold {
  double at = 0;
  std::string uav, joint, opener, rows;
  double opened = 0;
  bool agreed = false;  ///< else failed
};

/// Where a UAV was sent by its role, under which constraints.
struct PlaceTold {
  double at = 0;
  std::string uav, joint, role;
  std::vector<std::string> scms;
  world::Vector3 position = world::Vector3::Zero();
};

/// A point that the ground told to be elsewhere.
struct PointTold {
  double at = 0;
  std::string name;
  world::Vector3 position = world::Vector3::Zero();
};

/// What the radio does, by the simulator's truth.
struct LinkTold {
  double at = 0;
  std::string from, to;
  bool up = true;
};

struct JointHistory {
  std::vector<JointTold> joints;  ///< one of each UAV and task
  std::vector<RoleTaskTold> tasks;
  std::vector<SessionTold> sessions;
  std::vector<PlaceTold> places;
  std::vector<PointTold> points;
  std::vector<LinkTold> links;

  /// False: a line of a kind of theirs that cannot be read.
  bool see(const journal::Record& record);
  void hear(const journal::lines::Link& line, const journal::Written& when);
  void hear(const journal::lines::Joint& line, const journal::Written& when);
  void hear(const journal::lines::Role& line, const journal::Written& when);
  void hear(const journal::lines::RoleTask& line, const journal::Written& when);
  void hear(const journal::lines::Negotiation& line, const journal::Written& when);
  void hear(const journal::lines::Place& line, const journal::Written& when);
  /// The radio was down between them, one way at least, for all of that time.
  bool cut_off(const std::string& a, const std::string& b, double from, double until) const;
  /// The last instant until `at` at which words went from the one to the other, over the link
  /// itself or past relays; 0: never.
  double last_reached(const std::string& from, const std::string& to,
                      const std::set<std::string>& relays, double at) const;
  /// It was up from the one to the other for all of it.
  bool up(const std::string& from, const std::string& to, double since, double until) const;
  /// For how much of that time it was up from the one to the other [s].
  double up_for(const std::string& from, const std::string& to, double since, double until) const;

 private:
  JointTold* of(const std::string& uav, const std::string& joint);
  /// As it was then and did not change since; nothing: it changed.
  std::optional<bool> steady(const std::string& from, const std::string& to, double since,
                             double until) const;
};

}  // namespace skein::laws
