// SPDX-License-Identifier: Apache-2.0
// What the page posts.
#pragma once

#include <string>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/result.hpp"

namespace skein::console {

/// The request that a body says, {"who": …, "number": …, "actions": […]}, or every problem.
Result<wire::OperatorRequest, std::vector<std::string>> request_of(const std::string& body);

}  // namespace skein::console
