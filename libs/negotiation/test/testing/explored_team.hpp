// SPDX-License-Identifier: Apache-2.0
// Every course that a negotiation of a few managers can take, over the real code.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

#include "testing/negotiating_team.hpp"

namespace skein::interaction::testing {

struct Bounds {
  std::size_t members = 2;
  std::vector<std::size_t> openers;  ///< begin by themselves, at any time; the others when invited
  int crashes = 0;                   ///< of any member, at any time
  bool restarts = false;             ///< who crashed may come back, and be invited
  bool own_terms = false;            ///< each would open with parameters of its own
  double again = 1;                  ///< seconds between sendings, of a session of four
  double until = 10;                 ///< seconds; the undecided ask every five
  bool result_is_job = false;        ///< which ends at any time
};

/// A message that was sent stays deliverable for ever: delivered late it was delayed, again it was
/// doubled, never it was lost, and any order is one of the courses. Time passes from one wake-up to
/// the next at any moment. States that were seen are not looked at again; what changes nothing when
/// it is delivered is not delivered again before it is sent again.
class ExploredTeam {
 public:
  explicit ExploredTeam(Bounds bounds) : bounds_(std::move(bounds)) {}

  /// What is broken on some course; empty: nothing on any.
  std::string explore() {
    State start;
    for (std::size_t i = 0; i < bounds_.members; ++i) {
      start.managers.emplace_back(make(i, MissionTime()));
    }
    start.open.resize(bounds_.members);
    start.began.resize(bounds_.members, false);
    start.opened.resize(bounds_.members, false);
    start.crashes = bounds_.crashes;
    std::vector<State> stack{std::move(start)};
    while (!stack.empty() && broken_.empty()) {
      const State state = std::move(stack.back());
      stack.pop_back();
      if (!seen_.insert(state.key()).second) continue;
      for (State& next : courses_from(state)) stack.push_back(std::move(next));
    }
    return broken_;
  }
  std::size_t states() const { return seen_.size(); }
  /// What the courses came to, by the kinds of the ends: "agreed agreed".
  const std::set<std::string>& ends() const { return ends_; }

 private:
  struct State {
    std::vector<std::optional<NegotiationManager>> managers;
    std::set<std::size_t> sent;  ///< of the pool
    std::vector<std::optional<MissionTime>> open;
    std::vector<bool> began, opened;
    std::map<std::pair<std::size_t, SessionId>, Result<Rows, Failure>> reckonings;  ///< jobs
    std::map<SessionId, std::map<std::size_t, NegotiationOutcome>> outcomes;
    MissionTime now;
    int crashes = 0;

    std::string key() const {
      std::string text = to_text(now) + "/" + std::to_string(crashes) + "/";
      for (std::size_t i = 0; i < managers.size(); ++i) {
        text += managers[i] ? managers[i]->state_text() : "down";
        text += began[i] ? "|" : "+";
        text += opened[i] ? "|" : "+";
      }
      for (const auto& [job, result] : reckonings) {
        text += name_of(job.first) + to_text(job.second) + ",";
      }
      for (const std::size_t one : sent) text += std::to_string(one) + ",";
      for (const auto& [id, ends] : outcomes) {
        for (const auto& [member, end] : ends) {
          text += name_of(member) + std::to_string(static_cast<int>(end.kind));
        }
      }
      return text;
    }
  };

  NegotiationManager make(std::size_t member, MissionTime born) const {
    NegotiationLimits limits;
    limits.again = limits.again_most = Duration::seconds(bounds_.again);
    return NegotiationManager(name_of(member), 1, modalities(bounds_.result_is_job), limits, born);
  }
  BeginNegotiation begin_of(std::size_t member) const {
    BeginNegotiation begin = begin_roles(bounds_.members, Duration::seconds(4));
    if (bounds_.own_terms) begin.parameters[0].text = "as " + name_of(member) + " sees it";
    return begin;
  }

  std::vector<State> courses_from(const State& state) {
    std::vector<State> next;
    for (const std::size_t opener : bounds_.openers) {
      if (state.began[opener] || state.opened[opener] || !state.managers[opener]) continue;
      State copy = state;
      copy.opened[opener] = true;
      begin(copy, opener);
      next.push_back(std::move(copy));
    }
    std::vector<std::size_t> spent;
    for (const std::size_t message : state.sent) {
      State copy = state;
      const auto& [to, what] = pool_[message];
      if (!copy.managers[to]) continue;
      give(copy, to, SessionMessageReceived{what});
      if (copy.key() == state.key()) {
        spent.push_back(message);
      } else {
        next.push_back(std::move(copy));
      }
    }
    for (const auto& [job, result] : state.reckonings) {
      State copy = state;
      copy.reckonings.erase(job);
      give(copy, job.first, ResultReckoned{job.second, result});
      next.push_back(std::move(copy));
    }
    faults_from(state, next);
    if (auto later = time_passed(state)) next.push_back(std::move(*later));
    for (State& one : next) {
      for (const std::size_t message : spent) one.sent.erase(message);
    }
    return next;
  }

