// SPDX-License-Identifier: Apache-2.0
// Exclusive use of a DDS domain on this machine.
#pragma once

#include <cstdint>
#include <memory>

#include "skein/foundation/result.hpp"

namespace skein::blackboard {

namespace rtps {
class NamedLock;
}

/// Reserves a DDS domain id until it is destroyed or the process ends; leaves no file. Other Skein
/// processes in the same network namespace cannot claim the same domain meanwhile.
class DomainLease {
 public:
  DomainLease(DomainLease&& other) noexcept;
  DomainLease& operator=(DomainLease&& other) noexcept;
  ~DomainLease();

  std::uint32_t domain() const { return domain_; }

 private:
  friend Result<DomainLease, Failure> claim_domain(std::uint32_t first, std::uint32_t last);
  DomainLease(std::uint32_t domain, std::unique_ptr<rtps::NamedLock> lock);

  std::uint32_t domain_;
  std::unique_ptr<rtps::NamedLock> lock_;
};

/// The first domain in [first, last] that no lease holds and on whose discovery port nobody
/// listens.
Result<DomainLease, Failure> claim_domain(std::uint32_t first = 1, std::uint32_t last = 100);

}  // namespace skein::blackboard
