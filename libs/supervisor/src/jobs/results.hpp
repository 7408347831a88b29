// SPDX-License-Identifier: Apache-2.0
// Applies results of jobs: adopts a plan, or reports that there is none.
#pragma once

#include <string>
#include <vector>

#include "book/own_goals.hpp"
#include "commitment/committer.hpp"
#include "jobs/agenda.hpp"
#include "watch/true_goals.hpp"

namespace skein::supervisor {

/// For jobs whose premises hold. Lifetime: refers to its Rooms.
class Results {
 public:
  struct Rooms {
    const Beliefs& beliefs;
    OwnGoals& own_goals;
    TrueGoals& true_goals;
    Dates& dates;
    Committer& committer;
    Agenda& agenda;
    Outbox& out;
    Book& book;
  };
  explicit Results(const Rooms& rooms);

  void finish(const Job& job, const InsertionOutcome& outcome);
  void finish(const Job& job, const RepairOutcome& outcome);
  /// Reports the outcome; the plan is not adopted.
  void answer_evaluation(const Job& job, const InsertionOutcome& outcome);

 private:
  MissionTime now() const { return out_.now(); }
  void refuse(const Job& job, const std::vector<std::string>& reasons,
              const std::vector<Dropped>& culprits = {}, const std::string& proposal = {});
  void leave_out(const std::vector<Dropped>& dropped);
  bool is_tried_in_parts(const Job& job, const InsertionOutcome& outcome,
                         mission::Placement placement);
  mission::MissionEstimate estimate(const Evaluation& evaluation,
                                    const InsertionOutcome& outcome) const;
  std::string parts_of(const Premises& premises) const;
  void enter_parts(const std::vector<mission::HighLevelTask>& order);
  void fail_safely(const Job& job, const std::vector<std::string>& reasons);
  static std::string fault_of(const Premises& premises, const mission::ElementaryPlan& plan);
  bool fits_now(const Premises& premises, const mission::ElementaryPlan& plan);
  void adopt(const Premises& premises, const mission::ElementaryPlan& plan,
             const std::vector<mission::HighLevelTask>& order);
  void tell_refined(const Job& job, const mission::ElementaryPlan& plan);
  void tell_landing(const mission::ElementaryPlan& plan);

  const Beliefs& beliefs_;
  OwnGoals& own_goals_;
  TrueGoals& true_goals_;
  Dates& dates_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
};

}  // namespace skein::supervisor
