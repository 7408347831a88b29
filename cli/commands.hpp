// SPDX-License-Identifier: Apache-2.0
// The command line of `skein`.
#pragma once

namespace skein::cli {

struct LiveActions;

/// Parses and runs; returns the exit code. Never throws.
int run_command_line(int argc, char** argv, const LiveActions& live);

}  // namespace skein::cli
