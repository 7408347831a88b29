// SPDX-License-Identifier: Apache-2.0
// The jobs of all nodes in virtual time.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "skein/foundation/random.hpp"
#include "skein/node/virtual_runtime.hpp"

namespace skein::node {

/// Jobs that are done when their time is over. As in a daemon, each node has two lanes, and a lane
/// does one job after the other. Thread rule: one thread at a time.
class VirtualJobs {
 public:
  /// One life of a node.
  struct Owner {
    std::string node;
    std::uint64_t incarnation = 0;
  };
  struct Done {
    Owner owner;
    JobDone done;
  };

  VirtualJobs(JobTimes times, std::uint64_t seed) : times_(times), seed_(seed) {}

  void submit(const Owner& owner, StartJob job, MissionTime now);
  /// Its time is up: from now on it takes the least time. Unknown job: no effect.
  void stop(const Owner& owner, std::uint64_t id, MissionTime now);
  /// When the next job is done.
  std::optional<MissionTime> next() const;
  /// The first of those that are done at `now`, in the order in which they end and were submitted.
  std::optional<Done> take_done(MissionTime now);

 private:
  using LaneId = std::tuple<std::string, std::uint64_t, bool>;  ///< node, incarnation, aside
  struct Queued {
    StartJob job;
    std::uint64_t number = 0;  ///< of all jobs
    Duration takes;
  };
  struct Lane {
    std::deque<Queued> jobs;  ///< the first one runs
    MissionTime ends;         ///< the first one
  };

  Duration drawn(const StartJob& job, const LaneId& lane);

  JobTimes times_;
  std::uint64_t seed_ = 0;
  std::uint64_t submitted_ = 0;
  std::map<LaneId, Lane> lanes_;     ///< those that have a job
  std::map<LaneId, Random> random_;  ///< of lanes whose jobs do not all take the same time
};

}  // namespace skein::node
