// SPDX-License-Identifier: Apache-2.0
// The command line of skein_random_missions.
#pragma once

namespace skein::mission_lab {

/// Returns the exit code: 1 when a law was broken, 2 when a scenario or an option was refused.
int command(int argc, char** argv);

}  // namespace skein::mission_lab
