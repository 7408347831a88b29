// SPDX-License-Identifier: Apache-2.0
// The drawing with the common time axis, built from the top downwards by its panels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "page/views.hpp"

namespace skein::report {

/// The drawing to which the panels add themselves. Each panel begins at `y` and moves `y` to its
/// lower end.
/// The page's script zooms the time axis by rewriting the x of rectangles, lines, texts, and groups
/// of the class "at" in `plot`; paths have to be in a group of the class "stretch".
struct Sheet {
  static constexpr double kWidth = 1232.0;
  static constexpr double kLeft = 132.0;
  static constexpr double kRight = 1218.0;

  explicit Sheet(const Run& r) : run(r), x{r.story.time.from, r.story.time.to, kLeft, kRight} {}

  const Run& run;
  Axis x;         ///< mission time to pixels
  Markup labels;  ///< left of the plot
  Markup under;   ///< the plot's lower layer, below `plot`: messages
  Markup plot;
  double y = 0.0;
  std::map<std::string, double> rails;  ///< of each node: where its messages start and arrive

  /// The panel's name above its left edge.
  void heading(std::string_view text);
  /// The name of a row, left of the plot; shortened if it is long.
  void row_name(double base_line, const std::string& text);
  void gutter(double base_line, std::string_view text, std::string_view style);
  /// A horizontal bar over a span of time, at least 0.6 px long.
  void bar(const Span& span, double top, double height, std::string_view style);
  /// Opens a group at an instant for a mark drawn around (0, 0); the caller adds title and content
  /// and closes it.
  void open_mark(double t, double height, std::string_view style);
};

/// Requests and commands of the ground station.
void draw_ground_row(Sheet& sheet);
/// One group of rows per UAV: its rail with marks, then its tasks.
void draw_uav_rows(Sheet& sheet);
/// Synchronisations and messages between the rails.
void draw_arrows(Sheet& sheet);
/// Executed external arcs (external_arcs.hpp) with their slack, from rail to rail.
void draw_external_arcs(Sheet& sheet);
/// Temporal messages (frontiers of plans) between UAVs, from rail to rail.
void draw_temporal_messages(Sheet& sheet);
/// Roles and blocks of joint tasks by UAV, and violations of their constraints.
void draw_joint_rows(Sheet& sheet);
/// Owners of each task of the team over time, with the reasons.
void draw_team_rows(Sheet& sheet);
/// Reservations of air by UAV: waits, with the peers waited for, and grants.
void draw_air_rows(Sheet& sheet);
/// Expected arrivals of the partners that each UAV waits for, as known over time.
void draw_meeting_rows(Sheet& sheet);
void draw_links(Sheet& sheet);
/// Altitude, energy, separation.
void draw_profiles(Sheet& sheet);

/// A task bar's place among the rows of its UAV.
struct PlacedBar {
  const TaskBar* bar = nullptr;
  std::size_t lane = 0;
};

/// Assigns each bar to the first lane from the top where neither it nor the label beside it touches
/// another; with `active_only` without the scheduled part of bars. Precondition: bars are in the
/// order of their starts.
std::vector<PlacedBar> pack(const std::vector<const TaskBar*>& bars, const Axis& x,
                            bool active_only);

/// "12 goto"
std::string bar_label(const TaskBar& bar);

inline constexpr double kBarFont = 10.0;

}  // namespace skein::report
