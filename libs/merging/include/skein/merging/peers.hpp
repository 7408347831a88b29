// SPDX-License-Identifier: Apache-2.0
// The other members, as far as one knows them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/merging/exchange.hpp"

namespace skein::merging {

struct Peer {
  bool earlier = false;  ///< in the roster: it decides between the two
  bool needed = false;   ///< nothing is had without its word, or the witness's
  bool reachable = true;
  Exchange exchange;
  std::uint64_t answered = 0;  ///< its last request that was answered here
  bool granted = false;        ///< the answer to that request
  bool agreed = false;         ///< it has granted the open request of this member
  /// It has answered a request in this life, or this is the first life: no promise to it is
  /// forgotten.
  bool known = false;
  std::optional<MissionTime> wants_since;

  const Claim& claim() const { return exchange.claim(); }
  /// It holds more than the air of one place.
  bool flies() const { return claim().held.size() > 1; }
};

/// By name.
class Peers {
 public:
  /// All of `members` but `self`, in whose order the earlier decides. Precondition: no duplicates;
  /// `self` is among them.
  Peers(const std::vector<std::string>& members, const std::string& self, bool with_witness);

  auto begin() { return all_.begin(); }
  auto end() { return all_.end(); }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  /// Null: it is none.
  Peer* find(const std::string& name);
  const Peer* find(const std::string& name) const;

  /// What they hold, were granted, or want (asked for or not).
  Volumes others() const;
  /// What they hold or have asked for, granted or not; of those in `wanting` also what they want
  /// without having asked for it.
  Volumes taken(const std::vector<std::string>& wanting = {}) const;
  /// Where each stays, or will stay at the end of its way.
  Volumes ends() const;
  /// The greatest round trip to one in reach that has not agreed.
  Duration slowest() const;
  /// Whether one that is in reach is under way.
  bool flies(const std::string& name) const;

 private:
  std::map<std::string, Peer> all_;
};

}  // namespace skein::merging
