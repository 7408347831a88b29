// SPDX-License-Identifier: Apache-2.0
#include "jobs/agenda.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::supervisor {

namespace {

constexpr int kManyAttempts = 5;

template <class Missions>
auto found_in(Missions& pending, mission::MissionId id) {
  return std::find_if(pending.begin(), pending.end(),
                      [&](const Pending& one) { return one.id == id; });
}

}  // namespace

// ---- what is to be done ----

void Agenda::plan_anew(std::optional<GoalId> failed, bool refine, const std::string& cause) {
  if (!need_) {
    need_ = Need{failed, refine, false, cause, now(), 0, false, now()};
    return;
  }
  hurry();
  need_->cause += "; " + cause;
  if (need_->failed || !failed) return;
  need_->failed = failed;
  need_->refine = refine;
}

void Agenda::put_behind() {
  if (need_) need_->behind = true;
}

void Agenda::bring_down(bool flies) {
  if (need_) need_->home = flies;
}

void Agenda::pause_until(MissionTime at) {
  if (need_) need_->not_before = at;
}

void Agenda::hurry() { pause_until(now()); }

Need Agenda::take_need() {
  SKEIN_EXPECTS(need_.has_value());
  return *std::exchange(need_, std::nullopt);
}

const Pending* Agenda::find(mission::MissionId id) const {
  const auto found = found_in(pending_, id);
  return found == pending_.end() ? nullptr : &*found;
}

Pending Agenda::take(mission::MissionId id) {
  const auto found = found_in(pending_, id);
  SKEIN_EXPECTS(found != pending_.end());
  Pending result = std::move(*found);
  pending_.erase(found);
  return result;
}

Evaluation Agenda::take_evaluation() {
  SKEIN_EXPECTS(!evaluations_.empty());
  Evaluation result = std::move(evaluations_.front());
  evaluations_.pop_front();
  return result;
}

// ---- the job ----

void Agenda::run(Job job, DeliberationRequest request) {
  job.id = ++last_job_;
  auto shared = std::make_shared<const DeliberationRequest>(std::move(request));
  out_.add(StartDeliberation{job.id, std::move(shared)});
  job_ = std::move(job);
}

void Agenda::abandon_job() {
  out_.add(StopDeliberation{job_->id});
  abandoned_.insert(job_->id);
  job_.reset();
}

void Agenda::give_way() {
  if (!job_ || !job_->mission) return;
  if (need_ || (job_->evaluation && !pending_.empty())) abandon_job();
}

std::optional<Job> Agenda::finished(std::uint64_t id) {
  if (abandoned_.erase(id) != 0) return std::nullopt;
  if (!job_ || job_->id != id) {
    out_.notice("result of job " + std::to_string(id) + ", which nobody waits for");
    return std::nullopt;
  }
  return std::exchange(job_, std::nullopt);
}

bool Agenda::again(const Job& job, const std::string& why) {
  int attempts = 0;
  if (job.mission) {
    const auto one = found_in(pending_, *job.mission);
    if (one != pending_.end()) attempts = ++one->attempts;
  } else {
    Need merged = job.need;
    if (need_) {
      merged.cause += "; " + need_->cause;
      if (!merged.failed) merged.refine = need_->refine;
      if (!merged.failed) merged.behind = need_->behind;
      if (!merged.failed) merged.failed = need_->failed;
      merged.home = merged.home || need_->home;
      merged.not_before = need_->not_before;
    }
    attempts = ++merged.attempts;
    need_ = std::move(merged);
  }
  if (attempts > kManyAttempts) {
    out_.notice("job " + std::to_string(job.id) + " is made again for the " +
                std::to_string(attempts) + "th time: " + why);
  }
  return attempts <= kManyAttempts;
}

bool Agenda::try_in_parts(const Job& job) {
  bool* in_parts = nullptr;
  if (job.evaluation) {
    in_parts = &evaluations_.front().in_parts;
  } else if (const auto one = found_in(pending_, *job.mission); one != pending_.end()) {
    in_parts = &one->in_parts;
  }
  return in_parts != nullptr && !std::exchange(*in_parts, true);
}

std::deque<Evaluation> Agenda::clear() {
  if (job_) abandon_job();
  need_.reset();
  pending_.clear();
  return std::exchange(evaluations_, {});
}

}  // namespace skein::supervisor
