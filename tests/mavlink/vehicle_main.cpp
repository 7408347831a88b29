// SPDX-License-Identifier: Apache-2.0
// The tests' MAVLink vehicle as a program of its own, where a UAV of a scenario starts:
//   skein_mavlink_vehicle SCENARIO UAV px4|ardupilot LINK RATE
// LINK as of skein-mavlink; RATE: how much faster than the clock it lives. It ends when told to.
#include <poll.h>

#include <cstdlib>
#include <iostream>

#include "skein/mavlink_node/link.hpp"
#include "skein/node/waker.hpp"
#include "skein/scenario/scenario.hpp"
#include "vehicle/mavlink_vehicle.hpp"

namespace {

using namespace skein;  // NOLINT(google-build-using-namespace): a program, not a header

int live(autopilot::testing::MavlinkVehicle& vehicle, mavlink_node::Link& link, double rate) {
  const Duration start = node::Waker::steady_now();
  for (;;) {
    pollfd file{link.descriptor(), POLLIN, 0};
    poll(&file, 1, static_cast<int>(100 / rate));
    vehicle.hear(link.receive());
    const double lived = (node::Waker::steady_now() - start).to_seconds() * rate;
    for (const mavlink::Bytes& bytes : vehicle.step(Duration::seconds(lived))) link.send(bytes);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  const auto scenario = scenario::read_scenario(argv[1]);
  const auto dialect = autopilot::dialect_from(argv[3]);
  auto link = mavlink_node::Link::open(argv[4]);
  const scenario::UavSpec* uav = scenario ? scenario->find_uav(argv[2]) : nullptr;
  if (uav == nullptr || !dialect || !link) {
    std::cerr << "no such scenario, UAV, dialect or link\n";
    return 2;
  }
  autopilot::testing::MavlinkVehicleConfig config{
      .model = uav->model,
      .terrain = world::Terrain(scenario->world.terrain),
      .origin = scenario->world.origin};
  config.dialect = *dialect;
  config.start = uav->start;
  autopilot::testing::MavlinkVehicle vehicle(config);
  return live(vehicle, **link, std::strtod(argv[5], nullptr));
}
