// SPDX-License-Identifier: Apache-2.0
// skein-sim: the functional simulator, and the leader of mission time.
#include "skein/daemon_main/daemon_main.hpp"

int main(int argc, char** argv) {
  return skein::daemon_main::run_daemon_program(
      {"skein-sim", "Skein's functional simulator: vehicles, sensors, world and radio, over DDS",
       "sim", true},
      argc, argv);
}
