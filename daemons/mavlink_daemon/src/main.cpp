// SPDX-License-Identifier: Apache-2.0
// skein-mavlink: the functional layer of a vehicle whose autopilot speaks MAVLink.
#include "crew.hpp"
#include "skein/scenario_setup/setup.hpp"

int main(int argc, char** argv) {
  skein::mavlink_node::Settings settings;
  skein::daemon_main::DaemonProgram program{
      "skein-mavlink", "Skein's bridge to an autopilot that speaks MAVLink 2, over DDS", ""};
  program.options = {
      {"--connect", "Where the autopilot is: udpin:PORT, udp:ADDRESS:PORT, serial:DEVICE:BAUD",
       &settings.connect},
      {"--dialect", "px4, ardupilot, or auto: as the autopilot says", &settings.dialect},
      {"--system-id", "Of the vehicle, 1 to 255, or any: the first that is heard",
       &settings.system_id},
      {"--own-id", "System id of this bridge, 1 to 255", &settings.own_id},
      {"--camera", "Component that takes pictures; 1: by the autopilot's trigger",
       &settings.camera}};
  program.check = skein::scenario_setup::radio_problems;
  program.crew = [&](const skein::scenario::Scenario& scenario, const std::string& uav) {
    return skein::mavlink_daemon::crew_of(scenario, uav, settings);
  };
  return skein::daemon_main::run_daemon_program(program, argc, argv);
}
