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
  /// Until a message that nobody acknowledged is repeated; twice as long before each further one,
  /// up to again_most, when the one before has arrived or expired (scenarios/slots.yaml), or a
  /// quarter of the time left until half the time is over (then: all of it), so that what heals
  /// late is heard of. Who does not take part yet acknowledges nothing, and a narrow channel would
  /// carry nothing else.
  Duration again = Duration::milliseconds(500);
  Duration again_most = Duration::seconds(2);
  Duration ask = Duration::seconds(5);     ///< between questions of an undecided member
  Duration keep = Duration::seconds(600);  ///< time that a session is kept after its deadline
  /// Most sessions learnt from one member in which this UAV does not take part (any more): one
  /// opened by each of kMostMembers, for four subjects. Further ones are rejected until one of
  /// these is over or decided, and is replaced.
  std::size_t sessions_of_one = 4 * kMostMembers;
};

/// Take part in a negotiation about a subject: join the open session, or open a new one.
struct BeginNegotiation {
  std::string subject, modality;
  std::vector<std::string> members;  ///< in any order, including this UAV
  ModelHash model;
  Rows parameters;  ///< used if a new session is opened
  /// Time until the deadline of a new session, > 0. A session with a deadline after twice that time
  /// is not joined.
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
/// Stop taking part; impossible after this UAV has promised.
struct WithdrawNegotiation {
  std::string subject, why;
};
struct SessionMessageReceived {
  SessionMessage message;
};
/// Time passes.
struct NegotiationTick {};
using NegotiationInput = std::variant<BeginNegotiation, OfferPrepared, ResultReckoned,
                                      WithdrawNegotiation, SessionMessageReceived, NegotiationTick>;

struct SendSessionMessage {
  std::string to;
  SessionMessage message;
};
/// Others have opened a session with this UAV as a member; BeginNegotiation with the same subject
/// joins it.
struct InvitedToNegotiate {
  Terms terms;
};
/// Compute this UAV's offer, and return it as OfferPrepared, at once: who opens a session invites
/// the others with it, and without it not before a message would be repeated.
struct PrepareOffer {
  Terms terms;
};
/// Compute the result of all offers as a job, and return it as ResultReckoned; only for modalities
/// with is_long().
struct ReckonResult {
  Terms terms;
  Offers offers;
};
/// The outcome; once for each negotiation begun, at its deadline at the latest.
struct NegotiationEnded {
  Terms terms;
  NegotiationOutcome outcome;
};
/// A negotiation that ended undecided is known to be agreed or failed now.
struct NegotiationSettled {
  Terms terms;
  NegotiationOutcome outcome;
};
/// A message had no effect.
struct MessageRejected {
  std::string from, subject, why;
};
using NegotiationEffect =
    std::variant<SendSessionMessage, InvitedToNegotiate, PrepareOffer, ReckonResult,
                 NegotiationEnded, NegotiationSettled, MessageRejected>;
using NegotiationEffects = std::vector<NegotiationEffect>;

/// The negotiation sessions of one UAV. The state of a session is the set of offers and vows that
/// its members are known to have made. A member promises the result of all offers once it knows
/// them all, or refuses, as long as it has not promised; the decider promises last. The session is
/// agreed if all have promised, and failed if one has refused; at the deadline, a member that has
/// promised and knows neither ends undecided, and goes on asking. Of two sessions about one subject
/// the one opened earlier goes on; members that have not promised move to it.
///
/// Laws, under loss, delay, duplication, reordering, cuts, crashes and restarts:
///   - all members that end a session agreed or undecided have the same result;
///   - no member ends failed, or later learns "failed", if another one is agreed;
///   - each negotiation begun ends once, by the deadline of its session, which is at most twice
///     `within` after BeginNegotiation, whatever messages arrive;
///   - a member does not end undecided if it hears, directly or through others, from a member that
///     knows the decision, before the deadline (at least half of the session is left for that).
/// Why not more: docs/decisions/0011-negotiation.md. Cost of a message: O(members × rows).
/// A value type: copies are independent. Thread rule: one thread at a time. Source: T V.3, spec
/// 7.4.
class NegotiationManager {
 public:
  /// `born`: when this node started; it does not know its vows from before.
  NegotiationManager(std::string self, std::uint32_t mission, Modalities modalities,
                     NegotiationLimits limits, MissionTime born);
  ~NegotiationManager();
  NegotiationManager(const NegotiationManager&);
  NegotiationManager& operator=(const NegotiationManager&);
  NegotiationManager(NegotiationManager&&) noexcept;
  NegotiationManager& operator=(NegotiationManager&&) noexcept;

  /// Handles timers up to `now` first, then the input. Errors, without effect apart from the
  /// timers: an invalid negotiation, with every reason; one whose subject is being negotiated
  /// already; an offer or a result that was not asked for, or is no longer needed; a withdrawal
  /// from a negotiation that was not begun, or after the promise. For messages there is no error:
  /// MessageRejected tells why one had no effect.
  Result<NegotiationEffects, Failure> handle(const NegotiationInput& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  /// All known sessions, one line each, for logs and model checkers: managers with equal texts
  /// behave equally from then on.
  std::string state_text() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::interaction
