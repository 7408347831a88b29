// SPDX-License-Identifier: Apache-2.0
// A motion that waits for its air.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bus.hpp"
#include "merging/airways.hpp"
#include "skein/merging/merger.hpp"

namespace skein::decision_node {

inline constexpr Duration kSaidAgain = Duration::milliseconds(10'000);
/// A motion that waits for others to leave looks for a way around them so often.
inline constexpr Duration kLooksAround = Duration::milliseconds(15'000);

struct Waiting {
  functional::Request request;
  MissionTime since;
  MissionTime said;  ///< when the executive was last told that the motion will come
  Airways airways;   ///< asked for; empty: nothing is asked for yet, or it is to be asked again
  /// Since when it asks for `airways` to get out of the way, before it wants its own.
  std::optional<MissionTime> aside_since = {};
  merging::Volumes own_air = {};  ///< wanted afterwards, as far as is known
  std::vector<std::string> waits_for;
  bool was_aside = false;    ///< the vehicle has got out of the way
  bool asked_long = false;   ///< at the last request the motion had waited long
  MissionTime looks_around;  ///< no search for a way around those who have its air before this
  bool comes_back = false;   ///< asks for the way back to where the vehicle got out of the way
  /// Asks for a place aside for the sake of another UAV, and wants nothing afterwards.
  bool makes_room = false;
  MissionTime noted;  ///< when `noted_for` was journaled
  std::vector<std::string> noted_for;
  std::vector<std::string> in_its_way, noted_way;  ///< of these, those who have to leave first
  /// Until then it does not come back to where others want to go, who could not while it was there.
  std::optional<MissionTime> gives_way_until = {};
  std::string why_not;  ///< the vehicle cannot do it, as it seemed at the last look

  /// So long that a role's motion asks for higher ways.
  bool is_long(MissionTime now) const;
  /// When it asks for higher ways too; nothing: it is no role's, or has asked.
  std::optional<MissionTime> rises_from() const;
  /// When it looks for a way around; nothing: it does not ask for what it is to fly.
  std::optional<MissionTime> looks_around_from() const;
  /// When it no longer asks for a place aside.
  std::optional<MissionTime> aside_until() const;

  /// Nothing can be asked for, as the vehicle cannot do it, it seems.
  void cannot(const std::string& why);
  /// Nothing is asked for until it is looked at again.
  void ask_later();
  /// Whom it waits for; while it asks to get out of the way: for the air that it wants afterwards.
  void wait_for(const merging::Waits& waits);
  /// Journals a state of the motion; with `airway`: the air that it got, else for whom it waits.
  void note(Bus& bus, const std::string& state, const Airway* airway) const;
  /// Journals for whom it waits if that changed: at once when others stand in its way, other
  /// reasons not more often than every kSaidAgain.
  void note_waits(Bus& bus);
};

Waiting waiting_since(MissionTime now, functional::Request request);

}  // namespace skein::decision_node
