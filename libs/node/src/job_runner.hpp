// SPDX-License-Identifier: Apache-2.0
// Runs a node's jobs in a thread of their own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "skein/node/node.hpp"

namespace skein::node {

/// Runs jobs in one thread, in order of arrival. `submit` and `take_done` are for the daemon's
/// loop; `notify` is called from the job thread after each job. Destruction waits for the running
/// job and drops the waiting ones.
class JobRunner {
 public:
  explicit JobRunner(std::function<void()> notify);
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;
  ~JobRunner();

  void submit(StartJob job);
  /// Makes the clock of a running or waiting job say that its time is up. Unknown id: no effect.
  void stop(std::uint64_t id);
  std::vector<JobDone> take_done();

 private:
  void work();

  std::function<void()> notify_;
  std::mutex mutex_;  ///< guards the five below
  std::condition_variable changed_;
  std::deque<StartJob> waiting_;
  std::vector<JobDone> done_;
  std::map<std::uint64_t, std::shared_ptr<std::atomic<bool>>>
      stopped_;  ///< stop flags of the jobs that are not done
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace skein::node
