// SPDX-License-Identifier: Apache-2.0
// Properties of requests.
#pragma once

#include <optional>
#include <string>

#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// "START 3 goto", "ABORT 3", "PROCESS-MSG go", "UPDATE-COND 3", "SUPPRESS 3",
/// "MISSION 2 (3 tasks)", "CANCEL 701", "DEGREE 1", "CLOSE tower", "OPEN tower".
std::string what_of(const Request& request);

/// The task that a START adds; absent for other requests.
std::optional<executive::TaskId> started_by(const Request& request);

/// The request as input of an executive; absent if only a decision node can answer it.
std::optional<executive::Input> to_executive(const Request& request);

/// The existing task that an ABORT, UPDATE-COND or SUPPRESS names; absent for other requests.
std::optional<executive::TaskId> named_by(const Request& request);

/// Whether tasks of the type are carried out by the functional layer, not by the executive or a
/// supervisor.
bool is_functional(const std::string& type);

}  // namespace skein::ground_station
