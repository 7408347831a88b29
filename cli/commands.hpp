// SPDX-License-Identifier: Apache-2.0
// The command line of `skein`.
#pragma once

namespace skein::cli {

class Actions;

/// What a program of `skein` answers to a command that another carries out.
int start_skein_instead();

/// Parses and runs; returns the exit code. Never throws.
int run_command_line(int argc, char** argv, const Actions& actions);

}  // namespace skein::cli
