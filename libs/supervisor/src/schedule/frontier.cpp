// SPDX-License-Identifier: Apache-2.0
// What others need to know of the network of a plan.
#include <utility>

#include "schedule/plan_network.hpp"

namespace skein::supervisor {

namespace {

using executive::TaskId;
using temporal::Frontier;
using temporal::FrontierLink;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::LiveNetwork;
using temporal::NodeName;
using temporal::Ticks;

/// Numbers for the nodes of a plan, those of the frontier first.
class Numbers {
 public:
  Numbers(const std::map<TaskId, PlanMeeting>& meetings, const std::vector<PlanOrder>& orders) {
    of_[temporal::LiveNetwork::kOrigin] = Frontier::kOrigin;
    of_[kPresent] = Frontier::kPresent;
    std::size_t number = 0;
    for (const auto& [task, meeting] : meetings) {
      of_[meeting.at_start ? ready_of(task) : start_of(task)] = Frontier::arrival_of(number);
      of_[meeting.at_start ? start_of(task) : end_of(task)] = Frontier::end_of(number++);
    }
    for (const PlanOrder& order : orders) {
      of_[left_of(order.what.id)] = Frontier::arrival_of(number);
      if (order.waits) of_[others_at(order.task)] = Frontier::end_of(number);
      ++number;
    }
    next_ = Frontier::arrival_of(number);
  }
  std::uint32_t of(const temporal::NodeName& node) {
    const auto [at, is_new] = of_.emplace(node, next_);
    if (is_new) ++next_;
    return at->second;
  }

 private:
  std::map<temporal::NodeName, std::uint32_t> of_;
  std::uint32_t next_ = 0;
};

}  // namespace

/// The links of which the frontier is what remains.
class PlanOutline {
 public:
  PlanOutline(const std::map<TaskId, PlanMeeting>& meetings, const std::vector<PlanOrder>& orders)
      : numbers_(meetings, orders) {}

  std::vector<temporal::FrontierArc> arcs() const { return links_; }
  void add(const NodeName& from, const NodeName& to, Ticks soonest, Ticks slowest, Ticks latest) {
    links_.push_back({numbers_.of(from), numbers_.of(to), soonest, slowest, latest});
  }
  void at_least(const NodeName& from, const NodeName& to, Ticks least) {
    add(from, to, least, least, least);
  }
  void at_most(const NodeName& from, const NodeName& to, Ticks most) {
    if (most != kInfinite) add(to, from, kMinusInfinite, kMinusInfinite, -most);
  }
  void at(const NodeName& node, Ticks date) {
    at_least(LiveNetwork::kOrigin, node, date);
    at_most(LiveNetwork::kOrigin, node, date);
  }
  void bound(const temporal::LiveLink& link) {
    at_least(link.from, link.to, link.min);
    at_most(link.from, link.to, link.max);
  }
  // What is under way lasts as long as it may: that it has not ended yet goes without saying, at
  // every instant anew.
  void last(const temporal::LiveLink& link, const TaskView& view, bool endless) {
    const Ticks least = std::min<Ticks>(link.min, view.task->duration.least.count());
    const Ticks most = link.contingent ? link.max : link.min;
    add(link.from, link.to, least, endless ? kInfinite : most, most);
    if (view.seen.started && !view.seen.over) at_least(kPresent, link.to, 0);
    at_most(link.from, link.to, link.max);
  }

 private:
  Numbers numbers_;
  std::vector<FrontierLink> links_;
};

namespace {

/// What a joint task waits for in the own plan: over, when all of it has come.
struct Readiness {
  bool waits = false;
  Ticks since = 0;

  void after(bool to_come, Ticks date) {
    waits = waits || to_come;
    if (!to_come) since = std::max(since, date);
  }
};

Readiness readiness_of(const std::map<temporal::LinkName, PlanLink>& links, const NodeName& start,
                       MissionTime now, const SeenOf& seen) {
  Readiness result;
  const auto when = [](const std::optional<MissionTime>& at) { return at ? ticks_of(*at) : 0; };
  for (const auto& [name, one] : links) {
    if (one.link.to != start) continue;
    const Observation* other = seen(one.cause.other);
    if (one.cause.kind == BoundKind::kAfterEnd && other != nullptr)
      result.after(!other->over, when(other->over));
    if (one.cause.kind == BoundKind::kAfterStart && other != nullptr)
      result.after(!other->started, when(other->started));
    if (one.cause.kind == BoundKind::kAfterGoal)
      result.after(other != nullptr || one.link.min > ticks_of(now), one.link.min);
  }
  return result;
}

}  // namespace

// Once begun, it bounds those no more who have not come: they join.
void PlanNetwork::outline_gathering(const Known& known, PlanOutline& outline) const {
  const NodeName ready = ready_of(known.task.id), start = start_of(known.task.id);
  outline.at_least(ready, start, 0);
  const Readiness readiness = readiness_of(known.links, start, now_, seen_of_tasks());
  if (known.seen.started) outline.at(ready, ticks_of(*known.seen.started));
  if (!known.seen.started && !readiness.waits) outline.at(ready, readiness.since);
  for (const auto& [name, one] : known.links) {
    const BoundKind kind = one.cause.kind;
    const temporal::LiveLink& link = one.link;
    if (kind == BoundKind::kPartner || kind == BoundKind::kNeeded) continue;
    if (kind == BoundKind::kDuration) {
      outline.last(link, known.view(), known.endless);
    } else if (kind == BoundKind::kFact && link.to == start) {
      outline.at_least(link.from, link.to, link.min);
    } else {
      outline.bound(link);
    }
    const bool makes_ready = kind == BoundKind::kNow || kind == BoundKind::kAfterEnd ||
                             kind == BoundKind::kAfterStart || kind == BoundKind::kAfterGoal;
    if (readiness.waits && makes_ready && link.to == start)
      outline.at_least(link.from, ready, link.min);
  }
}

// How long a meeting takes is for the others to say, and when air is left; who gets it elsewhere
// flies before.
void PlanNetwork::outline_task(const Known& known, bool meets, PlanOutline& outline) const {
  for (const auto& [name, one] : known.links) {
    const BoundKind kind = one.cause.kind;
    if (kind == BoundKind::kPartner || kind == BoundKind::kNeeded) continue;
    if (kind != BoundKind::kDuration) {
      outline.bound(one.link);
    } else if (known.encounter && known.encounter->for_air) {
      outline.add(one.link.from, one.link.to, kMinusInfinite, one.link.max, kMinusInfinite);
    } else if (meets) {
      outline.at_least(one.link.from, one.link.to, kInstant);
    } else {
      outline.last(one.link, known.view(), known.endless);
    }
  }
}

Frontier PlanNetwork::frontier(const std::map<TaskId, PlanMeeting>& meetings,
                               const std::vector<PlanOrder>& orders) const {
  Frontier frontier;
  for (const auto& [task, meeting] : meetings) frontier.meetings.push_back(meeting.what);
  for (const PlanOrder& order : orders) frontier.meetings.push_back(order.what);
  if (frontier.meetings.empty()) return frontier;
  PlanOutline outline(meetings, orders);
  for (const PlanOrder& order : orders)
    if (!order.waits && tasks_.contains(order.task))
      outline.at_least(end_of(order.task), left_of(order.what.id), 0);
  for (const auto& [id, known] : tasks_) {
    const auto meeting = meetings.find(id);
    if (meeting != meetings.end() && meeting->second.at_start)
      outline_gathering(known, outline);
    else
      outline_task(known, meeting != meetings.end(), outline);
  }
  frontier.arcs = outline.arcs();
  return frontier;
}

}  // namespace skein::supervisor
