// SPDX-License-Identifier: Apache-2.0
// skein-ground: the ground station.
#include "skein/daemon_main/daemon_main.hpp"
#include "skein/deliberation_setup/knowledge.hpp"
#include "skein/ground_companions/mavlink_station.hpp"
#include "skein/ground_companions/operators_page.hpp"
#include "skein/ground_companions/ros2_topics.hpp"
#include "skein/ground_setup/make_ground.hpp"
#include "skein/scenario_setup/setup.hpp"

int main(int argc, char** argv) {
  skein::ground_companions::OperatorsPage page;
  skein::ground_companions::MavlinkStation station;
  skein::ground_companions::Ros2Topics topics;
  skein::daemon_main::DaemonProgram program{"skein-ground", "Skein's ground station, over DDS",
                                            "ground"};
  program.check = [](const skein::scenario::Scenario& scenario) {
    skein::Diagnostics problems = skein::scenario_setup::radio_problems(scenario);
    problems.append(skein::deliberation_setup::planning_problems(scenario));
    problems.append(skein::deliberation_setup::joint_task_problems(scenario));
    return problems;
  };
  program.make = [](const skein::scenario::Scenario& scenario, const std::string&) {
    return skein::ground_setup::make_ground(scenario);
  };
  program.companions = {&page, &station, &topics};
  return skein::daemon_main::run_daemon_program(program, argc, argv);
}
