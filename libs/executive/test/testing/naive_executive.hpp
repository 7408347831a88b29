// SPDX-License-Identifier: Apache-2.0
// An independent oracle: the executive of spec 2 written for the reader. It keeps everything, looks
// at every task and evaluates every formula from scratch at every step. Without background routine.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/executive/effect.hpp"
#include "skein/executive/executive.hpp"
#include "testing/naive_facts.hpp"

namespace skein::executive::testing {

class NaiveExecutive {
 public:
  explicit NaiveExecutive(Config config) : config_(std::move(config)) {}

  Effects handle(const Input& input, MissionTime now) {
    now_ = now;
    pass_instants();
    facts_.time_is(now);
    std::visit([this](const auto& one) { on(one); }, input);
    settle();
    return std::exchange(out_, {});
  }

 private:
  struct Entry {
    Task task;
    Formula pre, exit;
    TaskState state = TaskState::kScheduled;
    bool urgent = false, suppressed = false, relinquished = false;
    std::set<TaskId> blockers;
    std::optional<MissionTime> urgent_until, answer_until, again_at;
    bool told = false;  ///< its partners were told, and count on it
    std::set<std::string> resources;
    bool sync() const { return task.synchronisation.has_value(); }
    bool joint() const { return is_joint(task.type); }
    bool waits() const { return state == TaskState::kScheduled; }
    bool interruptible() const {
      return state == TaskState::kScheduled || state == TaskState::kStarted ||
             state == TaskState::kRunning;
    }
  };

  bool late(const Entry& e) const {
    return e.sync() && e.task.synchronisation->deadline &&
           *e.task.synchronisation->deadline <= facts_.time();
  }

  // --- time ---
  void add_instants(const Formula& f, std::set<MissionTime>& instants) const {
    for (const Clause& clause : f) {
      for (const Literal& l : clause) {
        if (const auto* t = std::get_if<TimeIs>(&l.condition)) instants.insert(t->instant);
      }
    }
  }
  void pass_instants() {
    while (true) {
      std::set<MissionTime> instants;
      std::set<std::tuple<MissionTime, int, TaskId>> timers;
      for (const auto& [id, e] : tasks_) {
        add_instants(e.pre, instants);
        add_instants(e.exit, instants);
        if (e.sync() && e.task.synchronisation->deadline) {
          instants.insert(*e.task.synchronisation->deadline);
        }
        if (e.urgent_until) timers.emplace(*e.urgent_until, 0, id);
        if (e.answer_until) timers.emplace(*e.answer_until, 1, id);
        if (e.again_at) timers.emplace(*e.again_at, 3, id);
      }
      const auto instant = instants.upper_bound(facts_.time());
      const bool condition = instant != instants.end() && *instant <= now_;
      const bool timer = !timers.empty() && std::get<0>(*timers.begin()) <= now_;
      if (!condition && !timer) return;
      if (condition && (!timer || *instant <= std::get<0>(*timers.begin()))) {
        facts_.time_is(*instant);
      } else {
        const auto [at, kind, id] = *timers.begin();
        Entry& e = tasks_.at(id);
        if (kind == 0) {
          e.urgent_until.reset();
          e.blockers.clear();
        } else if (kind == 3) {
          say(e, SyncWord::kThere);
          e.again_at = now_ + half_of_validity();
        } else {
          const bool was_started = e.state == TaskState::kStarted;
          go(e, TaskState::kAborted);
          if (was_started && config_.interrupts_unanswered)
            out_.push_back(Interrupt{id, e.joint()});
        }
      }
      settle();
    }
  }

