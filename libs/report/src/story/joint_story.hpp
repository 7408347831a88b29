// SPDX-License-Identifier: Apache-2.0
// Joint tasks: who played which role when, which constraints were violated, how it was negotiated.
#pragma once

#include <string>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// A stretch of a joint task at one UAV in which nothing of this changed.
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

/// While a spatial constraint was violated.
struct ViolationStory {
  std::string uav, role, scm;
  std::string what;  ///< "distance to R1 104.2, required < 100"
  Span span;
};

/// Where a role was sent, and under which constraints.
struct RolePlaceStory {
  double t = 0.0;
  std::string uav, role, parameter;
  std::string by;    ///< "best-view(front, center)"
  std::string scms;  ///< "mcs1 mcs2"
  Position position;
};

/// Who maps which part of an area that was shared.
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

/// A negotiation, as its members told of it.
struct SessionStory {
  SessionName name;
  std::string modality;
  std::vector<std::string> members;  ///< who told of it or sent a message, by name
  std::vector<SessionStep> steps;    ///< time order
  std::vector<Flight> messages;      ///< about it between them; where none says so: meanwhile
};

struct JointTasks {
  std::vector<JointStory> stories;  ///< by UAV
  std::vector<ViolationStory> violations;
  std::vector<SessionStory> sessions;  ///< in the order in which they were opened
  std::vector<RolePlaceStory> places;  ///< time order
  std::vector<PartStory> parts;        ///< time order
};

/// Lines that lack what is needed are left out. Precondition: the journal is in time order.
JointTasks tell_joint_tasks(const Journal& journal, const Chronology& story);

}  // namespace skein::report
