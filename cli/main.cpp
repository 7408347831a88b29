// SPDX-License-Identifier: Apache-2.0
// skein: everything that is not a daemon.
#include "commands.hpp"

int main(int argc, char** argv) { return skein::cli::run_command_line(argc, argv); }
