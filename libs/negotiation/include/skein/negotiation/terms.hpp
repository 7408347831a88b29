// SPDX-License-Identifier: Apache-2.0
// Terms, messages and outcomes of negotiation sessions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/interaction/model_hash.hpp"

namespace skein::interaction {

/// A named list of numbers, and a text; the modality defines the meaning. Numbers are finite.
struct Row {
  std::string name;
  std::string text;
  std::vector<double> numbers;
  bool operator==(const Row&) const = default;
};
using Rows = std::vector<Row>;

/// Most members of one session.
inline constexpr std::size_t kMostMembers = 16;

/// Identifies a session: its subject, its opener, and when it was opened.
struct SessionId {
  std::string subject;
  MissionTime opened;
  std::string opener;
  auto operator<=>(const SessionId&) const = default;
};
/// "mref/roles of karma at 12.5"
std::string to_text(const SessionId& id);

/// The terms of a session, fixed by its opener.
struct Terms {
  std::string subject;  ///< identifies the negotiation at all members
  std::uint32_t mission = 0;
  std::string modality;
  std::vector<std::string> members;  ///< from 2 to kMostMembers, sorted, each once
  ModelHash model;
  Rows parameters;  ///< of the modality
  std::string opener;
  MissionTime opened;
  MissionTime deadline;  ///< > opened
  bool operator==(const Terms&) const = default;

  SessionId id() const { return {subject, opened, opener}; }
  /// The member that promises last, and thereby decides.
  const std::string& decider() const { return members.front(); }
  /// Members that have not promised by then refuse. The rest of the time until the deadline serves
  /// to spread the decision.
  MissionTime settled_by() const {
    return opened + Duration::nanoseconds((deadline - opened).count() / 2);
  }
};

/// The errors of terms that do not depend on the modality; empty if there are none.
std::vector<std::string> problems_of(const Terms& terms);

/// What one member is known to have said in a session. Offer and vow are final once made.
struct Entry {
  enum class Vow : std::uint8_t { kNone, kPromised, kRefused };
  std::string uav;
  bool offered = false;
  Rows offer;
  Vow vow = Vow::kNone;
  std::uint64_t result = 0;  ///< hash of the promised result
  std::string why;           ///< the reason of a refusal
  bool lost = false;         ///< the member restarted since, and will make no vow
  bool operator==(const Entry&) const = default;
};

/// All that a member knows of a session. Receivers merge it into their knowledge, so that order,
/// duplication and loss of messages do not matter.
struct SessionMessage {
  std::string from;
  Terms terms;
  std::vector<Entry> entries;  ///< one for each member, in their order
  bool wants_echo = false;     ///< the receiver is to confirm that it knows all this
  bool operator==(const SessionMessage&) const = default;
};

/// The outcome of a session at one member.
struct NegotiationOutcome {
  enum class Kind : std::uint8_t {
    kAgreed,
    kFailed,
    kUndecided,  ///< the member promised, and does not know whether all others did
  };
  Kind kind = Kind::kFailed;
  Rows result;                           ///< of kAgreed and kUndecided
  std::string why;                       ///< of kFailed and kUndecided
  std::vector<std::string> unconfirmed;  ///< of kAgreed, at the decider: members that may not know
  bool operator==(const NegotiationOutcome&) const = default;
};
/// "agreed", "failed", "undecided".
std::string_view to_text(NegotiationOutcome::Kind kind);

}  // namespace skein::interaction
