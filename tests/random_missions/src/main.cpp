// SPDX-License-Identifier: Apache-2.0
// skein_random_missions: draws missions, plays them in virtual time, judges them by the laws.
#include "random_missions/command.hpp"

int main(int argc, char** argv) { return skein::mission_lab::command(argc, argv); }
