// SPDX-License-Identifier: Apache-2.0
// Where a UAV stands in a joint task, as it tells its partners and the ground.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/negotiation/terms.hpp"

namespace skein::interaction {

enum class JointPhase : std::uint8_t {
  kLoading,  ///< roles and start are negotiated
  kLoaded,   ///< agreed; it waits to be due
  kRunning,
  kLeaving,  ///< what runs of its role is being stopped
  kEnded,
  kAborted,
  kNotLoaded,  ///< nothing was agreed
};
/// "loading", "loaded", "running", "leaving", "ended", "aborted", "not-loaded".
std::string_view to_text(JointPhase phase);
/// Nothing more comes of it.
constexpr bool is_over(JointPhase phase) { return phase >= JointPhase::kEnded; }

struct JointTaskStatus {
  std::string uav;
  std::string subject;     ///< the same at all who take part
  std::uint64_t task = 0;  ///< of its own executive
  std::string model;       ///< type of the joint task
  std::string variant;
  ModelHash hash;
  JointPhase phase = JointPhase::kLoading;
  std::string why;                             ///< of kLeaving, kAborted, kNotLoaded
  std::map<std::string, std::string> holders;  ///< UAV: role, as agreed last
  std::vector<std::string> active_blocks;      ///< of its role, in document order
  std::vector<std::string> violated;           ///< SCMs
  std::optional<MissionTime> agreed_start;
  /// Of its share of an area, once one is agreed: `round`, how many times it was shared; a row
  /// `left` for each convex piece that it has still to map, its corners.
  Rows left;
  bool operator==(const JointTaskStatus&) const = default;
};

}  // namespace skein::interaction
