// SPDX-License-Identifier: Apache-2.0
// The incremental temporal network of one UAV's plan.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "schedule/implied_bounds.hpp"
#include "schedule/plan_links.hpp"
#include "skein/supervisor/schedule.hpp"
#include "skein/temporal/live_network.hpp"
#include "skein/temporal/live_stn.hpp"

namespace skein::supervisor {

class PlanOutline;

/// Verdict, explanation and dates (Schedule) of a plan whose tasks come, start, end and go while
/// time passes. Nodes and links are keyed by their meaning (task, bound, dependence); changes are
/// applied in place and propagated incrementally.
///
/// The forecast, `foreseen`, is computed in two networks ("courses"), with all contingent durations
/// least and with all greatest, if each task starts as early as its conditions and its holds allow.
/// Cost of an update: a comparison of all tasks with their previous versions, and the propagation
/// of the changes (docs/performance.md). Thread rule: not safe to share. Source: T IV.4.1, spec
/// 5.2, 6.1.
class PlanNetwork {
 public:
  PlanNetwork();

  /// Makes the network that of `tasks` at `now`. Preconditions: sorted by id, ids differ; the tasks
  /// pointed to live until the call returns.
  void update(const std::vector<TaskView>& tasks, MissionTime now);

  const Schedule& schedule() const { return schedule_; }
  /// The network for partners, with inner nodes, if these tasks are meetings: without links from
  /// partners' dates, and without holds.
  temporal::Frontier frontier(const std::map<executive::TaskId, PlanMeeting>& meetings,
                              const std::vector<PlanOrder>& orders = {}) const;
  const temporal::LiveNetwork& network() const { return live_; }

 private:
  struct Known {
    mission::ElementaryTask task;  ///< only the fields that matter to the network
    Observation seen;
    std::vector<TaskBound> bounds;
    std::optional<Encounter> encounter;
    bool has_others = false;  ///< the node others_at() exists
    TaskView view() const { return {&task, seen, bounds, encounter}; }
    std::map<temporal::LinkName, PlanLink> links;
    temporal::NodeIndex start = 0, end = 0;
    bool endless = false;
  };
  using Tasks = std::map<executive::TaskId, Known>;

  std::set<executive::TaskId> take_over(const std::vector<TaskView>& tasks);
  void enter(const TaskView& view, std::set<executive::TaskId>& dirty);
  void forget(Tasks::iterator gone, std::set<executive::TaskId>& dirty);
  void name_others(const Known& known, bool names);
  void dirty_namers(executive::TaskId task, std::set<executive::TaskId>& dirty) const;
  void set_present();
  SeenOf seen_of_tasks() const;
  void relink(Known& known);
  void outline_gathering(const Known& known, PlanOutline& outline) const;
  void outline_task(const Known& known, bool meets, PlanOutline& outline) const;
  void set_others(Known& known, bool there);
  void put(const PlanLink& link);
  void take_out(const temporal::LinkName& name);
  void unlink_from(Known& known, executive::TaskId other);
  void settle();
  void take_implied();
  void hold_back(bool controllable);
  void hold_for_instants(const temporal::LiveStn* windows);
  bool ends_with_its_like(const Known& known) const;
  void hold_after_goals(const temporal::LiveStn& windows);
  void hold_behind(const temporal::NamedWait& wait);
  ImpliedBounds bounds_by_name() const;
  void hold_for_what_is_implied();
  void hold_until_windows_open();
  void set_hold(temporal::LiveStn::LinkId link, const temporal::Arc& in_soonest,
                temporal::Ticks in_slowest);
  void explain();
  void read_dates();
  std::set<temporal::NodeIndex> unbounded() const;
  const temporal::LiveStn* any_course();

  Tasks tasks_;
  std::map<executive::TaskId, std::multiset<executive::TaskId>> named_by_;
  MissionTime now_;
  temporal::NodeIndex present_ = 0;
  temporal::LiveNetwork live_;
  /// For the windows: all links, with least, or greatest, contingent durations.
  temporal::LiveStn fast_, slow_;
  /// For the forecast: only lower bounds and holds, with least, or greatest, contingent durations.
  temporal::LiveStn soonest_, slowest_;
  /// Windows with all durations controllable; if the network is consistent but not controllable.
  std::optional<temporal::LiveStn> free_;
  std::map<temporal::LinkName, std::uint32_t> numbers_;
  /// Bounds implied by contingent links for all their durations; also in `fast_`.
  std::map<temporal::LiveStn::LinkId, temporal::Arc> implied_;
  std::set<temporal::LiveStn::LinkId> held_;
  std::vector<executive::TaskId> starts_;  ///< by node: the task whose start it is
  Schedule schedule_;
};

}  // namespace skein::supervisor
