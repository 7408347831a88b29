// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/domain_lease.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace skein::blackboard {
namespace {

TEST(DomainLease, NoTwoLeasesShareADomain) {
  const auto first = claim_domain(80, 100);
  const auto second = claim_domain(80, 100);

  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_NE(first->domain(), second->domain());
}

TEST(DomainLease, RefusesWhenAllAreTaken) {
  const auto taken = claim_domain(70, 79);
  ASSERT_TRUE(taken);

  const auto refused = claim_domain(taken->domain(), taken->domain());

  ASSERT_FALSE(refused);
  EXPECT_FALSE(refused.error().why.empty());
}

TEST(DomainLease, ADomainIsFreeAgainAfterItsLease) {
  std::uint32_t domain = 0;
  {
    const auto lease = claim_domain(60, 69);
    ASSERT_TRUE(lease);
    domain = lease->domain();
  }

  EXPECT_TRUE(claim_domain(domain, domain));
}

TEST(DomainLease, MovesWithItsOwner) {
  auto lease = claim_domain(60, 69);
  ASSERT_TRUE(lease);
  const std::uint32_t domain = lease->domain();

  std::optional<DomainLease> moved(std::move(*lease));

  EXPECT_FALSE(claim_domain(domain, domain));
  moved.reset();
  EXPECT_TRUE(claim_domain(domain, domain));
}

}  // namespace
}  // namespace skein::blackboard
