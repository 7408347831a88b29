// SPDX-License-Identifier: Apache-2.0
// Goals that need no tasks, since they are true already when their turn comes.
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

  /// Sets Goal::true_at of each free goal without tasks: the vehicle's place when its turn comes.
  void foresee();
  /// Settles such goals when all goals before them are settled: achieved if the vehicle is at the
  /// expected place, else they need tasks after all. Bounds counted from their ends are dated then.
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
