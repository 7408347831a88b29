// SPDX-License-Identifier: Apache-2.0
// The drawing with the common time axis, built from the top downwards by its panels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "page/views.hpp"

namespace skein::report {

/// The paper that the panels write on, each at `y`, which it then moves below itself.
/// The page's script zooms the time axis by rewriting x of what stands in `plot`: rectangles,
/// lines, texts, and groups of the class "at" (which it moves); paths stand in a group "stretch".
struct Sheet {
  static constexpr double kWidth = 1232.0;
  static constexpr double kLeft = 132.0;
  static constexpr double kRight = 1218.0;

  explicit Sheet(const Run& r) : run(r), x{r.story.time.from, r.story.time.to, kLeft, kRight} {}

  const Run& run;
  Axis x;         ///< mission time to pixels
  Markup labels;  ///< left of the plot
  Markup under;   ///< the plot's lower layer: messages, hidden by what stands on it
  Markup plot;
  double y = 0.0;
  std::map<std::string, double> rails;  ///< of each node: where its messages start and arrive

  /// The panel's name above its left edge.
  void heading(std::string_view text);
  /// Of a row, left of it; cut where it is long.
  void row_name(double base_line, const std::string& text);
  void gutter(double base_line, std::string_view text, std::string_view style);
  /// A horizontal bar over a span of time, at least 0.6 px long.
  void bar(const Span& span, double top, double height, std::string_view style);
  /// A mark at an instant, drawn around (0, 0); left open for its title and content.
  void open_mark(double t, double height, std::string_view style);
};

/// Requests and commands of the ground station.
void draw_ground_row(Sheet& sheet);
/// One group of rows per UAV: its rail with marks, then its tasks.
void draw_uav_rows(Sheet& sheet);
/// Synchronisations and messages between the rails.
void draw_arrows(Sheet& sheet);
/// Who goes on only after another has come, or left its air, from rail to rail, with their slack.
void draw_external_arcs(Sheet& sheet);
/// What UAVs told each other of their plans, from rail to rail.
void draw_temporal_messages(Sheet& sheet);
/// Roles and blocks of joint tasks by UAV, and violations of their constraints.
void draw_joint_rows(Sheet& sheet);
/// Who owned each task of the team when, and why.
void draw_team_rows(Sheet& sheet);
/// Who waited for the air of a way, for whom, and who had it.
void draw_air_rows(Sheet& sheet);
/// When who waits for others was told that they come.
void draw_meeting_rows(Sheet& sheet);
void draw_links(Sheet& sheet);
/// Altitude, energy, separation.
void draw_profiles(Sheet& sheet);

/// A task bar's place among the rows of its UAV.
struct PlacedBar {
  const TaskBar* bar = nullptr;
  std::size_t lane = 0;
};

/// The least lanes, from the top, such that no two bars of a lane touch; `labels` also keeps the
/// room that a label needs after its bar. Bars must be in the order of their beginnings.
/// With `active_only` what was merely scheduled takes no room.
std::vector<PlacedBar> pack(const std::vector<const TaskBar*>& bars, const Axis& x,
                            bool active_only);

/// "12 goto"
std::string bar_label(const TaskBar& bar);

inline constexpr double kBarFont = 10.0;

}  // namespace skein::report
