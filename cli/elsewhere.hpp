// SPDX-License-Identifier: Apache-2.0
// Commands that another program carries out.
#pragma once

namespace skein::cli {

/// Becomes the program beside this one that carries out the command argv[1], with the same
/// arguments. Returns only if that cannot be: the exit code, when why has been said.
int carry_out_elsewhere(int argc, char** argv);

}  // namespace skein::cli
