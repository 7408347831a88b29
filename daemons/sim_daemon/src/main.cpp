// SPDX-License-Identifier: Apache-2.0
// skein-sim: the functional simulator, and the leader of mission time.
#include "skein/daemon_main/daemon_main.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "skein/sim_setup/make_sim.hpp"

int main(int argc, char** argv) {
  skein::daemon_main::DaemonProgram program{
      "skein-sim", "Skein's functional simulator: vehicles, sensors, world and radio, over DDS",
      "sim", true};
  program.check = [](const skein::scenario::Scenario& scenario) {
    skein::Diagnostics problems = skein::sim_setup::simulation_problems(scenario);
    problems.append(skein::scenario_setup::radio_problems(scenario));
    return problems;
  };
  program.make = skein::sim_setup::make_sim;
  return skein::daemon_main::run_daemon_program(program, argc, argv);
}