  // --- the loop (2.4) ---
  void settle() {
    while (step()) {
    }
  }
  bool step() {
    for (auto& [id, e] : tasks_) {
      if (e.interruptible() && (facts_.exits(e.exit) || late(e))) return stop(e), true;
    }
    for (auto& [id, e] : tasks_) {
      if (e.waits() && e.urgent && e.blockers.empty()) return dispatch(e), true;
    }
    for (auto& [id, e] : tasks_) {
      if (!e.waits() || e.urgent) continue;
      if (facts_.holds(e.pre)) return dispatch(e), true;
      if (facts_.never(e.pre)) return go(e, TaskState::kAborted), true;
    }
    return false;
  }

  // --- transitions ---
  void go(Entry& e, TaskState state) {
    e.state = state;
    facts_.task_is(e.task.id, state);
    e.answer_until.reset();
    e.again_at.reset();
    if (is_terminal(state)) {
      e.urgent_until.reset();
      for (auto& [id, other] : tasks_) {
        if (other.blockers.erase(e.task.id) > 0 && other.blockers.empty()) {
          other.urgent_until.reset();
        }
      }
    }
    tell(e);
  }
  void tell(const Entry& e) {
    const TaskEvent event{e.task.id, e.task.type, e.state, ""};
    out_.push_back(event);
    for (const auto& [id, other] : tasks_) {
      if (id != e.task.id && other.joint() && is_active(other.state)) {
        out_.push_back(ForwardToSupervisor{event});
        return;
      }
    }
  }
  void expect_answer(Entry& e) {
    if (config_.functional_timeout && !e.joint()) {
      e.answer_until = now_ + *config_.functional_timeout;
    }
  }
  void dispatch(Entry& e) {
    e.urgent = false;
    e.urgent_until.reset();
    go(e, TaskState::kStarted);
    if (!e.sync()) {
      out_.push_back(Dispatch{e.task.id, e.joint()});
      return expect_answer(e);
    }
    go(e, TaskState::kRunning);
    for (const std::string& name : receivers_of(e)) {
      withdrawn_.erase({name, e.task.synchronisation->id});
    }
    e.told = true;
    const bool done = heard_all(e);
    say(e, done && config_.sync_validity ? SyncWord::kDone : SyncWord::kThere);
    if (done) return go(e, TaskState::kEnded);
    if (config_.sync_validity && !receivers_of(e).empty()) e.again_at = now_ + half_of_validity();
  }
  Duration half_of_validity() const {
    return Duration::nanoseconds(config_.sync_validity->count() / 2);
  }
  void say(const Entry& e, SyncWord word) {
    for (const std::string& name : receivers_of(e)) {
      out_.push_back(SendSync{e.task.synchronisation->id, name, word});
    }
  }
  bool another_tells(const Entry& e, const std::string& name) const {
    return std::any_of(tasks_.begin(), tasks_.end(), [&](const auto& one) {
      const Entry& o = one.second;
      return &o != &e && o.told && o.task.synchronisation->id == e.task.synchronisation->id &&
             is_in(receivers_of(o), name);
    });
  }
  void withdraw(Entry& e) {
    const bool told = std::exchange(e.told, false);
    if (!told || !config_.sync_validity) return;
    for (const std::string& name : receivers_of(e)) {
      if (another_tells(e, name)) continue;
      withdrawn_.insert({name, e.task.synchronisation->id});
      out_.push_back(SendSync{e.task.synchronisation->id, name, SyncWord::kWithdrawn});
    }
  }
  void stop(Entry& e) {
    if (e.waits()) return go(e, TaskState::kAborted);
    go(e, TaskState::kAborting);
    if (e.sync()) {
      go(e, TaskState::kAborted);
      return withdraw(e);
    }
    out_.push_back(Interrupt{e.task.id, e.joint()});
    expect_answer(e);
  }
  bool is_in(const std::vector<std::string>& names, const std::string& name) const {
    return std::count(names.begin(), names.end(), name) > 0;
  }
  std::vector<std::string> receivers_of(const Entry& e) const {
    const Synchronisation& s = *e.task.synchronisation;
    std::vector<std::string> names;
    if (!is_in(s.senders, config_.name)) return names;
    for (const std::string& name : s.receivers) {
      if (name != config_.name && !is_in(names, name)) names.push_back(name);
    }
    return names;
  }
  bool heard_all(const Entry& e) {
    const Synchronisation& s = *e.task.synchronisation;
    if (!is_in(s.receivers, config_.name)) return true;
    return std::all_of(s.senders.begin(), s.senders.end(), [&](const std::string& name) {
      if (name == config_.name) return true;
      const auto heard = heard_.find({s.id, name});
      return heard != heard_.end() && counts(heard->second);
    });
  }

