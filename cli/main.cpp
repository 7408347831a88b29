// SPDX-License-Identifier: Apache-2.0
// skein: everything that is not a daemon. It knows every command and plans itself; for all others
// it becomes the program beside it that carries them out: loading their libraries costs more than
// most plans, and who wants to fly one mission need not compile them all.
#include "actions.hpp"
#include "commands.hpp"
#include "elsewhere.hpp"
#include "plan_process.hpp"
#include "skein/plan_tool/plan.hpp"

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::Actions actions([argc, argv] { return cli::carry_out_elsewhere(argc, argv); });
  actions.add<plan_tool::PlanOptions>(cli::plan_here);
  return cli::run_command_line(argc, argv, actions);
}
