// SPDX-License-Identifier: Apache-2.0
// skein-refine: `skein refine` and `skein terrain`, apart because they load libraries of maps and
// motion planning that no other command needs. `skein` starts it.
#include "actions.hpp"
#include "commands.hpp"
#include "on_streams.hpp"
#include "skein/refine_tool/refine.hpp"
#include "skein/terrain_tool/terrain.hpp"

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::Actions actions(cli::start_skein_instead);
  actions.add(cli::on_streams(refine_tool::run_refine));
  actions.add(cli::on_streams(terrain_tool::make_terrain));
  actions.add(cli::on_streams(terrain_tool::show_terrain));
  return cli::run_command_line(argc, argv, actions);
}
