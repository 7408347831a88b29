// SPDX-License-Identifier: Apache-2.0
// Check report of models, for programs.
#pragma once

#include <string>
#include <vector>

#include "skein/interaction/read_library.hpp"

namespace skein::model_tool {

/// The one JSON object that `skein model check --json` prints of these files and all they use, each
/// read by `read`: {"right": …, "errors": […], …}.
std::string check_report(const std::vector<std::string>& files, const interaction::ReadFile& read);

}  // namespace skein::model_tool
