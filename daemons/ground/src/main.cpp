// SPDX-License-Identifier: Apache-2.0
// skein-ground: the ground station.
#include "skein/daemon_main/daemon_main.hpp"

int main(int argc, char** argv) {
  return skein::daemon_main::run_daemon_program(
      {"skein-ground", "Skein's ground station, over DDS", "ground"}, argc, argv);
}
