// SPDX-License-Identifier: Apache-2.0
// What two members have told each other of their claims.
#pragma once

#include <cstdint>
#include <optional>

#include "skein/foundation/repeats.hpp"
#include "skein/foundation/time.hpp"
#include "skein/merging/message.hpp"

namespace skein::merging {

/// One member's side of it. A claim is told until the other says that it has this version of it,
/// ever more rarely, and left out of messages from then on until it changes: perhaps the channel
/// carries no more. Times never decrease. A value. Source:
/// docs/decisions/0088-air-is-told-once.md.
class Exchange {
 public:
  /// Whether a message came after later ones, or once more.
  bool is_old(const Message& message) const { return message.number <= number_; }
  /// The other said this, or the witness passed it on. False: the message leaves out a claim that
  /// is not known here, so the other has to hear which one is. Precondition: it is not old.
  bool hear(const Message& message);
  bool has_heard() const { return heard_; }
  /// Of the other, as it was heard last.
  const Claim& claim() const { return claim_; }

  /// The message with the own claim, without an answer; it is sent now. `beat`: until a claim that
  /// is new is told again.
  Message tell(Claim own, std::uint64_t number, MissionTime now, Duration beat);
  /// The own claim is this now: what was told before counts as not arrived if it was another.
  void claims(const Claim& own, Duration beat);
  /// When the claim is to be told again; nothing: it has arrived.
  std::optional<MissionTime> due() const;
  bool is_due(MissionTime now) const { return !arrived_ && again_.is_due(now); }
  /// It was told again without having been changed: the pause doubles, up to this.
  void told_again(MissionTime now, Duration pause) { again_.repeated(now, pause); }

 private:
  bool heard_ = false;
  std::uint64_t number_ = 0;   ///< of the other's last message
  Claim claim_;                ///< of the other
  std::uint64_t version_ = 0;  ///< of that claim; 0: from the witness, or none

  Claim told_;                      ///< the own claim, as the other was told it last
  std::uint64_t told_version_ = 0;  ///< of that; 0: none was told
  bool arrived_ = false;            ///< the other has said so
  Repeats again_;                   ///< until it has
};

}  // namespace skein::merging
