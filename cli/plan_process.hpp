// SPDX-License-Identifier: Apache-2.0
// `skein plan` in this process: its clock, memory, terminal and Ctrl-C.
#pragma once

namespace skein::plan_tool {
struct PlanOptions;
}

namespace skein::cli {

/// Plans; without a limit of memory in the options, up to three quarters of what is available, or
/// of what the process may have. Returns the exit code.
int plan_here(const plan_tool::PlanOptions& options);

}  // namespace skein::cli
