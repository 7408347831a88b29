// SPDX-License-Identifier: Apache-2.0
// A DDS domain of one's own on this machine.
#include "skein/blackboard/domain_lease.hpp"

#include <set>
#include <string>
#include <utility>

#include "named_lock.hpp"
#include "ports.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

bool anyone_in(std::uint32_t domain, const std::set<unsigned>& ports) {
  const unsigned first = rtps::first_port(domain);
  const auto found = ports.lower_bound(first);
  return found != ports.end() && *found < first + rtps::kPortsPerDomain;
}

}  // namespace

DomainLease::DomainLease(std::uint32_t domain, std::unique_ptr<rtps::NamedLock> lock)
    : domain_(domain), lock_(std::move(lock)) {}
DomainLease::DomainLease(DomainLease&& other) noexcept = default;
DomainLease& DomainLease::operator=(DomainLease&& other) noexcept = default;
DomainLease::~DomainLease() = default;

Result<DomainLease, Failure> claim_domain(std::uint32_t first, std::uint32_t last) {
  SKEIN_EXPECTS(first <= last && last <= rtps::kLastDomain);
  for (std::uint32_t domain = first; domain <= last; ++domain) {
    auto lock = rtps::NamedLock::take("skein-dds-domain-" + std::to_string(domain));
    if (!lock || anyone_in(domain, rtps::bound_udp_ports())) continue;
    return DomainLease(domain, std::make_unique<rtps::NamedLock>(std::move(*lock)));
  }
  return failure("no free DDS domain from " + std::to_string(first) + " to " +
                 std::to_string(last));
}

}  // namespace skein::blackboard
