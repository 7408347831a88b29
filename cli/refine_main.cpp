// SPDX-License-Identifier: Apache-2.0
// skein-refine: `skein refine`, apart because it loads libraries of maps and motion planning that
// no other command needs.
#include <iostream>

#include "commands.hpp"
#include "live_commands.hpp"
#include "skein/refine_tool/refine.hpp"

int main(int argc, char** argv) {
  skein::cli::LiveActions live;
  live.refine = [](const skein::refine_tool::RefineOptions& options) {
    return skein::refine_tool::run_refine(options, std::cin, std::cout, std::cerr);
  };
  return skein::cli::run_command_line(argc, argv, live);
}
