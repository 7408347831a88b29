// SPDX-License-Identifier: Apache-2.0
// skein-ddn: the decision node of one UAV.
#include "skein/daemon_main/daemon_main.hpp"

int main(int argc, char** argv) {
  return skein::daemon_main::run_daemon_program(
      {"skein-ddn", "Skein's decision node of one UAV, over DDS", ""}, argc, argv);
}
