// SPDX-License-Identifier: Apache-2.0
// What others need to know of the network of a plan, on the wire.
#pragma once

#include "skein/blackboard/wire.hpp"
#include "skein/temporal/frontier.hpp"
#include "skein/translation/missions.hpp"

namespace skein::translation {

wire::PlanFrontier to_wire(const std::string& uav, const temporal::Frontier& frontier);
/// Refused with what makes it no frontier.
Read<temporal::Frontier> from_wire(const wire::PlanFrontier& sample);

}  // namespace skein::translation
