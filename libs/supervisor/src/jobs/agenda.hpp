// SPDX-License-Identifier: Apache-2.0
// What is to be planned, and the one job that plans.
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
  bool in_parts = false;  ///< what is done in parts may be interrupted for it
};

/// A mission that is only to be evaluated.
struct Evaluation {
  mission::UnitMission mission;
  std::string cause;
  MissionTime since;
  bool in_parts = false;  ///< as of Pending
};

/// Something happened to the plan that needs planning.
struct Need {
  std::optional<GoalId> failed;
  bool refine = true;
  bool behind = false;  ///< refined behind the others, where it can be
  std::string cause;
  MissionTime since;
  int attempts = 0;
  bool home = false;  ///< even with nothing to plan: it must come down
  MissionTime not_before = {};
};

struct Job {
  std::uint64_t id = 0;
  std::optional<mission::MissionId> mission;  ///< an insertion; else a repair
  bool evaluation = false;                    ///< of a mission, that is not adopted
  Need need;
  Premises premises;
  std::optional<mission::HighLevelTask> retreat;  ///< a goal of its own, if nothing else serves
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
  /// The plan is being repaired, or is to be.
  bool repairing() const { return need_ || (job_ && !job_->mission); }
  bool repair_is_due() const { return !job_ && need_ && need_->not_before <= now(); }
  /// A job makes a plan that may be adopted.
  bool plans() const { return job_ && !job_->evaluation; }

  // ---- what is to be done ----

  /// A repair: of this goal, refined from here or left out, and of all that is free. What is needed
  /// already is needed for this cause too.
  void plan_anew(std::optional<GoalId> failed, bool refine, const std::string& cause);
  /// What failed is refined behind the others, where it can be.
  void put_behind();
  /// The repair must bring it down, if it flies, even with nothing to plan.
  void bring_down(bool flies);
  /// It need not be tried before.
  void pause_until(MissionTime at);
  /// No pause any more.
  void hurry();
  Need take_need();
  void forget_need() { need_.reset(); }
  void add(Pending mission) { pending_.push_back(std::move(mission)); }
  void add(Evaluation evaluation) { evaluations_.push_back(std::move(evaluation)); }
  /// Null: it does not wait.
  const Pending* find(mission::MissionId id) const;
  Pending take(mission::MissionId id);
  /// The one whose job is over.
  Evaluation take_evaluation();
  /// It is to be planned, or evaluated, once more, and what is done in parts may be interrupted for
  /// it. False: that was tried.
  bool try_in_parts(const Job& job);

  // ---- the job ----

  /// The number that the next one will have.
  std::uint64_t next_job() const { return last_job_ + 1; }
  void run(Job job, DeliberationRequest request);
  /// What it says when it comes back counts for nothing.
  void abandon_job();
  /// A repair is not kept waiting by an insertion, nor either of them by an evaluation: these are
  /// begun again afterwards.
  void give_way();
  /// The job whose result has come. Nothing: nobody waits for it.
  std::optional<Job> finished(std::uint64_t id);
  /// It is to be made again. False when it was tried so often that its result counts as none.
  bool again(const Job& job, const std::string& why);
  /// Nothing is to be planned any more. Returns the missions that nobody will evaluate.
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
