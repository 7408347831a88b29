// SPDX-License-Identifier: Apache-2.0
// Managers that negotiate over links that lose, delay and cut, in virtual time.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <vector>

#include "skein/foundation/overloaded.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::interaction::testing {

inline std::string name_of(std::size_t member) {
  return std::string(1, static_cast<char>('a' + member));
}
inline std::size_t member_of(const std::string& name) {
  return static_cast<std::size_t>(name[0] - 'a');
}

inline std::vector<std::string> names(std::size_t n) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < n; ++i) all.push_back(name_of(i));
  return all;
}

/// Two roles, the first for one, the second for the others.
inline BeginNegotiation begin_roles(std::size_t n, Duration within = Duration::seconds(10)) {
  const double others = static_cast<double>(n) - 1;
  return {"mref/roles",
          "role-allocation",
          names(n),
          ModelHash{7},
          {{"watch", "", {1, 1}}, {"relay", "", {others, others}}},
          within};
}

/// Settles as another does, but as a job.
class LongModality final : public NegotiationModality {
 public:
  explicit LongModality(std::shared_ptr<const NegotiationModality> other)
      : other_(std::move(other)) {}
  std::string_view name() const override { return other_->name(); }
  bool is_long() const override { return true; }

 private:
  std::optional<std::string> do_check(const Terms& terms) const override {
    return other_->problem_of(terms);
  }
  std::optional<std::string> do_check_offer(const Terms& terms, const Rows& offer) const override {
    return other_->problem_of(terms, offer);
  }
  Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const override {
    return other_->settle(terms, offers);
  }

  std::shared_ptr<const NegotiationModality> other_;
};

/// The standard ones; all results are jobs, or only those that always are.
inline Modalities modalities(bool all_long) {
  Modalities all = standard_modalities();
  for (auto& [name, one] : all) {
    if (all_long) one = std::make_shared<LongModality>(one);
  }
  return all;
}

/// Costs that differ by member.
inline Rows role_costs(std::size_t member) {
  return {{"watch", "", {10.0 + 3.0 * static_cast<double>(member)}}, {"relay", "", {11.0}}};
}

/// What a member says that opens a session, and offers at once.
inline NegotiationEffects open_session(NegotiationManager& manager, const BeginNegotiation& begin,
                                       Rows offer, MissionTime now) {
  const NegotiationEffects asked = manager.handle(begin, now).value();
  const SessionId session = std::get<PrepareOffer>(asked.at(0)).terms.id();
  return manager.handle(OfferPrepared{session, std::move(offer)}, now).value();
}

/// What came out where; says when a law of negotiation is broken.
class Outcomes {
 public:
  void note(std::size_t member, const Terms& terms, const NegotiationOutcome& outcome, bool first) {
    auto& ends = by_session_[terms.id()];
    if (first && ends.count(member) > 0) breaks_ += name_of(member) + " ended twice. ";
    ends[member] = outcome;
    for (const auto& [other, its] : ends) check(member, outcome, other, its);
  }
  const std::string& breaks() const { return breaks_; }
  void add_break(const std::string& what) { breaks_ += what; }
  const std::map<SessionId, std::map<std::size_t, NegotiationOutcome>>& all() const {
    return by_session_;
  }
  std::string text() const {
    std::string text;
    for (const auto& [id, ends] : by_session_) {
      text += to_text(id) + ":";
      for (const auto& [member, end] : ends)
        text += " " + name_of(member) + " " + std::string(to_text(end.kind));
      text += "\n";
    }
    return text;
  }

 private:
  using Kind = NegotiationOutcome::Kind;
  void check(std::size_t one, const NegotiationOutcome& its, std::size_t other,
             const NegotiationOutcome& others) {
    const bool differ = its.kind != Kind::kFailed && others.kind != Kind::kFailed &&
                        its.result != others.result && !its.result.empty() &&
                        !others.result.empty();
    if (differ) breaks_ += name_of(one) + " and " + name_of(other) + " have different results. ";
    const bool split = (its.kind == Kind::kAgreed && others.kind == Kind::kFailed) ||
                       (its.kind == Kind::kFailed && others.kind == Kind::kAgreed);
    if (split)
      breaks_ +=
          name_of(one) + " and " + name_of(other) + ": success at one and failure at the other. ";
  }

  std::map<SessionId, std::map<std::size_t, NegotiationOutcome>> by_session_;
  std::string breaks_;
};

/// Of a message sent: when it arrives; absent: it is lost.
using Link =
    std::function<std::optional<Duration>(std::size_t from, std::size_t to, MissionTime at)>;

class Team {
 public:
  Team(std::size_t n, Link link, NegotiationLimits limits = {})
      : link_(std::move(link)), limits_(limits), offers_(n) {
    for (std::size_t i = 0; i < n; ++i) {
      managers_.emplace_back(make(i, MissionTime()));
      offers_[i] = role_costs(i);
    }
    joins_ = std::vector<std::optional<BeginNegotiation>>(n);
    open_.resize(n);
  }

