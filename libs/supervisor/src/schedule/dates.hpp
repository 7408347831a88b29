// SPDX-License-Identifier: Apache-2.0
// The dates of the plan, as its network has them, and what was promised of them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "book/book.hpp"
#include "schedule/plan_network.hpp"

namespace skein::supervisor {

/// Keeps the network of all that counts in the book, and writes its dates there. Lifetime: refers
/// to the book.
class Dates {
 public:
  /// `grace`: how long beyond what was foreseen a task may start or end.
  Dates(Book& book, Duration grace) : book_(book), grace_(grace) {}

  void update(MissionTime now);
  /// Whether a plan in place of what is not in hand, and of `withdrawn`, can be kept to. If so the
  /// network is that of the plan from here on, else the dates are to be made anew.
  bool fits(const mission::ElementaryPlan& plan, const std::set<TaskId>& withdrawn,
            MissionTime now);
  const Schedule& schedule() const { return network_.schedule(); }
  bool controllable() const { return schedule().controllable; }
  /// Why the plan may fail because of others though it need not; empty: it keeps whatever they do.
  const std::string& risk() const { return risk_; }
  /// What others need to know of the plan; `all`: with its inner nodes.
  temporal::Frontier frontier(bool all) const;
  /// Another one: the network changed.
  std::uint64_t version() const { return version_; }
  /// "ends between 352 s and 356.1 s".
  std::string extent() const;

  /// As the executive may be told of them: what it does not know cannot be waited for.
  std::vector<Hold> holds_of(TaskId task) const;
  /// What the executive has and has not started is held back as the network says now, and no longer
  /// than its window. Returns the
  /// tasks of which it must be told so: not those that nothing holds back any more, since it may be
  /// starting them at this very instant.
  std::vector<TaskId> renew_holds(MissionTime now);

  void promise();
  bool keeps_promises(Duration tolerance) const;

  /// Tasks that should have ended, or else started, by now; each is told once.
  struct Slips {
    std::string what;          ///< "task 12 overdue by 3 s; …"; empty when there are none
    std::vector<TaskId> late;  ///< not started in time, where nothing is overdue
  };
  Slips slips(MissionTime now);
  /// What is promised anew counts as in time: these were told of all the same.
  void keep_told(const std::vector<TaskId>& late);
  /// The next instant at which a task slips, of those after `now`.
  std::optional<MissionTime> next_slip(MissionTime now) const;

 private:
  std::vector<TaskView> open_views() const;
  std::vector<PlanOrder> orders() const;
  std::optional<TaskId> next_motion() const;
  /// The network of these, with as little reliance on others as it can be kept with.
  std::string rely(std::vector<TaskView> views, Meetings::Reliance most, MissionTime now);
  bool is_overdue(const Entry& entry, MissionTime now) const;
  bool is_wider(const Entry& entry, MissionTime now) const;
  bool is_late(const Entry& entry, MissionTime now) const;
  MissionTime late_from(const Entry& entry) const;
  MissionTime end_foreseen(const Entry& entry) const;

  Book& book_;
  Duration grace_;
  PlanNetwork network_;
  std::string risk_;
  std::uint64_t version_ = 0;
};

}  // namespace skein::supervisor
