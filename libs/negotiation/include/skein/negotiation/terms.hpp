// SPDX-License-Identifier: Apache-2.0
// What a negotiation is about, and what its members tell each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/interaction/model_hash.hpp"

namespace skein::interaction {

/// A named figure or some; what it means is the modality's. Numbers are finite.
struct Row {
  std::string name;
  std::string text;
  std::vector<double> numbers;
  bool operator==(const Row&) const = default;
};
using Rows = std::vector<Row>;

/// Most members of one session.
inline constexpr std::size_t kMostMembers = 16;

/// Names a session: what it is about, and who opened it when.
struct SessionId {
  std::string subject;
  MissionTime opened;
  std::string opener;
  auto operator<=>(const SessionId&) const = default;
};
/// "mref/roles of karma at 12.5"
std::string to_text(const SessionId& id);

/// What the opener of a session fixes.
struct Terms {
  std::string subject;  ///< the same at all who mean the same negotiation
  std::uint32_t mission = 0;
  std::string modality;
  std::vector<std::string> members;  ///< from 2 to kMostMembers, in order, each once
  ModelHash model;
  Rows parameters;  ///< of the modality; who joins takes those of the opener
  std::string opener;
  MissionTime opened;
  MissionTime deadline;  ///< > opened
  bool operator==(const Terms&) const = default;

  SessionId id() const { return {subject, opened, opener}; }
  /// Who promises last, and so decides.
  const std::string& decider() const { return members.front(); }
  /// Who has not promised by then refuses. The rest of the time is there for everybody to hear it.
  MissionTime settled_by() const {
    return opened + Duration::nanoseconds((deadline - opened).count() / 2);
  }
};

/// What is wrong with terms, whatever their modality; empty if nothing.
std::vector<std::string> problems_of(const Terms& terms);

/// What one member is known to have said in a session. Each is said once and for all.
struct Entry {
  enum class Vow : std::uint8_t { kNone, kPromised, kRefused };
  std::string uav;
  bool offered = false;
  Rows offer;
  Vow vow = Vow::kNone;
  std::uint64_t result = 0;  ///< fingerprint of the result that was promised
  std::string why;           ///< it was refused
  bool lost = false;         ///< restarted since: it will vow no more
  bool operator==(const Entry&) const = default;
};

/// All that a member knows of a session. To receive one is to merge it: order, doubles and losses
/// are no matter.
struct SessionMessage {
  std::string from;
  Terms terms;
  std::vector<Entry> entries;  ///< one for each member, in their order
  bool wants_echo = false;     ///< `from` does not know that the receiver knows all this
  bool operator==(const SessionMessage&) const = default;
};

/// How a session came out at one member.
struct NegotiationOutcome {
  enum class Kind : std::uint8_t {
    kAgreed,
    kFailed,
    kUndecided,  ///< it promised, and heard from nobody who knows whether all did
  };
  Kind kind = Kind::kFailed;
  Rows result;                           ///< of kAgreed and kUndecided
  std::string why;                       ///< of kFailed and kUndecided
  std::vector<std::string> unconfirmed;  ///< of kAgreed, at the decider: who may not know yet
  bool operator==(const NegotiationOutcome&) const = default;
};
/// "agreed", "failed", "undecided".
std::string_view to_text(NegotiationOutcome::Kind kind);

}  // namespace skein::interaction