  /// Begins now; who is in `joins` begins when it is invited.
  void begin(std::size_t member, const BeginNegotiation& what) { do_begin(member, what); }
  void begin_when_invited(std::size_t member, const BeginNegotiation& what) {
    joins_[member] = what;
  }
  void set_offer(std::size_t member, Result<Rows, Failure> offer) {
    offers_[member] = std::move(offer);
  }
  void set_job_time(Duration time) { job_time_ = time; }
  /// Before anything begins.
  void make_results_jobs() {
    all_long_ = true;
    for (std::size_t i = 0; i < managers_.size(); ++i) managers_[i] = make(i, MissionTime());
  }
  void crash(std::size_t member) {
    managers_[member].reset();
    open_[member].reset();
  }
  void restart(std::size_t member) { managers_[member] = make(member, now_); }
  bool is_up(std::size_t member) const { return managers_[member].has_value(); }
  NegotiationManager& manager(std::size_t member) { return *managers_[member]; }
  void at(MissionTime when, std::function<void()> what) {
    queue_.push({when, ++count_, std::move(what)});
  }

  void run_until(MissionTime until) {
    for (;;) {
      std::optional<MissionTime> next;
      if (!queue_.empty()) next = queue_.top().at;
      for (const auto& one : managers_) {
        if (one) next = earliest(next, one->next_wakeup());
      }
      if (!next || *next > until) break;
      now_ = *next;
      step();
      check_deadlines();
    }
    now_ = until;
  }

  void give(std::size_t member, const NegotiationInput& input) {
    if (!managers_[member]) return;
    auto effects = managers_[member]->handle(input, now_);
    if (!effects) {
      refused_.push_back(effects.error().why);
      return;
    }
    for (const NegotiationEffect& one : *effects) {
      std::visit([&](const auto& what) { take(member, what); }, one);
    }
  }

  MissionTime now() const { return now_; }
  Outcomes& outcomes() { return outcomes_; }
  std::size_t sent() const { return sent_; }
  const std::vector<std::string>& rejected() const { return rejected_; }
  const std::vector<std::string>& refused() const { return refused_; }
  std::size_t settled() const { return settled_; }
  std::optional<MissionTime> last_end() const { return last_end_; }
  /// Of the only session, or of the last begun.
  std::map<std::size_t, NegotiationOutcome> ends() const {
    return outcomes_.all().empty() ? std::map<std::size_t, NegotiationOutcome>{}
                                   : std::prev(outcomes_.all().end())->second;
  }

 private:
  struct Event {
    MissionTime at;
    std::uint64_t order = 0;
    std::function<void()> what;
    bool operator<(const Event& other) const {
      return std::tie(other.at, other.order) < std::tie(at, order);
    }
  };

  NegotiationManager make(std::size_t member, MissionTime born) const {
    return NegotiationManager(name_of(member), 1, modalities(all_long_), limits_, born);
  }
  void do_begin(std::size_t member, const BeginNegotiation& what) {
    if (!managers_[member]) return;
    const std::size_t before = refused_.size();
    const auto open = open_[member];
    open_[member] = now_ + what.within;
    give(member, what);
    if (refused_.size() > before) open_[member] = open;
  }

  void step() {
    while (!queue_.empty() && queue_.top().at <= now_) {
      const Event event = queue_.top();
      queue_.pop();
      event.what();
    }
    for (std::size_t i = 0; i < managers_.size(); ++i) {
      if (managers_[i] && managers_[i]->next_wakeup() && *managers_[i]->next_wakeup() <= now_)
        give(i, NegotiationTick{});
    }
  }

  void check_deadlines() {
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (open_[i] && now_ > *open_[i]) {
        outcomes_.add_break(name_of(i) + " has no end at its deadline. ");
        open_[i].reset();
      }
    }
  }

  void take(std::size_t, const SendSessionMessage& send) {
    ++sent_;
    const std::size_t to = member_of(send.to);
    const auto delay = link_(member_of(send.message.from), to, now_);
    if (!delay) return;
    at(now_ + *delay,
       [this, to, message = send.message] { give(to, SessionMessageReceived{message}); });
  }
  void take(std::size_t member, const InvitedToNegotiate&) {
    if (joins_[member]) at(now_, [this, member] { do_begin(member, *joins_[member]); });
  }
  void take(std::size_t member, const PrepareOffer& prepare) {
    at(now_ + job_time_, [this, member, id = prepare.terms.id()] {
      give(member, OfferPrepared{id, offers_[member]});
    });
  }
  void take(std::size_t member, const ReckonResult& asked) {
    at(now_ + job_time_,
       [this, member, id = asked.terms.id(), result = reckon(asked.terms, asked.offers)] {
         give(member, ResultReckoned{id, result});
       });
  }
  void take(std::size_t member, const NegotiationEnded& ended) {
    if (!open_[member]) outcomes_.add_break(name_of(member) + " ended what it did not begin. ");
    open_[member].reset();
    last_end_ = now_;
    outcomes_.note(member, ended.terms, ended.outcome, true);
  }
  void take(std::size_t member, const NegotiationSettled& settled) {
    ++settled_;
    outcomes_.note(member, settled.terms, settled.outcome, false);
  }
  void take(std::size_t, const MessageRejected& rejected) { rejected_.push_back(rejected.why); }

  Link link_;
  NegotiationLimits limits_;
  std::vector<std::optional<NegotiationManager>> managers_;
  std::vector<Result<Rows, Failure>> offers_;
  std::vector<std::optional<BeginNegotiation>> joins_;
  std::vector<std::optional<MissionTime>> open_;  ///< the deadline of what is begun and not ended
  Duration job_time_;
  bool all_long_ = false;
  std::priority_queue<Event> queue_;
  std::uint64_t count_ = 0;
  MissionTime now_;
  Outcomes outcomes_;
  std::size_t sent_ = 0, settled_ = 0;
  std::optional<MissionTime> last_end_;
  std::vector<std::string> rejected_, refused_;
};

}  // namespace skein::interaction::testing
