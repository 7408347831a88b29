// SPDX-License-Identifier: Apache-2.0
// Keeps the network of a plan up to date, and reads verdict and dates off it.
#include "schedule/plan_network.hpp"

#include <algorithm>
#include <utility>

#include "schedule/conflicts.hpp"
#include "schedule/course_links.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::supervisor {

namespace {

using executive::TaskId;
using mission::ElementaryTask;
using temporal::Arc;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::LiveNetwork;
using temporal::LiveStn;
using temporal::NodeIndex;
using temporal::Ticks;

const temporal::LinkName kPresentName{0xFFFFFFFF, 1, 0, 0};

bool same_in_time(const ElementaryTask& a, const ElementaryTask& b) {
  return a.duration == b.duration && a.open_ended == b.open_ended && a.time == b.time &&
         a.dependences == b.dependences && a.stop == b.stop;
}

ElementaryTask in_time(const ElementaryTask& task) {
  ElementaryTask result;
  result.id = task.id;
  result.dependences = task.dependences;
  result.stop = task.stop;
  result.duration = task.duration;
  result.open_ended = task.open_ended;
  result.time = task.time;
  return result;
}

MissionTime instant_of(Ticks date) {
  return date == kInfinite ? MissionTime::max() : MissionTime::nanoseconds(date);
}

}  // namespace

PlanNetwork::PlanNetwork() { present_ = live_.add_node(kPresent); }

// ---- tasks ----

void PlanNetwork::update(const std::vector<TaskView>& tasks, MissionTime now) {
  now_ = now;
  std::set<TaskId> dirty = take_over(tasks);
  for (const auto& [id, known] : tasks_) {
    if (known.seen.started && !known.seen.over) dirty.insert(id);
  }
  set_present();
  for (const TaskId id : dirty) {
    const auto known = tasks_.find(id);
    if (known != tasks_.end()) relink(known->second);
  }
  settle();
}

std::set<TaskId> PlanNetwork::take_over(const std::vector<TaskView>& tasks) {
  std::set<TaskId> dirty;
  auto known = tasks_.begin();
  for (const TaskView& view : tasks) {
    while (known != tasks_.end() && known->first < view.task->id) forget(known++, dirty);
    if (known == tasks_.end() || view.task->id < known->first) {
      enter(view, dirty);
      continue;
    }
    Known& one = known->second;
    const bool same = same_in_time(one.task, *view.task) && one.bounds == view.bounds &&
                      one.encounter == view.encounter;
    if (!same) {
      name_others(one, false);
      one.task = in_time(*view.task);
      one.bounds = view.bounds;
      one.encounter = view.encounter;
      name_others(one, true);
    }
    if (!(one.seen == view.seen)) dirty_namers(view.task->id, dirty);
    if (!same || !(one.seen == view.seen)) dirty.insert(view.task->id);
    one.seen = view.seen;
    ++known;
  }
  while (known != tasks_.end()) forget(known++, dirty);
  return dirty;
}

void PlanNetwork::enter(const TaskView& view, std::set<TaskId>& dirty) {
  const TaskId id = view.task->id;
  Known known{in_time(*view.task), view.seen, view.bounds, view.encounter, false, {}, 0, 0, false};
  known.start = live_.add_node(start_of(id));
  known.end = live_.add_node(end_of(id));
  const bool is_new = tasks_.emplace(id, std::move(known)).second;
  SKEIN_EXPECTS(is_new);
  const Known& one = tasks_.at(id);
  starts_.resize(std::max<std::size_t>({starts_.size(), one.start + 1U, one.end + 1U}));
  starts_[one.start] = id;
  starts_[one.end] = TaskId();
  name_others(one, true);
  dirty.insert(id);
  dirty_namers(id, dirty);
}

// The links of others to it go with its nodes.
void PlanNetwork::forget(Tasks::iterator gone, std::set<TaskId>& dirty) {
  const TaskId id = gone->first;
  name_others(gone->second, false);
  dirty_namers(id, dirty);
  for (const auto& [name, link] : gone->second.links) take_out(name);
  const auto namers = named_by_.find(id);
  if (namers != named_by_.end()) {
    for (const TaskId other : namers->second) unlink_from(tasks_.at(other), id);
  }
  set_others(gone->second, false);
  live_.remove_node(start_of(id));
  live_.remove_node(end_of(id));
  dirty.erase(id);
  schedule_.dates.erase(id);
  schedule_.foreseen.erase(id);
  tasks_.erase(gone);
}

void PlanNetwork::unlink_from(Known& known, TaskId other) {
  for (auto it = known.links.begin(); it != known.links.end();) {
    const bool to_it = it->second.cause.other == other;
    if (to_it) take_out(it->first);
    it = to_it ? known.links.erase(it) : std::next(it);
  }
}

