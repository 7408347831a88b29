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

/// The frame of the map: the extents of everything that happened, with a margin; the run's extents
/// when nothing happened.
MapFrame frame_map(const RunInfo& info, const Chronology& story);

void write_map(Markup& out, const Run& run, const MapFrame& frame);
/// Map layer: parts of partitioned areas, places of roles, and violations of spatial constraints.
void write_joint_map(Markup& out, const Run& run, const MapFrame& frame);
/// Map layer: the reserved air volumes, each shown during its reservation.
void write_air_map(Markup& out, const Run& run, const MapFrame& frame);
void write_map_legend(Markup& out, const Run& run);

/// Whether the timeline hides messages until the reader asks for them, because there are too many.
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

/// High-level tasks, and elementary tasks as planned and as executed. Without them writes nothing,
/// as do the next functions without their content.
void write_goal_table(Markup& out, const Run& run);
void write_decision_table(Markup& out, const Run& run);
/// The bids for each task of the team. Nothing when there was no auction.
void write_auction_table(Markup& out, const Run& run);
/// Negotiations of joint tasks as sequence diagrams. Nothing when there were none.
void write_negotiations(Markup& out, const Run& run);
void write_explained_tasks(Markup& out, const Run& run);
/// Map layer below the tracks: the planned paths.
void write_planned_ways(Markup& out, const Run& run, const MapFrame& frame);

/// The tracks and tasks that the page's script needs, as JSON.
std::string page_data(const Run& run, const MapFrame& frame);

}  // namespace skein::report
