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
/// carries no more. It is left out too while it may still be on its way, since messages come in
/// their order: the other has it then, or takes what comes behind it as lost. Times never decrease.
/// A value. Source: docs/decisions/0088-air-is-told-once.md, 0109-air-on-its-way.md.
class Exchange {
 public:
  /// After so long a message has arrived or expired (lifespan of the slot, scenarios/slots.yaml).
  static constexpr Duration kOnItsWay = Duration::milliseconds(2'000);

  /// Whether a message came after later ones, or once more.
  bool is_old(const Message& message) const { return message.number <= number_; }
  /// The other said this, or the witness passed it on. False: the message leaves out a claim that
  /// is not known here, so the other has to hear which one is. Precondition: it is not old.
  bool hear(const Message& message, MissionTime now);
  bool has_heard() const { return heard_; }
  /// Of the other, as it was heard last.
  const Claim& claim() const { return claim_; }

  /// How long it took until a claim that was told once was known to have arrived, as of the last
  /// one; 0 before.
  Duration round_trip() const { return round_trip_; }

  /// The message with the own claim, without an answer; it is sent now. `beat`: until a claim that
  /// is new is told again.
  Message tell(Claim own, std::uint64_t number, MissionTime now, Duration beat);
  /// The own claim is this now: what was told before counts as not arrived if it was another.
  void claims(const Claim& own, Duration beat);
  /// The other is out of reach: what is on its way may not arrive.
  void is_cut() { on_its_way_until_ = {}; }
  /// When the claim is to be told again; nothing: it has arrived.
  std::optional<MissionTime> due() const;
  bool is_due(MissionTime now) const { return !arrived_ && *due() <= now; }
  /// It was told again without having been changed: the pause doubles, up to this.
  void told_again(MissionTime now, Duration pause) { again_.repeated(now, pause); }

 private:
  bool heard_ = false;
  std::uint64_t number_ = 0;   ///< of the other's last message
  Claim claim_;                ///< of the other
  std::uint64_t version_ = 0;  ///< of that claim; 0: from the witness, or none
  bool lacks_ = false;         ///< it left out another version

  Claim told_;                      ///< the own claim, as the other was told it last
  std::uint64_t told_version_ = 0;  ///< of that; 0: none was told
  bool arrived_ = false;            ///< the other has said so
  int in_full_ = 0;                 ///< times that it was told in full
  MissionTime told_at_;             ///< the first time
  Duration round_trip_;
  MissionTime on_its_way_until_;  ///< or has expired
  Repeats again_;                 ///< until it has
};

}  // namespace skein::merging
