// SPDX-License-Identifier: Apache-2.0
// Reports of UAVs on their joint tasks, from the event log.
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

/// The reports of one UAV on one joint task.
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
  std::int64_t task = 0;  ///< last task id in its executive
  std::string variant;
  std::vector<Phase> phases;
  std::vector<Componel> componels;
};

/// A task that a role asked for.
struct RoleTaskTold {
  std::string uav, joint, role, componel;
  std::int64_t task = 0;
  double at = 0;
  std::string type;
};

/// The outcome of a negotiation session at one UAV.
struct SessionTold {
  double at = 0;
  std::string uav, joint, opener, rows;
  double opened = 0;
  bool agreed = false;  ///< else failed
};

/// A position that a UAV's role sent it to, and the constraints there.
struct PlaceTold {
  double at = 0;
  std::string uav, joint, role;
  std::vector<std::string> scms;
  world::Vector3 position = world::Vector3::Zero();
};

/// A point whose position the ground station changed.
struct PointTold {
  double at = 0;
  std::string name;
  world::Vector3 position = world::Vector3::Zero();
};

/// True state of a radio link.
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

  /// Takes a record, if it is of these kinds. False: it is of these kinds and cannot be read.
  bool see(const journal::Record& record);
  void hear(const journal::lines::Link& line, const journal::Written& when);
  void hear(const journal::lines::Joint& line, const journal::Written& when);
  void hear(const journal::lines::Role& line, const journal::Written& when);
  void hear(const journal::lines::RoleTask& line, const journal::Written& when);
  void hear(const journal::lines::Negotiation& line, const journal::Written& when);
  void hear(const journal::lines::Place& line, const journal::Written& when);
  /// Whether the radio between a and b was down, in one direction at least, for all of that time.
  bool cut_off(const std::string& a, const std::string& b, double from, double until) const;
  /// The last instant until `at` at which messages could pass from `from` to `to`, directly or past
  /// relays, and could so for `shortest` [s] at least; 0: never.
  double last_reached(const std::string& from, const std::string& to,
                      const std::set<std::string>& relays, double at, double shortest = 0) const;
  /// Whether the link from `from` to `to` was up for all of that time.
  bool up(const std::string& from, const std::string& to, double since, double until) const;
  /// For how much of that time the link from `from` to `to` was up [s].
  double up_for(const std::string& from, const std::string& to, double since, double until) const;

 private:
  JointTold* of(const std::string& uav, const std::string& joint);
  /// The state of the link during all of that time; absent: it changed.
  std::optional<bool> steady(const std::string& from, const std::string& to, double since,
                             double until) const;
};

}  // namespace skein::laws
