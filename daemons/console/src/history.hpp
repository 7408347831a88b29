// SPDX-License-Identifier: Apache-2.0
// History for the page, so that a page opened late shows the same as others.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <utility>

#include "feed.hpp"
#include "skein/blackboard/wire.hpp"
#include "skein/journal/record.hpp"

namespace skein::console {

/// Puts samples and records into the feed: the last of each value, the trail of each UAV, the
/// states of each task with their times. Bounded: kTrail points per UAV; states of tasks are
/// events.
class History {
 public:
  static constexpr std::size_t kTrail = 600;
  static constexpr double kStep = 4;  ///< [m] between two points of a trail

  void take(const wire::Sample& sample, Feed& feed);
  void take(const journal::Record& record, Feed& feed);

 private:
  void note_states(const wire::UavTasks& tasks, Feed& feed);
  void extend_trail(const std::string& uav, const wire::Vector3& at, Feed& feed);

  std::map<std::pair<std::string, std::uint64_t>, wire::TaskState> states_;
  std::map<std::string, std::deque<wire::Vector3>> trails_;
  std::uint64_t replies_ = 0;
};

}  // namespace skein::console
