// SPDX-License-Identifier: Apache-2.0
// Commands that another program carries out.
#pragma once

namespace skein::cli {

/// Replaces this process by the program beside it that carries out the command argv[1], with the
/// same arguments. Returns only on failure, with the exit code, after printing the reason.
int carry_out_elsewhere(int argc, char** argv);

}  // namespace skein::cli
