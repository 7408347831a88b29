// SPDX-License-Identifier: Apache-2.0
// Runs planning work as jobs, one at a time; repeats a job whose premises no longer hold.
#pragma once

#include "book/own_goals.hpp"
#include "jobs/agenda.hpp"
#include "jobs/results.hpp"
#include "jobs/situations.hpp"

namespace skein::supervisor {

/// Makes deliberation requests from the agenda, and takes their results. Lifetime: refers to its
/// Rooms.
class Jobs {
 public:
  struct Rooms {
    const Situations& situations;
    const Beliefs& beliefs;
    const OwnGoals& own_goals;
    Committer& committer;
    Results& results;
    Agenda& agenda;
    Outbox& out;
    Book& book;
  };
  explicit Jobs(const Rooms& rooms);

  /// Starts the most urgent work of the agenda, if no job runs.
  void start();
  void finished(const JobFinished& input);

 private:
  MissionTime now() const { return out_.now(); }
  void start_insertion(const Pending& pending);
  void start_evaluation(const Evaluation& evaluation);
  void start_repair();
  InsertionRequest insertion(const Premises& premises,
                             const std::vector<mission::HighLevelTask>& added,
                             mission::Placement placement, bool any) const;
  PlanningRequest base(const Standing& standing, const std::set<TaskId>& withdrawn) const;
  Premises premises_of_insertion(const Pending& pending) const;

  const Situations& situations_;
  const Beliefs& beliefs_;
  const OwnGoals& own_goals_;
  Committer& committer_;
  Results& results_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
};

}  // namespace skein::supervisor
