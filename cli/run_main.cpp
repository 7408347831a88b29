// SPDX-License-Identifier: Apache-2.0
// skein-run: plays a mission, over DDS or in virtual time. `skein` starts it.
#include "actions.hpp"
#include "commands.hpp"
#include "on_streams.hpp"
#include "skein/run_tool/run.hpp"

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::Actions actions(cli::start_skein_instead);
  actions.add(cli::on_streams(run_tool::run));
  actions.add(cli::on_streams(run_tool::report));
  return cli::run_command_line(argc, argv, actions);
}
