// SPDX-License-Identifier: Apache-2.0
// Frontiers of plans: wire to domain and back.
#pragma once

#include "skein/blackboard/wire.hpp"
#include "skein/temporal/frontier.hpp"
#include "skein/translation/journal_lines.hpp"
#include "skein/translation/missions.hpp"

namespace skein::translation {

/// Lines of kind `frontier`: who tells whom what lies between the meetings of a UAV, or when that
/// comes. `node` is who writes it.
journal::Record frontier_told(const Writer& writer, const std::string& node, const std::string& to,
                              const std::string& about, const temporal::Frontier& frontier);
journal::Record frontier_heard(const Writer& writer, const std::string& node,
                               const std::string& from, const std::string& about);

wire::PlanFrontier to_wire(const std::string& uav, const temporal::Frontier& frontier);
/// Refuses an invalid frontier (temporal::fault_of), with the fault.
Read<temporal::Frontier> from_wire(const wire::PlanFrontier& sample);

}  // namespace skein::translation
