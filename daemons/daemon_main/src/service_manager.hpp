// SPDX-License-Identifier: Apache-2.0
// What a daemon tells the service manager that started it (systemd: Type=notify, WatchdogSec).
#pragma once

#include <optional>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/time.hpp"

namespace skein::daemon_main {

/// Says that the daemon is ready at its first turn, what it does whenever that changes, that it
/// lives twice in every watchdog interval, and at the end that it stops. Says nothing to anybody
/// when no service manager listens (NOTIFY_SOCKET is not set).
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
