// SPDX-License-Identifier: Apache-2.0
// What a request is about.
#pragma once

#include <optional>
#include <string>

#include "skein/ground_station/messages.hpp"

namespace skein::ground_station {

/// "START 3 goto", "ABORT 3", "PROCESS-MSG go", "UPDATE-COND 3", "SUPPRESS 3".
std::string what_of(const Request& request);

/// The task that a START brings; nothing for another request.
std::optional<executive::TaskId> started_by(const Request& request);

/// The task, already there, that an ABORT, UPDATE-COND or SUPPRESS names; nothing for another.
std::optional<executive::TaskId> named_by(const Request& request);

}  // namespace skein::ground_station
