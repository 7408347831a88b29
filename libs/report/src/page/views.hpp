// SPDX-License-Identifier: Apache-2.0
// The parts of the page. Each writes finished markup; none depends on another.
#pragma once

#include <string>

#include "markup.hpp"
#include "plot.hpp"
#include "skein/report/journal.hpp"
#include "skein/report/run_info.hpp"
#include "story/chronology.hpp"
#include "story/deliberation.hpp"
#include "story/statistics.hpp"

namespace skein::report {

/// Everything a view may show.
struct Run {
  const RunInfo& info;
  const Journal& journal;
  const Chronology& story;
  const Statistics& figures;
  const Deliberation& plans;
};

/// How many distinct colours the style sheet has for UAVs (classes u0, u1, …).
inline constexpr std::size_t kUavColours = 8;

/// The class that gives a UAV its colour: "u3".
std::string colour_class(std::size_t uav);

/// The local frame on the map's pixels, the same scale on both axes.
struct MapFrame {
  Extents view;
  double width = 0.0;   ///< [px]
  double height = 0.0;  ///< [px]
  double scale = 1.0;   ///< [px/m]
  Point operator()(double east, double north) const {
    return {(east - view.west) * scale, (view.north - north) * scale};
  }
  Point operator()(const Position& p) const { return (*this)(p.x, p.y); }
};

/// Frames all that happened, with a margin; the given extents when nothing did.
MapFrame frame_map(const RunInfo& info, const Chronology& story);

void write_map(Markup& out, const Run& run, const MapFrame& frame);
/// Parts of shared areas, places of roles, and where constraints were violated: a part of the map.
void write_joint_map(Markup& out, const Run& run, const MapFrame& frame);
/// Air that was reserved, each piece for its time: a part of the map.
void write_air_map(Markup& out, const Run& run, const MapFrame& frame);
void write_map_legend(Markup& out, const Run& run);

/// So many messages are drawn only on request: they would hide the rest.
bool hides_messages(const Chronology& story);

/// The drawing with the common time axis: tasks, links, profiles.
void write_timeline(Markup& out, const Run& run);
void write_timeline_legend(Markup& out);

void write_header(Markup& out, const Run& run);
void write_expectations(Markup& out, const Run& run);
void write_live_table(Markup& out, const Run& run);
void write_uav_table(Markup& out, const Run& run);
void write_message_table(Markup& out, const Run& run);
void write_link_table(Markup& out, const Run& run);
void write_event_list(Markup& out, const Run& run);

/// High-level tasks, decisions, and elementary tasks planned against done: nothing where there are
/// none.
void write_goal_table(Markup& out, const Run& run);
void write_decision_table(Markup& out, const Run& run);
/// Who offered what for each task of the team. Nothing where there was no auction.
void write_auction_table(Markup& out, const Run& run);
/// Negotiations of joint tasks as sequence diagrams: nothing where there are none.
void write_negotiations(Markup& out, const Run& run);
void write_explained_tasks(Markup& out, const Run& run);
/// The ways that were planned, under those that were flown.
void write_planned_ways(Markup& out, const Run& run, const MapFrame& frame);

/// The tracks and tasks that the page's script needs, as JSON.
std::string page_data(const Run& run, const MapFrame& frame);

}  // namespace skein::report