void PlanNetwork::name_others(const Known& known, bool names) {
  const auto note = [&](TaskId other) {
    auto& by = named_by_[other];
    if (names) {
      by.insert(known.task.id);
      return;
    }
    by.erase(by.find(known.task.id));
    if (by.empty()) named_by_.erase(other);
  };
  for (const mission::Dependence& one : known.task.dependences) note(one.task);
  for (const mission::Dependence& one : known.task.stop) note(one.task);
  for (const TaskBound& one : known.bounds) note(one.other);
}

void PlanNetwork::dirty_namers(TaskId task, std::set<TaskId>& dirty) const {
  const auto found = named_by_.find(task);
  if (found != named_by_.end()) dirty.insert(found->second.begin(), found->second.end());
}

// ---- links ----

void PlanNetwork::set_present() {
  const Ticks now = ticks_of(now_);
  live_.set_link(kPresentName, {LiveNetwork::kOrigin, kPresent, now, now, false});
  for (LiveStn* course : {&fast_, &slow_}) course->set(kPresentLink, {0, present_, now, now});
  for (LiveStn* course : {&soonest_, &slowest_}) {
    course->set(kPresentLink, {0, present_, now, kInfinite});
  }
}

SeenOf PlanNetwork::seen_of_tasks() const {
  return [this](TaskId task) {
    const auto found = tasks_.find(task);
    return found == tasks_.end() ? nullptr : &found->second.seen;
  };
}

void PlanNetwork::relink(Known& known) {
  const SeenOf seen = seen_of_tasks();
  known.endless = is_endless(known.view(), now_);
  std::map<temporal::LinkName, PlanLink> wanted;
  bool others = false;
  for (PlanLink& link : links_of(known.view(), now_, seen)) {
    others = others || link.link.to == others_at(known.task.id);
    wanted.emplace(name_of(link.cause), std::move(link));
  }
  for (const auto& [name, link] : known.links) {
    if (wanted.count(name) == 0) take_out(name);
  }
  set_others(known, others);
  for (const auto& [name, link] : wanted) {
    const auto before = known.links.find(name);
    if (before == known.links.end() || !(before->second.link == link.link)) put(link);
  }
  known.links = std::move(wanted);
}

void PlanNetwork::set_others(Known& known, bool there) {
  if (known.has_others == there) return;
  known.has_others = there;
  const temporal::NodeName name = others_at(known.task.id);
  if (!there) return live_.remove_node(name);
  const NodeIndex node = live_.add_node(name);
  starts_.resize(std::max<std::size_t>(starts_.size(), node + 1U));
  starts_[node] = TaskId();
}

void PlanNetwork::put(const PlanLink& link) {
  const temporal::LinkName name = name_of(link.cause);
  const temporal::LiveLink& what = link.link;
  const auto before = numbers_.find(name);
  if (before != numbers_.end()) {
    for (LiveStn* course : {&fast_, &slow_, &soonest_, &slowest_}) course->erase(before->second);
  }
  const std::uint32_t number = live_.set_link(name, what);
  numbers_[name] = number;
  const NodeIndex from = *live_.index(what.from), to = *live_.index(what.to);
  const Ticks least = what.min, most = what.max;
  fast_.set(number, {from, to, least, what.contingent ? least : most});
  slow_.set(number, {from, to, what.contingent ? most : least, most});
  if (least == kMinusInfinite) return;
  soonest_.set(number, {from, to, least, kInfinite});
  slowest_.set(number, {from, to, what.contingent ? most : least, kInfinite});
}

void PlanNetwork::take_out(const temporal::LinkName& name) {
  const auto number = numbers_.find(name);
  if (number == numbers_.end()) return;
  for (LiveStn* course : {&fast_, &slow_, &soonest_, &slowest_}) course->erase(number->second);
  numbers_.erase(number);
  live_.remove_link(name);
}

// ---- verdict and dates ----

void PlanNetwork::settle() {
  const temporal::LiveVerdict& verdict = live_.settle();
  schedule_.consistent = verdict.consistent;
  schedule_.controllable = verdict.controllable;
  schedule_.conflicts.clear();
  take_implied();
  for (LiveStn* course : {&fast_, &slow_}) course->settle();
  hold_back(verdict.controllable);
  for (LiveStn* course : {&soonest_, &slowest_}) course->settle();
  read_dates();
  if (!verdict.controllable) explain();
}

void PlanNetwork::take_implied() {
  std::map<LiveStn::LinkId, Arc> implied;
  for (const temporal::DistanceEdge& edge : live_.implied()) {
    const Arc arc{edge.from, edge.to, kMinusInfinite, edge.weight};
    Arc& kept = implied.emplace(between(kImplied, edge.from, edge.to), arc).first->second;
    kept.max = std::min(kept.max, edge.weight);
  }
  for (const auto& [link, arc] : implied_)
    if (implied.count(link) == 0) fast_.erase(link);
  for (const auto& [link, arc] : implied) {
    const auto before = implied_.find(link);
    if (before == implied_.end() || !(before->second == arc)) fast_.set(link, arc);
  }
  implied_ = std::move(implied);
}

