// SPDX-License-Identifier: Apache-2.0
// Random generation of missions.
#pragma once

#include <cstdint>
#include <string_view>

#include "skein/mission_lab/mission.hpp"

namespace skein::mission_lab {

/// The kinds of content that may be drawn.
struct Kinds {
  bool faults = true;     ///< slow, aborted, dead sensors, less energy than believed
  bool air = true;        ///< closed air: from the start, and while they fly, around them too
  bool deadlines = true;  ///< times of high-level tasks
  bool changes = true;    ///< cancellations and urgent missions that interrupt
  bool degrees = true;    ///< autonomy degrees change and come back
  bool radio = true;      ///< cuts
  bool energy = true;     ///< starts with little of it
  bool alarms = true;     ///< fires, and missions that refer to the alarm
  bool questions = true;  ///< a mission is first evaluated, and then given
  bool deaths = false;  ///< daemons are killed and restart; functional layers may lose their state
  bool joint = true;    ///< joint tasks of two UAVs that observe a place
  bool merged = true;   ///< UAVs with crossing paths use plan merging
  /// Algorithm of temporal consistency between UAVs that meet: `planning: consistency:` of
  /// scenarios.
  std::string_view consistency = "dip-m";
  bool gatherings = false;  ///< among their meetings a joint task of two of them
  bool orders = false;      ///< they fly at one height, and merge their ways
  bool sweeps = false;      ///< of UAVs whose ways cross some map or search what lies in the middle
  bool minds = false;       ///< of anything: people change theirs, in every order
  bool busy = false;        ///< of anything: an operator flies by hand in the middle of tasks
};
/// Missions without faults, in which all requests are possible.
inline constexpr Kinds kClean{false, false, false, false, false, false,
                              false, true,  true,  false, true,  true};

/// Draws a mission; deterministic for a seed and kinds.
Mission generate(std::uint64_t seed, const Kinds& kinds);
/// Likewise a team at degree 5 that is given a global mission; of the kinds, radio, deaths, degrees
/// and faults count.
Mission generate_team(std::uint64_t seed, const Kinds& kinds);
/// Likewise two to eight UAVs at degree 4 whose ways cross, with wind, some from shared pads; of
/// the kinds, radio, deaths, merged and sweeps count.
Mission generate_crossing(std::uint64_t seed, const Kinds& kinds);
/// Likewise two to four UAVs at degree 4 that search or map areas beside or over each other for
/// minutes, most at one height, and up to two that fly through; of the kinds, radio, deaths and
/// merged count.
Mission generate_sweeps(std::uint64_t seed, const Kinds& kinds);
/// Likewise two to five UAVs at degree 4 that meet each other, with wind; of the kinds, deadlines,
/// radio, deaths, faults (two who wait for each other for ever), consistency, gatherings and orders
/// count.
Mission generate_meetings(std::uint64_t seed, const Kinds& kinds);
/// Likewise two to six vehicles at degree 4 of which at least one keeps to the ground, among hills
/// that not all of them climb; some meet. Of the kinds, air, deadlines, changes, degrees, radio,
/// energy, deaths and faults count.
Mission generate_robots(std::uint64_t seed, const Kinds& kinds);
/// Likewise two to six UAVs at degree 4 of which at least one is heard past relays alone, with
/// meetings of two; of the kinds, radio (links between them are cut for a while) and deaths count.
Mission generate_relays(std::uint64_t seed, const Kinds& kinds);
/// Likewise two or three UAVs at degree 4 with joint tasks and synchronisations, of whom one is cut
/// off, or, with deaths, dies for good (and may be declared lost) or for a while, or is not given
/// the synchronisation; of the kinds, radio, deaths and changes count.
Mission generate_partners(std::uint64_t seed, const Kinds& kinds);
/// Likewise two to four UAVs at degree 4 that map one or two areas together, of whom one may be cut
/// off, die, be taken in hand, not take part, or have them in another order; of the kinds, radio,
/// deaths, degrees, changes, air, faults, energy and merged count.
Mission generate_sharing(std::uint64_t seed, const Kinds& kinds);
/// Likewise two to four UAVs that watch, escort or pursue something together by any of the shipped
/// interaction models but that of mapping, while it moves; for one of them, at degree 2, the ground
/// station may play. Of the kinds, radio, deaths, degrees, air, faults, energy and merged count.
Mission generate_escorts(std::uint64_t seed, const Kinds& kinds);
/// Likewise one to four UAVs at degree 4 over fires that spread in the wind: they look at the
/// fronts, which the ground station follows, map and search the ground around, and two of them may
/// watch a front jointly. Of the kinds, joint, alarms, radio, faults and deaths count.
Mission generate_fires(std::uint64_t seed, const Kinds& kinds);
/// Likewise one to four vehicles at degrees 1 to 3 that their operators fly by elementary tasks, at
/// times wrongly: before takeoff, under the ground, with conditions that never come true; they take
/// them in hand, change degrees, abort. Ways are merged in some. Of the kinds, changes (errors),
/// air, alarms, degrees, radio, faults, deaths and merged count.
Mission generate_orders(std::uint64_t seed, const Kinds& kinds);
/// Likewise one to four UAVs at degree 4 with tours, areas and places to look at, over which, over
/// their pads and on their ways air closes for a time: known before or, with the kind air, by an
/// operator in flight. Of the kinds, air, deadlines, radio, faults, energy, deaths and merged
/// count.
Mission generate_closures(std::uint64_t seed, const Kinds& kinds);
/// All of it at once: three to seven vehicles in the air and on the ground, some at degree 5 with a
/// global mission, the others at 4 with missions of their own, meetings and joint tasks, over fires
/// that spread, past relays, with ways that are merged or not, while operators take vehicles in
/// hand. All kinds but questions count.
Mission generate_mixed(std::uint64_t seed, const Kinds& kinds);
/// As somebody writes one who knows docs/scenario-format.md alone: two to six vehicles of all
/// kinds, a plane among them, at degrees 2 to 5 in one mission, from up to three homes, with little
/// energy, narrow or silent radio, air that closes and opens, operators and whatever else the
/// format offers. All kinds but questions count.
Mission generate_anything(std::uint64_t seed, const Kinds& kinds);

}  // namespace skein::mission_lab
