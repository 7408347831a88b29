// SPDX-License-Identifier: Apache-2.0
// The page's style sheet and script, embedded from assets/ when building.
#pragma once

#include <string_view>

namespace skein::report {

extern const std::string_view kReportCss;
extern const std::string_view kReportJs;

}  // namespace skein::report