  bool counts(const SyncReceived& m) const {
    if (m.word == SyncWord::kThere)
      return !config_.sync_validity || now_ - *m.said <= *config_.sync_validity;
    return m.word == SyncWord::kDone;
  }

  // --- inputs ---
  void reply(RequestKind kind, std::optional<TaskId> id, bool accepted) {
    out_.push_back(Reply{kind, id, accepted, ""});
  }
  Entry* in_plan(TaskId id) {
    const auto found = tasks_.find(id);
    return found == tasks_.end() || found->second.suppressed ? nullptr : &found->second;
  }
  void on(const Start& s) {
    const TaskId id = s.task.id;
    const bool fine = tasks_.count(id) == 0 || tasks_.at(id).relinquished;
    reply(RequestKind::kStart, id, fine);
    if (!fine) return;
    Entry e;
    e.task = s.task;
    e.exit = s.task.exit;
    for (const auto& r : config_.types.resources_of(s.task.type, s.task.parameters)) {
      e.resources.insert(r);
    }
    if (s.mode == InsertionMode::kSeq) e.pre = s.task.preconditions;
    if (s.mode == InsertionMode::kDep || s.mode == InsertionMode::kNut) {
      for (const auto& [other, o] : tasks_) {
        if (is_terminal(o.state)) continue;
        e.pre.push_back(
            {Literal{TaskInState{other, TaskState::kEnded}, false,
                     s.mode == InsertionMode::kDep ? Modality::kMandatory : Modality::kOptional}});
      }
    }
    const bool coherent = facts_.names_only_known(id, e.pre) &&
                          facts_.names_only_known(id, e.exit) && !facts_.never(e.pre) &&
                          !facts_.exits(e.exit) && !late(e);
    if (!coherent) {
      e.pre = e.exit = {};
      go(tasks_[id] = e, TaskState::kAborted);
      return;
    }
    e.pre = facts_.settled(e.pre);
    e.exit = facts_.settled(e.exit);
    e.urgent = s.mode == InsertionMode::kVut;
    Entry& kept = tasks_[id] = e;
    facts_.task_is(id, e.state);
    tell(kept);
    if (kept.urgent) displace(kept);
  }
  bool shares(const Entry& one, const Entry& other) const {
    return std::any_of(one.resources.begin(), one.resources.end(),
                       [&](const auto& r) { return other.resources.count(r) > 0; });
  }
  void displace(Entry& urgent) {
    if (config_.last_urgent_counts) {
      for (auto& [id, o] : tasks_)
        if (&o != &urgent && o.waits() && o.urgent && shares(o, urgent)) go(o, TaskState::kAborted);
    }
    std::vector<Entry*> to_stop;
    for (auto& [id, o] : tasks_) {
      if (!shares(o, urgent) || !is_active(o.state)) continue;
      urgent.blockers.insert(id);
      if (o.state != TaskState::kAborting) to_stop.push_back(&o);
    }
    if (!urgent.blockers.empty()) urgent.urgent_until = now_ + config_.urgent_wait;
    for (Entry* o : to_stop) stop(*o);
  }
  void on(const Abort& a) {
    Entry* e = in_plan(a.id);
    reply(RequestKind::kAbort, a.id, e != nullptr);
    if (e != nullptr && e->interruptible()) stop(*e);
  }
  void on(const ProcessMessage& m) {
    reply(RequestKind::kProcessMessage, std::nullopt, true);
    facts_.message(m.message);
  }
  void on(const UpdateConditions& u) {
    Entry* e = in_plan(u.id);
    bool fine = e != nullptr && !is_terminal(e->state);
    if (fine && u.preconditions) {
      fine = e->waits() && !e->urgent && facts_.names_only_known(u.id, *u.preconditions) &&
             !facts_.never(*u.preconditions);
    }
    if (fine && u.exit) fine = facts_.names_only_known(u.id, *u.exit) && !facts_.exits(*u.exit);
    reply(RequestKind::kUpdateConditions, u.id, fine);
    if (!fine) return;
    if (u.preconditions) e->pre = facts_.settled(*u.preconditions);
    if (u.exit) e->exit = facts_.settled(*u.exit);
  }
  void on(const Suppress& s) {
    Entry* e = in_plan(s.id);
    const bool fine = e != nullptr && is_terminal(e->state);
    reply(RequestKind::kSuppress, s.id, fine);
    if (fine) e->suppressed = true;
    if (fine) e->told = false;
  }
  void on(const FunctionalStatus& s) {
    Entry* e = in_plan(s.id);
    if (e == nullptr || e->sync() || !is_active(e->state)) return;
    if (is_terminal(s.state)) {
      go(*e, e->state == TaskState::kAborting ? TaskState::kAborted : s.state);
    } else if (s.state == TaskState::kRunning && e->state == TaskState::kStarted) {
      go(*e, TaskState::kRunning);
    } else if (s.state == TaskState::kStarted && e->state == TaskState::kStarted) {
      expect_answer(*e);
    }
  }
  void on(const SyncReceived& m) {
    SyncReceived heard = m;
    if (!heard.said) heard.said = now_;
    const auto before = heard_.find({m.id, m.from});
    if (before != heard_.end() && *before->second.said > *heard.said) return;
    heard_[{m.id, m.from}] = heard;
    for (auto& [id, e] : tasks_) {
      if (!e.sync() || e.state != TaskState::kRunning || !heard_all(e)) continue;
      if (config_.sync_validity) say(e, SyncWord::kDone);
      go(e, TaskState::kEnded);
    }
  }
  void on(const PeerReachable& p) {
    std::set<std::uint64_t> met;
    for (const auto& [id, e] : tasks_) {
      if (!e.told || !is_in(receivers_of(e), p.name)) continue;
      const std::uint64_t sync = e.task.synchronisation->id;
      if (!met.insert(sync).second) continue;
      const bool done =
          config_.sync_validity && std::any_of(tasks_.begin(), tasks_.end(), [&](const auto& one) {
            const Entry& o = one.second;
            return o.told && o.state == TaskState::kEnded && o.task.synchronisation->id == sync &&
                   is_in(receivers_of(o), p.name);
          });
      out_.push_back(SendSync{sync, p.name, done ? SyncWord::kDone : SyncWord::kThere});
    }
    for (const auto& [name, sync] : withdrawn_) {
      if (name == p.name) out_.push_back(SendSync{sync, name, SyncWord::kWithdrawn});
    }
  }
  void on(const Relinquish& r) {
    for (auto& [id, e] : tasks_) {
      if (id >= r.below || is_terminal(e.state)) continue;
      const Task task = e.task;
      e = Entry();
      e.task = task;
      e.state = TaskState::kAborted;
      e.suppressed = e.relinquished = true;
      facts_.relinquish(id);
      for (auto& [other, o] : tasks_) o.blockers.erase(id);
    }
  }
  void on(const Flight&) {}
  void on(const Tick&) {}

  Config config_;
  MissionTime now_;
  NaiveFacts facts_;
  Effects out_;
  std::map<TaskId, Entry> tasks_;
  std::map<std::pair<std::uint64_t, std::string>, SyncReceived> heard_;
  std::set<std::pair<std::string, std::uint64_t>> withdrawn_;
};

}  // namespace skein::executive::testing
