// SPDX-License-Identifier: Apache-2.0
// Joint tasks: roles of the UAVs over time, violations of spatial constraints, negotiations.
#pragma once

#include <string>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// A span of a joint task at one UAV with constant phase, role and blocks.
struct JointSegment {
  std::string phase;  ///< loading, loaded, running, leaving
  std::string role;   ///< empty: not agreed
  std::string blocks;
  Span span;
};

struct JointStory {
  std::string uav;
  std::string joint;  ///< model, arguments, members
  std::vector<JointSegment> segments;
  std::string end, why;  ///< ended, aborted, not-loaded; empty: not over
};

/// A span during which a spatial constraint was violated.
struct ViolationStory {
  std::string uav, role, scm;
  std::string what;  ///< "distance to R1 104.2, required < 100"
  Span span;
};

/// A place that was chosen for a role, and the constraints that it satisfies.
struct RolePlaceStory {
  double t = 0.0;
  std::string uav, role, parameter;
  std::string by;    ///< "best-view(front, center)"
  std::string scms;  ///< "mcs1 mcs2"
  Position position;
};

/// A UAV's part of an area that was partitioned among several UAVs.
struct PartStory {
  double t = 0.0;
  std::string uav;
  std::vector<GroundPoint> corners;
};

struct SessionStep {
  double t = 0.0;
  std::string uav;
  std::string state;  ///< invited, offered, refused, agreed, failed, …
  std::string what;   ///< offer, result or reason
};

/// One negotiation session, from the lines of its members.
struct SessionStory {
  SessionName name;
  std::string modality;
  std::vector<std::string> members;  ///< UAVs with a line or a message of the session, by name
  std::vector<SessionStep> steps;    ///< time order
  std::vector<Flight> messages;      ///< of the session; if none names it, those sent meanwhile
};

struct JointTasks {
  std::vector<JointStory> stories;  ///< by UAV
  std::vector<ViolationStory> violations;
  std::vector<SessionStory> sessions;  ///< in the order in which they were opened
  std::vector<RolePlaceStory> places;  ///< time order
  std::vector<PartStory> parts;        ///< time order
};

/// Incomplete lines are left out. Precondition: the journal is in time order.
JointTasks tell_joint_tasks(const Journal& journal, const Chronology& story);

}  // namespace skein::report
