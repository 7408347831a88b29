// SPDX-License-Identifier: Apache-2.0
// A TUN network interface.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"

namespace skein::air {

/// A TUN device in a network namespace of ours; it is gone with this object. Reading and writing
/// do not block.
class Tunnel {
 public:
  /// `name`: of the interface; `space`: file of the namespace ("/run/netns/marvin"). The calling
  /// thread is in its own namespace again afterwards.
  static Result<Tunnel, Failure> open(const std::string& space, const std::string& name);
  Tunnel(Tunnel&& other) noexcept;
  Tunnel& operator=(Tunnel&& other) noexcept;
  ~Tunnel();

  int descriptor() const { return descriptor_; }
  /// One packet; empty if there is none.
  std::vector<std::uint8_t> read();
  /// False if the packet was not accepted: the interface is down, or its queue is full.
  bool write(std::span<const std::uint8_t> packet);

 private:
  explicit Tunnel(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace skein::air
