// SPDX-License-Identifier: Apache-2.0
// Reports on the tasks that a team auctions, from the event log.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "skein/journal/record.hpp"

namespace skein::journal {
struct Written;
namespace lines {
struct Bid;
struct GlobalMission;
struct Owner;
struct TeamTask;
}  // namespace lines
}  // namespace skein::journal

namespace skein::laws {

/// The work of a UAV on a task of its team, from its report that it began.
struct TeamWork {
  std::string uav;
  std::int64_t sale = 0;
  std::int64_t goal = 0;
  double begun = 0;
  double over = std::numeric_limits<double>::infinity();
  std::string end;  ///< "done", "put-back"; empty while it goes on
  std::string why;
};

/// The standing of a task in the team's book, as the ground station knew it.
struct TeamStanding {
  double at = 0;
  std::string stage;
  std::string owners;  ///< with commas
  std::int64_t sale = 0;
  std::string why;
};

struct TeamTask {
  std::vector<TeamWork> works;
  std::vector<TeamStanding> standings;
  /// By the number of the sale: which UAVs told their bid in it, or why none, and when.
  std::map<std::int64_t, std::map<std::string, double>> bids;
};

struct TeamHistory {
  std::map<std::int64_t, TeamTask> tasks;
  std::vector<double> given;  ///< when global missions were given [s]
  std::vector<double> done;   ///< when global missions were completed [s]

  /// Takes a record, if it is of these kinds. False: it is of these kinds and cannot be read.
  bool see(const journal::Record& record);
  void hear(const journal::lines::TeamTask& line, const journal::Written& when);
  void hear(const journal::lines::Owner& line, const journal::Written& when);
  void hear(const journal::lines::Bid& line, const journal::Written& when);
  void hear(const journal::lines::GlobalMission& line, const journal::Written& when);
};

}  // namespace skein::laws
