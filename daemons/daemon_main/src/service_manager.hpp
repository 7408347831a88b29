// SPDX-License-Identifier: Apache-2.0
// Notifications to the service manager of a daemon (systemd: Type=notify, WatchdogSec).
#pragma once

#include <optional>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::daemon_main {

/// Sends READY at the first turn, STATUS whenever it changes, WATCHDOG twice in every watchdog
/// interval, and STOPPING at the end. Sends nothing without a service manager (NOTIFY_SOCKET not
/// set).
class ServiceManager {
 public:
  ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;
  ~ServiceManager();

  /// `steady`: monotonic time, from any origin.
  void turn(wire::ClockPhase phase, Duration steady);

 private:
  Duration period_;  ///< between two signs of life; zero: none is wanted
  Duration next_;
  std::optional<wire::ClockPhase> said_;
};

}  // namespace skein::daemon_main