const LiveStn* PlanNetwork::any_course() {
  if (!live_.verdict().consistent) return nullptr;
  free_.emplace();
  free_->set(kPresentLink, {0, present_, ticks_of(now_), ticks_of(now_)});
  for (const auto& [id, known] : tasks_) {
    for (const auto& [name, link] : known.links) {
      free_->set(numbers_.at(name), {*live_.index(link.link.from), *live_.index(link.link.to),
                                     link.link.min, link.link.max});
    }
  }
  free_->settle();
  return &*free_;
}

// What follows an end that nothing bounds is not bounded either.
std::set<NodeIndex> PlanNetwork::unbounded() const {
  std::set<NodeIndex> result;
  std::vector<NodeIndex> open;
  for (const auto& [id, known] : tasks_) {
    if (known.endless && result.insert(known.end).second) open.push_back(known.end);
  }
  if (open.empty()) return result;
  std::vector<std::vector<NodeIndex>> after(starts_.size());
  for (const auto& [id, known] : tasks_) {
    for (const auto& [name, one] : known.links) {
      const NodeIndex from = *live_.index(one.link.from);
      if (one.link.min != kMinusInfinite && from < after.size())
        after[from].push_back(*live_.index(one.link.to));
    }
  }
  for (const LiveStn::LinkId hold : held_) {
    if ((hold & (kHeldBehind | kHeldAfter)) == 0) continue;
    constexpr LiveStn::LinkId kNode = (LiveStn::LinkId{1} << 20U) - 1;
    after[(hold >> 20U) & kNode].push_back(static_cast<NodeIndex>(hold & kNode));
  }
  while (!open.empty()) {
    const NodeIndex node = open.back();
    open.pop_back();
    for (const NodeIndex next : after[node]) {
      if (result.insert(next).second) open.push_back(next);
    }
  }
  return result;
}

void PlanNetwork::read_dates() {
  const bool controllable = live_.verdict().controllable;
  const bool courses = soonest_.consistent() && slowest_.consistent();
  const bool windows = controllable ? fast_.consistent() && slow_.consistent()
                                    : live_.verdict().consistent && free_ && free_->consistent();
  schedule_.earliest_end = schedule_.latest_end = MissionTime();
  if (!courses || !windows) {
    schedule_.dates.clear();
    schedule_.foreseen.clear();
    return;
  }
  const LiveStn& low = controllable ? fast_ : *free_;
  const LiveStn& high = controllable ? slow_ : *free_;
  const std::set<NodeIndex> endless = unbounded();
  const auto last = [&](NodeIndex node) {
    return endless.count(node) != 0 ? MissionTime::max() : instant_of(slowest_.earliest(node));
  };
  for (const auto& [id, known] : tasks_) {
    schedule_.dates[id] = {instant_of(low.earliest(known.start)),
                           instant_of(high.latest(known.start)),
                           instant_of(low.earliest(known.end)), instant_of(high.latest(known.end))};
    const mission::TaskDates foreseen{instant_of(soonest_.earliest(known.start)), last(known.start),
                                      instant_of(soonest_.earliest(known.end)), last(known.end)};
    schedule_.foreseen[id] = foreseen;
    const bool first = id == tasks_.begin()->first;
    const auto later = [&](MissionTime a, MissionTime b) { return first ? b : std::max(a, b); };
    schedule_.earliest_end = later(schedule_.earliest_end, foreseen.earliest_end);
    schedule_.latest_end = later(schedule_.latest_end, foreseen.latest_end);
  }
}

void PlanNetwork::explain() {
  const temporal::LiveVerdict& verdict = live_.verdict();
  if (verdict.fault) {
    const TaskId first = tasks_.empty() ? TaskId() : tasks_.begin()->first;
    schedule_.conflicts = {
        {first, "the plan cannot be dated: " + temporal::to_text(*verdict.fault)}};
    return;
  }
  std::vector<BrokenBound> bounds;
  for (const temporal::NamedTerm& term : verdict.conflict) {
    if (term.link == kPresentName) continue;
    const PlanLink& link = tasks_.at(TaskId(term.link.key)).links.at(term.link);
    bounds.push_back({&link, term.bound});
  }
  const std::set<NodeIndex> endless = unbounded();
  const bool courses = soonest_.consistent() && slowest_.consistent();
  const ForeseenOf foreseen = [&](const temporal::NodeName& name) {
    std::optional<mission::Interval> result;
    const NodeIndex node = *live_.index(name);
    if (!courses) return result;
    const Ticks least = soonest_.earliest(node), most = slowest_.earliest(node);
    result = {Duration::nanoseconds(least),
              endless.count(node) != 0 ? Duration::max() : Duration::nanoseconds(most)};
    return result;
  };
  schedule_.conflicts = supervisor::explain(bounds, verdict.consistent, foreseen, now_);
}

}  // namespace skein::supervisor
