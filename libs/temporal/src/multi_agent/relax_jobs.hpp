// SPDX-License-Identifier: Apache-2.0
// DIP-L: the relaxations under way at one agent.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "skein/temporal/message.hpp"

namespace skein::temporal {

/// A job is opened by a batch of local relaxations or by a RELAX received; it waits for one RELAXED
/// for each (frontier node, bound, sharer) it had to send RELAX for. Source: notes 5.2.
class RelaxJobs {
 public:
  /// The RELAX to answer when the job closes.
  struct Origin {
    AgentIndex agent;
    Relax request;
  };
  struct Wait {
    NodeIndex node;
    Bound bound;
    AgentIndex agent;
    auto operator<=>(const Wait&) const = default;
  };

  /// The name of the next job to open.
  JobId next() const { return last_ + 1; }
  /// Precondition: `waits` is not empty.
  void open(std::optional<Origin> origin, std::set<Wait> waits);
  bool ever_opened(JobId job) const { return job != 0 && job <= last_; }
  bool none_open() const { return jobs_.empty(); }

  /// Handles a RELAXED. Returns the origin if this closes a job that has one.
  std::optional<Origin> close(JobId job, const Wait& wait);

  /// Begins a new session with a peer: drops the answers owed to it, and returns the RELAX messages
  /// to send to it again.
  std::vector<Relax> begin_session(AgentIndex peer);

 private:
  struct Job {
    std::optional<Origin> origin;
    std::set<Wait> waits;
  };
  std::map<JobId, Job> jobs_;
  JobId last_ = 0;
};

}  // namespace skein::temporal
