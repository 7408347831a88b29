// SPDX-License-Identifier: Apache-2.0
// Ids of links that only the forecast networks ("courses") of a plan have.
#pragma once

#include "skein/temporal/live_stn.hpp"

namespace skein::supervisor {

/// Kinds of such links: holds, waits for instants, implied bounds.
inline constexpr temporal::LiveStn::LinkId kHeldUntil = temporal::LiveStn::LinkId{1} << 40U;
inline constexpr temporal::LiveStn::LinkId kHeldBehind = temporal::LiveStn::LinkId{1} << 41U;
inline constexpr temporal::LiveStn::LinkId kPresentLink = temporal::LiveStn::LinkId{1} << 42U;
inline constexpr temporal::LiveStn::LinkId kImplied = temporal::LiveStn::LinkId{1} << 43U;
inline constexpr temporal::LiveStn::LinkId kHeldAfter = temporal::LiveStn::LinkId{1} << 44U;

inline temporal::LiveStn::LinkId between(temporal::LiveStn::LinkId kind, temporal::NodeIndex from,
                                         temporal::NodeIndex to) {
  return kind | (temporal::LiveStn::LinkId{from} << 20U) | temporal::LiveStn::LinkId{to};
}

}  // namespace skein::supervisor
