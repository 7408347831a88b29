// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_companions/mavlink_station.hpp"

#include <CLI/CLI.hpp>

#include "skein/mavlink_out/mavlink_out.hpp"

namespace skein::ground_companions {

void MavlinkStation::declare(CLI::App& app) {
  app.add_option("--mavlink-out", address_,
                 "Tell a ground station that speaks MAVLink where everybody is: "
                 "udp:ADDRESS:PORT, udpin:PORT or serial:DEVICE:BAUD");
  app.add_option("--geoid", geoid_,
                 "Height of the sea over the ellipsoid there [m], for heights of --mavlink-out")
      ->check(CLI::Range(-200.0, 200.0));
}

Result<daemon_main::CompanionSource::Opened, Failure> MavlinkStation::open(
    const daemon_main::Surroundings& surroundings) {
  if (address_.empty()) return Opened{};
  auto config = mavlink_out::announcer_config_of(surroundings.scenario, geoid_);
  if (!config) return failure("--mavlink-out: " + config.error().why);
  auto out = mavlink_out::MavlinkOut::open(address_, std::move(*config));
  if (!out) return failure("--mavlink-out: " + out.error().why);
  return Opened{std::move(*out), "telemetry by MAVLink to " + address_};
}

}  // namespace skein::ground_companions
