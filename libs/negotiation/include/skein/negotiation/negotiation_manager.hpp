// SPDX-License-Identifier: Apache-2.0
// The negotiation manager of one UAV.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"
#include "skein/negotiation/modality.hpp"
#include "skein/negotiation/terms.hpp"

namespace skein::interaction {

struct NegotiationLimits {
  Duration again = Duration::milliseconds(500);  ///< between sendings of what was not echoed
  Duration ask = Duration::seconds(5);           ///< between questions of who is undecided
  Duration keep = Duration::seconds(600);        ///< records, after their deadline
  /// Known through one member, of those in which one takes no part, or not any more: each of
  /// kMostMembers may have opened one about a subject, for four subjects. Further ones are rejected
  /// until one is over or decided, which is forgotten for it.
  std::size_t sessions_of_one = 4 * kMostMembers;
};

/// To take part in a negotiation about a subject: in the session that is open, or in a new one.
struct BeginNegotiation {
  std::string subject, modality;
  std::vector<std::string> members;  ///< in any order; oneself among them
  ModelHash model;
  Rows parameters;  ///< of a new session
  /// Deadline of a new session, > 0; one with a deadline after twice that is not joined.
  Duration within = Duration::seconds(10);
};
/// Answer to PrepareOffer.
struct OfferPrepared {
  SessionId session;
  Result<Rows, Failure> offer;
};
/// Answer to ReckonResult.
struct ResultReckoned {
  SessionId session;
  Result<Rows, Failure> result;
};
/// Not to take part any more; too late once promised.
struct WithdrawNegotiation {
  std::string subject, why;
};
struct SessionMessageReceived {
  SessionMessage message;
};
/// Nothing but that time passes.
struct NegotiationTick {};
using NegotiationInput = std::variant<BeginNegotiation, OfferPrepared, ResultReckoned,
                                      WithdrawNegotiation, SessionMessageReceived, NegotiationTick>;

struct SendSessionMessage {
  std::string to;
  SessionMessage message;
};
/// Others negotiate about this with us; begin with the same subject to join them.
struct InvitedToNegotiate {
  Terms terms;
};
/// Evaluate what can be offered, and give it as OfferPrepared.
struct PrepareOffer {
  Terms terms;
};
/// Reckon what follows from all offers, and give it as ResultReckoned: of modalities that are long.
struct ReckonResult {
  Terms terms;
  Offers offers;
};
/// Once for each negotiation begun, at its deadline at the latest.
struct NegotiationEnded {
  Terms terms;
  NegotiationOutcome outcome;
};
/// What was undecided is known now.
struct NegotiationSettled {
  Terms terms;
  NegotiationOutcome outcome;
};
/// A message without effect.
struct MessageRejected {
  std::string from, subject, why;
};
using NegotiationEffect =
    std::variant<SendSessionMessage, InvitedToNegotiate, PrepareOffer, ReckonResult,
                 NegotiationEnded, NegotiationSettled, MessageRejected>;
using NegotiationEffects = std::vector<NegotiationEffect>;

/// Sessions of one UAV. A session is what its members are known to have said: offers, then vows. A
/// member promises the result of all offers once it knows them all, or refuses as long as it has
/// not promised; the decider promises last. All promised is agreed, one refused is failed; at the
/// deadline whoever promised and knows neither ends undecided, and goes on asking. Of two sessions
/// about one subject the one opened earlier goes on, and who has not promised moves to it.
///
/// Laws, under loss, delay, doubles, reordering, cuts, crashes and restarts:
///   - results of one session are equal, whoever ends agreed or undecided;
///   - nobody ends or is settled failed where somebody is agreed;
///   - what is begun ends once, by the deadline of its session: twice as long as it was begun for
///     at most, whatever comes over the wire;
///   - nobody is undecided who hears, directly or through others, from who knows, between the
///     decision and the deadline, which are half of the session apart at least.
/// Why not more: docs/decisions/0011-negotiation.md. Cost of a message: O(members × rows).
/// A value type: copies go on apart. Thread rule: one thread at a time. Source: T V.3, spec 7.4.
class NegotiationManager {
 public:
  /// `born`: when this UAV came to life; what it vowed before it does not know.
  NegotiationManager(std::string self, std::uint32_t mission, Modalities modalities,
                     NegotiationLimits limits, MissionTime born);
  ~NegotiationManager();
  NegotiationManager(const NegotiationManager&);
  NegotiationManager& operator=(const NegotiationManager&);
  NegotiationManager(NegotiationManager&&) noexcept;
  NegotiationManager& operator=(NegotiationManager&&) noexcept;

  /// Instants up to `now` pass first. Refused, without effect but for time: a negotiation that
  /// makes no sense, with every reason; one whose subject is being negotiated; an offer or a
  /// result that nobody asked for, or wants any more; a withdrawal from what is not begun, or after
  /// the promise. Messages are never refused so: MessageRejected says why one had no effect.
  Result<NegotiationEffects, Failure> handle(const NegotiationInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  /// All sessions as known here, a line each: for logs, and for checkers: what managers with equal
  /// texts do next is equal.
  std::string state_text() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::interaction
