// SPDX-License-Identifier: Apache-2.0
// Status of a UAV in a joint task, as sent to its partners and to the ground.
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
  kLoaded,   ///< agreed; waits for its start
  kRunning,
  kLeaving,  ///< the running parts of its role are being stopped
  kEnded,
  kAborted,
  kNotLoaded,  ///< the negotiation failed
};
/// "loading", "loaded", "running", "leaving", "ended", "aborted", "not-loaded".
std::string_view to_text(JointPhase phase);
/// Whether the phase is final.
constexpr bool is_over(JointPhase phase) { return phase >= JointPhase::kEnded; }

struct JointTaskStatus {
  std::string uav;
  std::string subject;     ///< the same at all participants
  std::uint64_t task = 0;  ///< id in the UAV's own executive
  std::string model;       ///< type of the joint task
  std::string variant;
  ModelHash hash;
  JointPhase phase = JointPhase::kLoading;
  std::string why;                             ///< of kLeaving, kAborted, kNotLoaded
  std::map<std::string, std::string> holders;  ///< role by UAV, as agreed last
  std::vector<std::string> active_blocks;      ///< of its role, in document order
  std::vector<std::string> violated;           ///< SCMs
  /// Of kLoading: until when at most it waits for an earlier joint task, or was to begin.
  std::optional<MissionTime> agreed_start;
  /// Once the UAV has an agreed share of an area: a row `round`, how often the area was shared, and
  /// a row `left` with the corners of each convex piece that it has still to map.
  /// While it needs its partners, a row `silent` for each that it has not heard for half a minute.
  Rows left;
  bool operator==(const JointTaskStatus&) const = default;
};

}  // namespace skein::interaction
