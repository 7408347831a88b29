// SPDX-License-Identifier: Apache-2.0
// The dates of the plan by its network, and the promised dates.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "book/book.hpp"
#include "schedule/plan_network.hpp"

namespace skein::supervisor {

/// Keeps the network of all tasks that count (Book::counts), and writes its dates into the book.
/// Lifetime: refers to the book.
class Dates {
 public:
  /// `grace`: how much later than foreseen a task may start or end.
  Dates(Book& book, Duration grace) : book_(book), grace_(grace) {}

  void update(MissionTime now);
  /// Whether the network is controllable if `plan` replaces the tasks that are not in hand, and
  /// `withdrawn`. If so, the network is that of the plan from now on; else update() must follow.
  bool fits(const mission::ElementaryPlan& plan, const std::set<TaskId>& withdrawn,
            MissionTime now);
  const Schedule& schedule() const { return network_.schedule(); }
  bool controllable() const { return schedule().controllable; }
  /// Why the plan may, but need not, fail because of partners; empty: it holds whatever they do.
  const std::string& risk() const { return risk_; }
  /// The part of the network that partners need to know; `all`: with its inner nodes.
  temporal::Frontier frontier(bool all) const;
  /// Increases whenever the network changes.
  std::uint64_t version() const { return version_; }
  /// "ends between 352 s and 356.1 s".
  std::string extent() const;

  /// The holds of the task, without those on tasks that the executive does not have.
  std::vector<Hold> holds_of(TaskId task) const;
  /// Updates the holds of tasks that the executive has and has not started, by the network, and no
  /// longer than their windows. Returns the tasks whose holds must be sent to the executive: not
  /// those without holds now, since it may be starting them at this instant.
  std::vector<TaskId> renew_holds(MissionTime now);

  void promise();
  bool keeps_promises(Duration tolerance) const;

  /// Tasks that should have ended, or else started, by now; each is reported once.
  struct Slips {
    std::string what;          ///< "task 12 overdue by 3 s; …"; empty when there are none
    std::vector<TaskId> late;  ///< not started in time; empty if a task is overdue
  };
  Slips slips(MissionTime now);
  /// Marks `late` as reported; new promises would otherwise reset that.
  void keep_told(const std::vector<TaskId>& late);
  /// The next instant at which a task slips, of those after `now`.
  std::optional<MissionTime> next_slip(MissionTime now) const;

 private:
  std::vector<TaskView> open_views() const;
  std::vector<PlanOrder> orders() const;
  std::optional<TaskId> next_motion() const;
  /// Builds the network of these tasks with the least reliance on partners, up to `most`, that
  /// makes it controllable. Returns what breaks with none.
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
