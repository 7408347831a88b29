// SPDX-License-Identifier: Apache-2.0
// skein-live: the commands of `skein` that meet running daemons, or what they left. `skein` starts
// it.
#include "actions.hpp"
#include "commands.hpp"
#include "on_streams.hpp"
#include "skein/functional_tool/functional.hpp"
#include "skein/operate_tool/operate.hpp"
#include "skein/replay_tool/replay.hpp"
#include "skein/spy_tool/record.hpp"
#include "skein/spy_tool/spy.hpp"
#include "skein/state_tool/state.hpp"

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::Actions actions(cli::start_skein_instead);
  actions.add(cli::on_streams(functional_tool::check));
  actions.add(cli::on_streams(state_tool::state));
  actions.add(cli::on_streams(operate_tool::operate));
  actions.add(cli::on_streams(operate_tool::status));
  actions.add(cli::on_streams(replay_tool::replay));
  actions.add(cli::on_streams(spy_tool::spy));
  actions.add(cli::on_streams(spy_tool::record));
  actions.add(cli::on_streams(spy_tool::play));
  return cli::run_command_line(argc, argv, actions);
}
