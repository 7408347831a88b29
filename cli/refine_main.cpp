// SPDX-License-Identifier: Apache-2.0
// skein-refine: `skein refine` and `skein terrain`, apart because they load libraries of maps and
// motion planning that no other command needs.
#include <iostream>

#include "commands.hpp"
#include "live_commands.hpp"
#include "skein/refine_tool/refine.hpp"
#include "skein/terrain_tool/terrain.hpp"

int main(int argc, char** argv) {
  skein::cli::LiveActions live;
  live.refine = [](const skein::refine_tool::RefineOptions& options) {
    return skein::refine_tool::run_refine(options, std::cin, std::cout, std::cerr);
  };
  live.make_terrain = [](const skein::terrain_tool::MakeOptions& options) {
    return skein::terrain_tool::make_terrain(options, std::cout, std::cerr);
  };
  live.show_terrain = [](const skein::terrain_tool::ShowOptions& options) {
    return skein::terrain_tool::show_terrain(options, std::cout, std::cerr);
  };
  return skein::cli::run_command_line(argc, argv, live);
}
