// SPDX-License-Identifier: Apache-2.0
#include "job_runner.hpp"

#include "skein/node/waker.hpp"

namespace skein::node {

namespace {

TimeIsUp clock_for(const StartJob& job) {
  if (job.at_most == Duration::max()) return {};
  return [from = Waker::steady_now(), job_time = job.at_most] {
    return Waker::steady_now() - from >= job_time;
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
    waiting_.push_back(std::move(job));
  }
  changed_.notify_one();
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
    lock.unlock();
    JobDone done{job.id, job.work(clock_for(job))};
    lock.lock();
    done_.push_back(std::move(done));
    lock.unlock();
    notify_();
    lock.lock();
  }
}

}  // namespace skein::node
