// SPDX-License-Identifier: Apache-2.0
// MAVLink telemetry of the team for foreign ground stations, from the process of our ground
// station.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "skein/foundation/result.hpp"
#include "skein/mavlink_node/link.hpp"
#include "skein/mavlink_out/announcer.hpp"
#include "skein/node/companion.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::mavlink_out {

/// Configuration from the vehicles of a scenario, or the reason why it cannot be made.
Result<AnnouncerConfig, Failure> announcer_config_of(const scenario::Scenario& scenario,
                                                     double geoid);

/// Sends the telemetry received by the ground station as MAVLink. Output only: messages of the
/// other station are read and dropped. Alarms, decisions, refusals and failures on board are sent
/// as texts. Never blocks; data that the network does not accept is lost.
class MavlinkOut final : public node::Companion {
 public:
  /// `address`: as of skein-mavlink: "udp:ADDRESS:PORT", "udpin:PORT", "serial:DEVICE:BAUD".
  static Result<std::unique_ptr<MavlinkOut>, Failure> open(const std::string& address,
                                                           AnnouncerConfig config);

  void attach(std::function<void()>) override {}
  void detach() override {}
  std::string speaks_as() const override { return "operator"; }
  std::vector<wire::Sample> take() override { return {}; }
  void sees(const wire::Sample& sample) override;
  void sees(const journal::Record& record) override;
  void turn(const node::DaemonState& state) override;

 private:
  MavlinkOut(std::unique_ptr<mavlink_node::Link> link, AnnouncerConfig config);
  void take_telemetry(const wire::Telemetry& telemetry);
  void take_decisions(const wire::UavTasks& tasks);

  std::unique_ptr<mavlink_node::Link> link_;
  Announcer announcer_;
  Duration now_{};                                          ///< steady, of the last turn
  std::map<std::string, std::uint64_t> decided_;            ///< last decision told, by UAV
  std::map<std::string, std::vector<std::string>> failed_;  ///< devices, by UAV
};

}  // namespace skein::mavlink_out
