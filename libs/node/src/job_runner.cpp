// SPDX-License-Identifier: Apache-2.0
#include "job_runner.hpp"

#include "skein/node/waker.hpp"

namespace skein::node {

namespace {

/// Once it has said that the time is up, it says nothing else. `told` outlives it.
TimeIsUp clock_for(const StartJob& job, std::shared_ptr<const std::atomic<bool>> stopped,
                   JobClock& told) {
  told.given = true;
  return [from = Waker::steady_now(), at_most = job.at_most, stopped = std::move(stopped), &told] {
    told.ran_out = told.ran_out || stopped->load() || Waker::steady_now() - from >= at_most;
    if (!told.ran_out) ++told.questions;
    return told.ran_out;
  };
}

}  // namespace

JobRunner::JobRunner(std::function<void()> notify)
    : notify_(std::move(notify)), thread_([this] { work(); }) {}

JobRunner::~JobRunner() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void JobRunner::submit(StartJob job) {
  {
    const std::lock_guard lock(mutex_);
    stopped_[job.id] = std::make_shared<std::atomic<bool>>(false);
    waiting_.push_back(std::move(job));
  }
  changed_.notify_one();
}

void JobRunner::stop(std::uint64_t id) {
  const std::lock_guard lock(mutex_);
  const auto job = stopped_.find(id);
  if (job != stopped_.end()) job->second->store(true);
}

std::vector<JobDone> JobRunner::take_done() {
  const std::lock_guard lock(mutex_);
  return std::exchange(done_, {});
}

void JobRunner::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (stopping_) return;
    const StartJob job = std::move(waiting_.front());
    waiting_.pop_front();
    const auto stopped = stopped_.at(job.id);
    lock.unlock();
    JobDone done{job.id, {}};
    done.result = job.work(clock_for(job, stopped, done.clock));
    lock.lock();
    stopped_.erase(job.id);
    done_.push_back(std::move(done));
    lock.unlock();
    notify_();
    lock.lock();
  }
}

}  // namespace skein::node
