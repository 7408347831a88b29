// SPDX-License-Identifier: Apache-2.0
// The UAV's part in keeping plans consistent in time between UAVs.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "component.hpp"
#include "skein/temporal/algorithm.hpp"
#include "skein/temporal/team_dates.hpp"

namespace skein::decision_node {

class Core;

/// The temporal agent: it tells others of the network of its plan when that changed, hears of
/// theirs, and tells the supervisor when those come whom its UAV is to meet. What is told, and to
/// whom, is by the algorithm: the frontier to every UAV (DIP-M), the whole network to every UAV
/// (DIP-G) or to the ground station, which tells when others come (CIP), or when this one comes, to
/// each what concerns it (DIP-L). Each is a state: who was cut off, or restarted, hears the last
/// one. Who is out of reach is supposed to keep to what it said last. Source: spec 5.3;
/// docs/decisions/0021-meetings.md, 0032-consistency-on-the-wire.md.
class Meetings final : public Component {
 public:
  explicit Meetings(Core& core);

  /// Of the own plan.
  void said(const temporal::Frontier& frontier);
  void hear(const FrontierTold& told);
  void contact(const Contact& contact);

  void time_passes() override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  using Dates = std::map<temporal::MeetingId, temporal::PartnerDates>;
  bool keeps_to(temporal::Algorithm algorithm) const;
  void reach(const std::string& peer, bool reachable);
  void tell_dates();
  void look();
  void let_circles_stand(Dates& dates);
  void note(const Dates& dates);

  Core& core_;
  temporal::TeamDates team_;
  Dates told_;  ///< to the supervisor
  /// What another was told last (DIP-L), when, and whether there is more to tell since.
  struct Told {
    temporal::Frontier word = {};
    std::optional<MissionTime> at = {};
    bool more = false;
  };
  std::map<std::string, Told> words_;
  /// Since when each waits for the other there: words may be on their way.
  std::map<temporal::MeetingId, MissionTime> circles_;
  /// In reach again since then: what it did meanwhile it may not have told yet.
  std::map<std::string, MissionTime> back_;
  std::optional<MissionTime> looked_;
};

}  // namespace skein::decision_node
