// SPDX-License-Identifier: Apache-2.0
// Capture of the UDP datagrams that pass an interface of this machine.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "skein/foundation/result.hpp"

namespace skein::blackboard::passive {

/// A ring of 16 MiB that the kernel fills (AF_PACKET, TPACKET_V3); nobody is woken for a packet.
/// Needs CAP_NET_RAW. Datagrams that IP cuts up are not shown.
class PacketRing {
 public:
  /// To these UDP ports, over the interface that has the address.
  static Result<PacketRing, Failure> open(const std::string& address, unsigned first_port,
                                          unsigned last_port);
  PacketRing(PacketRing&&) noexcept;
  PacketRing& operator=(PacketRing&&) noexcept;
  ~PacketRing();

  /// What has passed since the last call: its content, and when [ns since 1970].
  using Use = std::function<void(std::span<const std::uint8_t> datagram, std::int64_t heard)>;
  void take(const Use& use);
  /// Total number of datagrams dropped for lack of room.
  std::uint64_t lost();

 private:
  struct Impl;
  explicit PacketRing(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard::passive
