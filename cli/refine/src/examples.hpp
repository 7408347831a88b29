// SPDX-License-Identifier: Apache-2.0
// A query of each service that runs as it is, with its world and vehicle inside.
#pragma once

#include <string>
#include <string_view>

namespace skein::refine_tool {

/// Empty when there is no such service.
std::string example_of(std::string_view service);

}  // namespace skein::refine_tool
