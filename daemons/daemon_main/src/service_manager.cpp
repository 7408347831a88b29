// SPDX-License-Identifier: Apache-2.0
#include "service_manager.hpp"

#include <systemd/sd-daemon.h>

#include <cstdint>
#include <string>

namespace skein::daemon_main {

namespace {

const char* status_of(wire::ClockPhase phase) {
  switch (phase) {
    case wire::ClockPhase::kHolding:
      return "waiting for the mission to start";
    case wire::ClockPhase::kRunning:
      return "mission running";
    case wire::ClockPhase::kFinished:
      return "mission over";
    default:
      return "";
  }
}

}  // namespace

ServiceManager::ServiceManager() {
  std::uint64_t interval = 0;  // [us]
  if (sd_watchdog_enabled(0, &interval) > 0) {
    period_ = Duration::nanoseconds(static_cast<std::int64_t>(interval) * 1000 / 2);
  }
}

ServiceManager::~ServiceManager() {
  if (said_) sd_notify(0, "STOPPING=1");
}

void ServiceManager::turn(wire::ClockPhase phase, Duration steady) {
  if (said_ != phase) {
    const std::string ready = said_ ? "" : "READY=1\n";
    sd_notify(0, (ready + "STATUS=" + status_of(phase)).c_str());
    said_ = phase;
  }
  if (period_ == Duration() || steady < next_) return;
  sd_notify(0, "WATCHDOG=1");
  next_ = steady + period_;
}

}  // namespace skein::daemon_main
