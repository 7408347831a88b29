// SPDX-License-Identifier: Apache-2.0
// One negotiation session at one member.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facts.hpp"
#include "reckoning.hpp"
#include "skein/negotiation/negotiation_manager.hpp"
#include "telling.hpp"

namespace skein::interaction {

/// What a member requires of a session that it joins.
struct Wanted {
  std::string modality;
  std::vector<std::string> members;
  ModelHash model;
};

/// By UAV, how long it took until it answered.
using AnswerTimes = std::map<std::string, Duration>;

/// State of this member in the session:
///   from            on                                               to
///   (new)           a message                                        invited
///   (new)           a message with more about it than it said        lost
///   (new), invited  join                                             taking part
///   (new)           a message, while it takes part with others       refused (turned down)
///   taking part     offers of all, and what follows from them        promised
///   taking part     half the time, a bad offer, somebody lost, …     refused
///   taking part     another session of the subject                   refused (moved)
/// The session ends here on a known refusal (failed), on all promises (agreed), or at the deadline.
class Session {
 public:
  /// `told_by`: the member that first told of the session; `self` if it is opened here.
  /// `answers_in`: as far as other sessions have shown.
  Session(Terms terms, std::string self, const NegotiationLimits& limits, std::string told_by,
          const AnswerTimes& answers_in);

  /// Takes part. The opener sends the session to all members.
  void join(const Wanted& wanted, std::shared_ptr<const NegotiationModality> modality,
            MissionTime now, NegotiationEffects& out);
  void offer(const Result<Rows, Failure>& offer, MissionTime now, NegotiationEffects& out);
  void reckoned(Result<Rows, Failure> result, MissionTime now, NegotiationEffects& out);
  /// Precondition: may_refuse().
  void refuse(const std::string& why, MissionTime now, NegotiationEffects& out);
  /// Refuses because the member moves to another session: tells it only to members that ask, and
  /// emits no NegotiationEnded. Precondition: may_refuse().
  void leave(const std::string& why);
  /// Refuses without having taken part, since the session differs from `wanted`. Returns why.
  std::string turn_down(const Wanted& wanted, MissionTime now, NegotiationEffects& out);
  /// Merges a message. Returns why it has no effect; absent: it has.
  std::optional<std::string> receive(const SessionMessage& message, MissionTime now,
                                     NegotiationEffects& out);
  /// Sends one member all that is known here.
  void tell(const std::string& uav, MissionTime now, NegotiationEffects& out);
  /// This member restarted since, and may have made any vow before.
  void lose() { facts_[self_].lost = true; }
  void pass(MissionTime now, NegotiationEffects& out);
  std::optional<MissionTime> next_wakeup() const;

  const Terms& terms() const { return terms_; }
  std::string state_text() const;
  bool moved() const { return moved_; }
  /// How long the last answer of `uav` took, here or before; 0: not known.
  Duration answered_in(const std::string& uav) const { return telling_.answered_in(member(uav)); }
  const std::string& told_by() const { return told_by_; }
  /// Whether the session may be removed without loss: it is over, or a later message restores it.
  bool may_be_forgotten(MissionTime now) const;
  /// Whether `uav` is known to have promised.
  bool is_bound(const std::string& uav) const;
  bool takes_part() const { return joined_; }
  bool may_refuse() const;
  bool wants_offer() const { return joined_ && may_refuse() && !facts_[self_].offered; }
  /// A ReckonResult was emitted and not answered yet.
  bool wants_result() const;
  bool ended() const { return outcome_.has_value(); }
  bool decided() const { return facts_.refusal() != nullptr || facts_.all_promised(); }
  bool says_more_of_self(const std::vector<Entry>& entries) const;

 private:
  using Kind = NegotiationOutcome::Kind;
  bool decides() const { return self_ == 0; }
  std::size_t member(const std::string& uav) const;

  void advance(MissionTime now, NegotiationEffects& out);
  void vow(MissionTime now, NegotiationEffects& out);
  std::optional<std::string> objection(MissionTime now) const;
  void promise();
  void set_refused(const std::string& why);
  std::optional<NegotiationOutcome> outcome_at(MissionTime now) const;
  void end(NegotiationOutcome outcome, NegotiationEffects& out);
  std::string missing() const;

  void plan_to_tell(FactBits before);
  bool is_active() const;
  void send(MissionTime now, NegotiationEffects& out);
  void send_to(std::size_t member, bool asks, MissionTime now, NegotiationEffects& out);

  Terms terms_;
  std::size_t self_;
  NegotiationLimits limits_;
  std::string told_by_;
  Facts facts_;
  Telling telling_;
  Reckoning reckoning_;
  bool joined_ = false, moved_ = false;
  std::optional<NegotiationOutcome> outcome_;
};

}  // namespace skein::interaction
