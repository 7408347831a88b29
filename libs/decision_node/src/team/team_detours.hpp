// SPDX-License-Identifier: Apache-2.0
// The detours that the UAV's bids count.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "skein/auction/catalogue.hpp"
#include "skein/decision_node/messages.hpp"
#include "team/team_craft.hpp"

namespace skein::decision_node {

/// Knows of which legs straight flights go through the ground or closed air, and has the ways
/// around planned in small jobs, one at a time. What is known is kept until the world changes, a
/// volume opens or closes, or an end of the leg has moved. Source: spec 6.2, 6.3;
/// docs/decisions/0085-bids-go-around.md.
class TeamDetours {
 public:
  /// Bids wait for the ways at most so long.
  static constexpr Duration kPatience = Duration::milliseconds(1'000);
  /// Legs of one job.
  static constexpr std::size_t kLegsOfAJob = 64;
  /// An end that has moved by less has not moved [m].
  static constexpr double kSamePlace = 30;

  /// Looks for legs whose detour is to be planned: between the UAV's place, the tasks of the lot
  /// and its landing place. Cost: O(tasks²).
  void want(const Vantage& at, const auction::Lot& lot);
  /// Whether the detours of all legs that were wanted are known.
  bool complete() const { return missing_.empty(); }
  /// The next job, for the legs that come first; none: there is nothing to plan, or a job runs.
  std::optional<StartDetours> next_job(const Vantage& at);
  /// A result of an earlier world has no effect.
  void planned(const DetoursPlanned& done);
  /// Of the last wanted legs, those with a detour or without a way.
  Detours known() const;

 private:
  struct Known {
    supervisor::StraightLeg leg;
    supervisor::Detour detour;
  };
  struct Air {
    std::shared_ptr<const world::World> world;
    std::vector<bool> closed;  ///< by volume
    bool operator==(const Air&) const = default;
  };
  struct Job {
    std::uint64_t number = 0;
    std::vector<std::pair<LegEnds, supervisor::StraightLeg>> legs;
  };

  void want(const Vantage& at, const TeamCraft& craft, LegEnds ends);

  Air air_;
  std::map<LegEnds, Known> known_;
  std::vector<std::pair<LegEnds, supervisor::StraightLeg>> missing_;
  std::optional<Job> job_;
  std::uint64_t jobs_ = 0;
};

}  // namespace skein::decision_node
