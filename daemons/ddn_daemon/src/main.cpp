// SPDX-License-Identifier: Apache-2.0
// skein-ddn: the decision node of one UAV.
#include "skein/daemon_main/daemon_main.hpp"
#include "skein/ddn_setup/make_ddn.hpp"
#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/scenario_setup/setup.hpp"

int main(int argc, char** argv) {
  skein::daemon_main::DaemonProgram program{"skein-ddn",
                                            "Skein's decision node of one UAV, over DDS", ""};
  program.check = [](const skein::scenario::Scenario& scenario) {
    skein::Diagnostics problems = skein::scenario_setup::radio_problems(scenario);
    problems.append(skein::deliberation_setup::planning_problems(scenario));
    return problems;
  };
  program.make = [](const skein::scenario::Scenario& scenario, const std::string& name) {
    return skein::ddn_setup::make_ddn(scenario, *scenario.find_uav(name));
  };
  return skein::daemon_main::run_daemon_program(program, argc, argv);
}
