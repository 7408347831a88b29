// SPDX-License-Identifier: Apache-2.0
// Goals that need no tasks, since what they ask for is true when their turn comes.
#pragma once

#include "jobs/situations.hpp"
#include "watch/contingencies.hpp"

namespace skein::supervisor {

/// Lifetime: refers to its arguments.
class TrueGoals {
 public:
  TrueGoals(const Situations& situations, const Beliefs& beliefs, Contingencies& contingencies,
            const Agenda& agenda, Outbox& out, Book& book)
      : situations_(situations),
        beliefs_(beliefs),
        contingencies_(contingencies),
        agenda_(agenda),
        out_(out),
        book_(book) {}

  /// Of each free goal that the plan gives no tasks: where the vehicle is when its turn comes.
  void foresee();
  /// Its turn comes when all before it is settled: then it is achieved if it is true, else it needs
  /// tasks after all. What is counted from its end has its dates from then on.
  void settle();

 private:
  bool is_there(const Whereabouts& expected) const;

  const Situations& situations_;
  const Beliefs& beliefs_;
  Contingencies& contingencies_;
  const Agenda& agenda_;
  Outbox& out_;
  Book& book_;
};

}  // namespace skein::supervisor
