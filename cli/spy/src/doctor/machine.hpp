// SPDX-License-Identifier: Apache-2.0
// Facts about this machine that matter to DDS.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "finding.hpp"
#include "skein/blackboard/network.hpp"

namespace skein::spy_tool {

struct Interface {
  std::string name, address;
  bool up = false, multicast = false, loopback = false;
};

/// Files of Fast DDS in shared memory that no living process has open or mapped.
struct Leftovers {
  std::vector<std::string> names;
  std::uint64_t bytes = 0;
};

/// A snapshot of the machine.
struct MachineFacts {
  std::vector<Interface> interfaces;  ///< with an IPv4 address
  std::uint64_t receive_buffer = 0;   ///< greatest receive buffer of a socket [byte]
  std::uint64_t overflows = 0;        ///< UDP packets lost since the start for full buffers
  Leftovers leftovers;
  std::int64_t wall = 0;    ///< [ns since 1970]
  std::int64_t steady = 0;  ///< [ns]
};

MachineFacts look_at_machine(const std::string& shared_memory = "/dev/shm");

/// Tests whether a packet sent to the RTPS multicast group on the interface with this address comes
/// back to this machine; the failure describes what was refused. Takes up to half a second.
Result<void, Failure> try_multicast(const std::string& address);

/// Findings from snapshots before and after listening.
Findings judge_machine(const MachineFacts& before, const MachineFacts& after,
                       const blackboard::NetworkConfig& network);

}  // namespace skein::spy_tool
