// SPDX-License-Identifier: Apache-2.0
// The link to an autopilot: UDP or a serial line.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"

namespace skein::mavlink_node {

/// A non-blocking link. Data that cannot be sent is lost, as on any radio; the bridge repeats it.
class Link {
 public:
  /// `address`:
  /// - `udpin:PORT`, `udpin:ADDRESS:PORT`: waits there for a vehicle, and sends to the last sender
  /// - `udp:ADDRESS:PORT`: sends to the vehicle first
  /// - `serial:DEVICE`, `serial:DEVICE:BAUD`: 57600 baud by default
  /// Addresses are IPv4; udpin listens on 127.0.0.1 if no address is given.
  static Result<std::unique_ptr<Link>, Failure> open(const std::string& address);
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link();

  /// Received bytes, at most 64 KiB; empty: none.
  virtual std::vector<std::uint8_t> receive() = 0;
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  /// File descriptor, to wait until it is readable.
  int descriptor() const { return descriptor_; }

 protected:
  explicit Link(int descriptor) : descriptor_(descriptor) {}

 private:
  int descriptor_;
};

}  // namespace skein::mavlink_node
