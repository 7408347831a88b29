// SPDX-License-Identifier: Apache-2.0
// The temporal agent of a UAV: keeps its plan consistent in time with the plans of others.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "component.hpp"
#include "skein/temporal/algorithm.hpp"
#include "skein/temporal/team_dates.hpp"

namespace skein::decision_node {

class Core;

/// Sends the changes of its plan's temporal network to others, receives theirs, and tells the
/// supervisor when partners come to meetings. The algorithm decides what is sent to whom: the
/// frontier to every UAV (DIP-M); the whole network to every UAV (DIP-G), or to the ground station,
/// which sends the arrivals of others (CIP); this UAV's own arrivals, to each partner those that
/// concern it (DIP-L). Each message is a complete state, so after a cut or restart the last one is
/// enough. A UAV out of reach is assumed to keep to its last message. Source: spec 5.3;
/// docs/decisions/0021-meetings.md, 0032-consistency-on-the-wire.md.
class Meetings final : public Component {
 public:
  explicit Meetings(Core& core);

  /// The frontier of this UAV's plan changed.
  void said(const temporal::Frontier& frontier);
  void hear(const FrontierTold& told);
  void contact(const Contact& contact);

  /// Since when the plan of a UAV has no such meeting, as far as it has said (mission time zero: it
  /// never had); absent: it has, or the algorithm does not tell.
  std::optional<MissionTime> stays_away_since(const std::string& uav,
                                              temporal::MeetingId meeting) const;

  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  using Dates = std::map<temporal::MeetingId, temporal::PartnerDates>;
  bool keeps_to(temporal::Algorithm algorithm) const;
  /// Whether each other UAV gets what this one plans (DIP-M, DIP-G).
  bool tells_all() const;
  void reach(const std::string& peer, bool reachable);
  void tell_dates();
  void look();
  void note_dropped(const std::string& uav, const temporal::Frontier& before,
                    const temporal::Frontier& after);
  void let_circles_stand(Dates& dates);
  void note(const Dates& dates);

  Core& core_;
  temporal::TeamDates team_;
  Dates told_;  ///< the arrivals last told to the supervisor
  /// UAVs that were in reach once. Others are told nothing: what is said now they hear when they
  /// are.
  std::set<std::string> met_;
  std::optional<temporal::Frontier> said_;  ///< last told to all of those (DIP-M, DIP-G)
  /// The last message to a UAV (DIP-L), when it was sent, and whether it is outdated.
  struct Told {
    temporal::Frontier word = {};
    std::optional<MissionTime> at = {};
    bool more = false;
  };
  std::map<std::string, Told> words_;
  /// Meetings at which both wait for each other, since when; messages may still be under way.
  std::map<temporal::MeetingId, MissionTime> circles_;
  /// UAVs back in reach, since when; they may not have sent yet what changed meanwhile.
  std::map<std::string, MissionTime> back_;
  std::optional<MissionTime> looked_;
  /// When meetings were first missing in the plans of others that had had them.
  std::map<std::string, std::map<temporal::MeetingId, MissionTime>> dropped_;
};

}  // namespace skein::decision_node