  void faults_from(const State& state, std::vector<State>& next) {
    for (std::size_t i = 0; i < bounds_.members; ++i) {
      if (state.managers[i] && state.crashes > 0) {
        State copy = state;
        copy.managers[i].reset();
        copy.open[i].reset();
        std::erase_if(copy.reckonings, [&](const auto& job) { return job.first.first == i; });
        --copy.crashes;
        next.push_back(std::move(copy));
      } else if (!state.managers[i] && bounds_.restarts) {
        State copy = state;
        // Another instant than any before: what it opens now is another session.
        copy.now = copy.now + Duration::nanoseconds(1);
        copy.managers[i] = make(i, copy.now);
        copy.began[i] = false;
        next.push_back(std::move(copy));
      }
    }
  }

  std::optional<State> time_passed(const State& state) {
    std::optional<MissionTime> wakeup;
    for (const auto& one : state.managers) {
      if (one) wakeup = earliest(wakeup, one->next_wakeup());
    }
    if (!wakeup || *wakeup > MissionTime::seconds(bounds_.until)) {
      note_end(state);
      return std::nullopt;
    }
    State copy = state;
    copy.now = *wakeup;
    for (std::size_t i = 0; i < copy.managers.size(); ++i) {
      if (copy.managers[i]) give(copy, i, NegotiationTick{});
    }
    for (std::size_t i = 0; i < copy.open.size(); ++i) {
      if (copy.open[i] && copy.now > *copy.open[i]) broken_ += name_of(i) + " has no end. ";
    }
    return copy;
  }

  void note_end(const State& state) {
    for (const auto& [id, ends] : state.outcomes) {
      std::string text;
      for (const auto& [member, end] : ends) {
        text += (text.empty() ? "" : " ") + std::string(to_text(end.kind));
      }
      ends_.insert(text);
    }
  }

  void begin(State& state, std::size_t member) {
    state.began[member] = true;
    const auto open = state.open[member];
    state.open[member] = state.now + Duration::seconds(4);
    if (!give(state, member, begin_of(member))) state.open[member] = open;
  }

  bool give(State& state, std::size_t member, const NegotiationInput& input) {
    auto effects = state.managers[member]->handle(input, state.now);
    if (!effects) return false;
    for (const NegotiationEffect& one : *effects) {
      std::visit([&](const auto& what) { take(state, member, what); }, one);
    }
    return true;
  }

  void take(State& state, std::size_t, const SendSessionMessage& send) {
    const std::size_t to = member_of(send.to);
    std::string text = send.to + send.message.from + to_text(send.message.terms.id());
    for (const Entry& one : send.message.entries) {
      text += one.uav + std::to_string(one.offered) + std::to_string(static_cast<int>(one.vow)) +
              std::to_string(one.lost) + one.why;
    }
    text += send.message.wants_echo ? "?" : ".";
    const auto [at, fresh] = index_.emplace(std::move(text), pool_.size());
    if (fresh) pool_.emplace_back(to, send.message);
    state.sent.insert(at->second);
  }
  void take(State& state, std::size_t member, const InvitedToNegotiate&) {
    if (!state.began[member]) begin(state, member);
  }
  void take(State& state, std::size_t member, const PrepareOffer& prepare) {
    give(state, member, OfferPrepared{prepare.terms.id(), role_costs(member)});
  }
  void take(State& state, std::size_t member, const ReckonResult& asked) {
    state.reckonings.emplace(std::pair(member, asked.terms.id()),
                             reckon(asked.terms, asked.offers));
  }
  void take(State& state, std::size_t member, const NegotiationEnded& ended) {
    if (!state.open[member]) broken_ += name_of(member) + " ended what it did not begin. ";
    state.open[member].reset();
    note(state, member, ended.terms, ended.outcome);
  }
  void take(State& state, std::size_t member, const NegotiationSettled& settled) {
    note(state, member, settled.terms, settled.outcome);
  }
  void take(State&, std::size_t, const MessageRejected&) {}

  void note(State& state, std::size_t member, const Terms& terms,
            const NegotiationOutcome& outcome) {
    state.outcomes[terms.id()][member] = outcome;
    Outcomes checked;
    for (const auto& [other, end] : state.outcomes[terms.id()]) {
      checked.note(other, terms, end, true);
    }
    broken_ += checked.breaks();
  }

  Bounds bounds_;
  std::vector<std::pair<std::size_t, SessionMessage>> pool_;
  std::map<std::string, std::size_t> index_;
  std::unordered_set<std::string> seen_;
  std::set<std::string> ends_;
  std::string broken_;
};

}  // namespace skein::interaction::testing
