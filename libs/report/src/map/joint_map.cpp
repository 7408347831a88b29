// SPDX-License-Identifier: Apache-2.0
// Joint tasks on the map: parts of a shared area, places under spatial constraints, and where they
// were violated. Source: T V, figure B.1.
#include "page/views.hpp"
#include "story/joint_story.hpp"

namespace skein::report {

namespace {

void write_parts(Markup& out, const Run& run, const JointTasks& told, const MapFrame& f) {
  for (const PartStory& part : told.parts) {
    const auto uav = run.story.uav_index(part.uav);
    if (!uav) continue;
    std::vector<Point> points;
    for (const GroundPoint& corner : part.corners) points.push_back(f(corner.x, corner.y));
    out.open("path", {{"class", "part " + colour_class(*uav)}, {"d", path_data(points) + "Z"}});
    out.title("part of " + part.uav + ", agreed at " + clock_text(part.t)).close();
  }
}

void write_places(Markup& out, const Run& run, const JointTasks& told, const MapFrame& f) {
  for (const RolePlaceStory& place : told.places) {
    const auto uav = run.story.uav_index(place.uav);
    if (!uav) continue;
    const Point p = f(place.position);
    out.open("path",
             {{"class", "role-place " + colour_class(*uav)},
              {"transform", "translate(" + short_number(p.x) + " " + short_number(p.y) + ")"},
              {"d", "M0 -6L6 0L0 6L-6 0Z"}});
    out.title(place.uav + ", " + place.role + ": " + place.parameter + " = " + place.by + " at " +
              clock_text(place.t) + (place.scms.empty() ? "" : "\nunder " + place.scms));
    out.close();
  }
}

/// Where it flew meanwhile; at least where it was.
void write_violations(Markup& out, const Run& run, const JointTasks& told, const MapFrame& f) {
  for (const ViolationStory& one : told.violations) {
    const auto uav = run.story.uav_index(one.uav);
    if (!uav) continue;
    std::vector<Point> stretch;
    for (const TrackPoint& at : run.story.uavs[*uav].track) {
      const bool meanwhile = at.t >= one.span.from && at.t <= one.span.to;
      if (meanwhile || (stretch.empty() && at.t > one.span.from)) stretch.push_back(f(at.position));
    }
    if (stretch.empty()) continue;
    if (stretch.size() == 1) stretch.push_back(stretch.front());
    out.open("path",
             {{"class", "violated-stretch"}, {"d", path_data(simplified(stretch, 0.35, 2000))}});
    out.title(one.uav + ", " + one.role + ": " + one.scm + " violated, " + one.what + "\n" +
              clock_text(one.span.from) + " to " + clock_text(one.span.to));
    out.close();
  }
}

}  // namespace

void write_joint_map(Markup& out, const Run& run, const MapFrame& frame) {
  const JointTasks told = tell_joint_tasks(run.journal, run.story);
  if (told.stories.empty()) return;
  out.open("g", {{"class", "joint-map"}});
  write_parts(out, run, told, frame);
  write_violations(out, run, told, frame);
  write_places(out, run, told, frame);
  out.close().line_break();
}

}  // namespace skein::report
