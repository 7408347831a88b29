// SPDX-License-Identifier: Apache-2.0
// Faults of the definition of an STNU, and references to its links.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "skein/temporal/network.hpp"

namespace skein::temporal {

enum class LinkKind : std::uint8_t { kRequirement, kContingent };

/// A link of an `Stnu`: a position in `arcs` or in `contingent`.
struct LinkRef {
  LinkKind kind = LinkKind::kRequirement;
  std::uint32_t index = 0;
  auto operator<=>(const LinkRef&) const = default;
};

enum class StnuFault : std::uint8_t {
  kUnknownLink,            ///< a change of a link that is not there
  kUnknownNode,            ///< a link, or the origin, names a node that is not there
  kEmptyInterval,          ///< min > max, or min = +∞, or max = -∞
  kContingentNotPositive,  ///< contingent link with min <= 0
  kContingentUnbounded,    ///< contingent link with max = ∞
  kContingentLoop,         ///< contingent link from a node to itself
  kSharedContingentEnd,    ///< two contingent links end in one node
  kOverflow,  ///< a finite bound, or a distance that follows from them, leaves ±2·kLargest
  kContingentOrigin,  ///< the origin, whose date is 0, is the end of a contingent link
  kNotControllable,   ///< no dispatchable form exists
};

struct StnuError {
  StnuFault fault = StnuFault::kUnknownNode;
  std::optional<LinkRef> link;  ///< absent when no single link is at fault
  bool operator==(const StnuError&) const = default;
};

/// The first fault in the order arcs, contingent links; absent when the network is well formed. O(n
/// + m).
std::optional<StnuError> find_fault(const Stnu& network);

/// The fault of one arc, in a network of so many nodes.
std::optional<StnuFault> find_fault(const Arc& arc, std::size_t nodes);

/// The fault of one contingent link by itself, in a network of so many nodes.
std::optional<StnuFault> find_fault(const ContingentLink& link, std::size_t nodes);

/// "contingent link a -> b: …", with the names of the network; for people.
std::string to_text(const StnuError& error, const Stnu& network);
std::string to_text(StnuFault fault);

}  // namespace skein::temporal
