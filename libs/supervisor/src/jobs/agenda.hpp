// SPDX-License-Identifier: Apache-2.0
// The queue of planning work, and the job that runs.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "book/outbox.hpp"
#include "jobs/premises.hpp"

namespace skein::supervisor {

/// A mission that waits for its insertion.
struct Pending {
  mission::MissionId id;
  mission::Placement placement = mission::Placement::kBest;
  bool interrupt = false;
  bool any = false;
  std::string cause;
  MissionTime since;
  int attempts = 0;
  bool in_parts = false;  ///< a mapping under way may be interrupted between two parts for it
};

/// A mission that is only to be evaluated.
struct Evaluation {
  mission::UnitMission mission;
  std::string cause;
  MissionTime since;
  bool in_parts = false;  ///< as of Pending
};

/// The plan needs a repair.
struct Need {
  std::optional<GoalId> failed;
  bool refine = true;   ///< `failed` may be refined again
  bool behind = false;  ///< `failed` goes behind the other goals, if feasible
  std::string cause;
  MissionTime since;
  int attempts = 0;
  bool home = false;            ///< the UAV must land, even if there is no goal to plan
  MissionTime not_before = {};  ///< a pause after refusals
};

struct Job {
  std::uint64_t id = 0;
  std::optional<mission::MissionId> mission;  ///< to insert or evaluate; absent: a repair
  bool evaluation = false;                    ///< the resulting plan is not adopted
  Need need;                                  ///< of a repair
  Premises premises;
  std::optional<mission::HighLevelTask> retreat;  ///< the landing for RepairStep::kReturn
};

/// Missions to insert, missions to evaluate, at most one need of repair, at most one job. Lifetime:
/// refers to the outbox.
class Agenda {
 public:
  explicit Agenda(Outbox& out) : out_(out) {}

  const std::optional<Need>& needed() const { return need_; }
  const std::optional<Job>& job() const { return job_; }
  const std::deque<Pending>& pending() const { return pending_; }
  const std::deque<Evaluation>& evaluations() const { return evaluations_; }
  /// The plan is being repaired, or a repair is needed.
  bool repairing() const { return need_ || (job_ && !job_->mission); }
  bool repair_is_due() const { return !job_ && need_ && need_->not_before <= now(); }
  /// A job runs whose plan may be adopted.
  bool plans() const { return job_ && !job_->evaluation; }

  // ---- what is to be done ----

  /// Asks for a repair: `failed` is refined again from here or dropped, the free goals are planned
  /// anew. Merges with a repair that is needed already.
  void plan_anew(std::optional<GoalId> failed, bool refine, const std::string& cause);
  /// The needed repair puts the failed goal behind the others, if feasible.
  void put_behind();
  /// The needed repair must make the UAV land if it flies, even if there is no goal to plan.
  void bring_down(bool flies);
  /// The needed repair is not started before `at`.
  void pause_until(MissionTime at);
  /// Ends such a pause.
  void hurry();
  Need take_need();
  void forget_need() { need_.reset(); }
  void add(Pending mission) { pending_.push_back(std::move(mission)); }
  void add(Evaluation evaluation) { evaluations_.push_back(std::move(evaluation)); }
  /// The pending mission; null if it is not pending.
  const Pending* find(mission::MissionId id) const;
  Pending take(mission::MissionId id);
  /// Removes and returns the evaluation whose job is over.
  Evaluation take_evaluation();
  /// The job's mission is to be planned, or evaluated, once more with `in_parts`. False: it was
  /// tried so already.
  bool try_in_parts(const Job& job);

  // ---- the job ----

  /// The id of the next job.
  std::uint64_t next_job() const { return last_job_ + 1; }
  void run(Job job, DeliberationRequest request);
  /// Stops the job; its result will be ignored.
  void abandon_job();
  /// Abandons the job for more urgent work: an insertion for a repair, an evaluation for either of
  /// them. The abandoned job is started again afterwards.
  void give_way();
  /// The job whose result has come; absent if it was abandoned.
  std::optional<Job> finished(std::uint64_t id);
  /// Schedules the job's work again. False when it was attempted too often: then it counts as
  /// failed.
  bool again(const Job& job, const std::string& why);
  /// Drops all planning work. Returns the missions that will not be evaluated.
  std::deque<Evaluation> clear();

 private:
  MissionTime now() const { return out_.now(); }

  Outbox& out_;
  std::deque<Pending> pending_;
  std::deque<Evaluation> evaluations_;
  std::optional<Need> need_;
  std::optional<Job> job_;
  std::uint64_t last_job_ = 0;
  std::set<std::uint64_t> abandoned_;  ///< jobs whose results are still to come
};

}  // namespace skein::supervisor
