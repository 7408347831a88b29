// SPDX-License-Identifier: Apache-2.0
// Jobs of the decision node, and whose results they are.
#include "skein/ddn/jobs.hpp"

#include <gtest/gtest.h>

#include <set>

namespace skein::ddn {
namespace {

namespace dn = decision_node;

const Jobs kJobs(Duration::seconds(10));

template <class Asked>
Asked numbered(std::uint64_t job) {
  Asked asked;
  asked.job = job;
  return asked;
}

TEST(Jobs, OfEachKindHaveNumbersOfTheirOwn) {
  const std::set<std::uint64_t> numbers{
      kJobs.effect_of(numbered<dn::StartReckoning>(1)).id,
      kJobs.effect_of(numbered<dn::StartDetours>(1)).id,
      kJobs.effect_of(numbered<dn::StartWaySearch>(1)).id,
      kJobs.effect_of(numbered<supervisor::StartDeliberation>(1)).id};
  EXPECT_EQ(numbers.size(), 4U);
}

TEST(Jobs, AreStoppedUnderTheNumberTheyWereStartedUnder) {
  EXPECT_EQ(kJobs.effect_of(numbered<dn::StopReckoning>(5)).id,
            kJobs.effect_of(numbered<dn::StartReckoning>(5)).id);
  EXPECT_EQ(kJobs.effect_of(numbered<supervisor::StopDeliberation>(5)).id,
            kJobs.effect_of(numbered<supervisor::StartDeliberation>(5)).id);
}

TEST(Jobs, OnlyPlansAndDetoursHaveALimitOfTime) {
  EXPECT_EQ(kJobs.effect_of(supervisor::StartDeliberation{}).at_most, Duration::seconds(10));
  EXPECT_EQ(kJobs.effect_of(dn::StartDetours{}).at_most, Duration::milliseconds(250));
  EXPECT_EQ(kJobs.effect_of(dn::StartReckoning{}).at_most, Duration::max());
  EXPECT_EQ(kJobs.effect_of(dn::StartWaySearch{}).at_most, Duration::max());
}

TEST(Jobs, WhatNobodyWantsIsNotReckoned) {
  const auto job = kJobs.effect_of(numbered<dn::StartReckoning>(3));
  const std::any result = job.work([] { return true; });
  const auto input = Jobs::input_of({job.id, result});
  ASSERT_TRUE(input);
  const auto& finished = std::get<dn::ReckoningFinished>(*input);
  EXPECT_EQ(finished.job, 3U);
  ASSERT_FALSE(finished.result);
  EXPECT_EQ(finished.result.error().why, "nobody wants it any more");
}

TEST(Jobs, ResultsGoToWhoAskedForThem) {
  const auto detours = kJobs.effect_of(numbered<dn::StartDetours>(4));
  const auto planned = Jobs::input_of({detours.id, std::vector<supervisor::Detour>()});
  ASSERT_TRUE(planned);
  EXPECT_EQ(std::get<dn::DetoursPlanned>(*planned).job, 4U);
  const auto search = kJobs.effect_of(numbered<dn::StartWaySearch>(6));
  const auto searched = Jobs::input_of({search.id, std::optional<refiners::Path>()});
  ASSERT_TRUE(searched);
  EXPECT_EQ(std::get<dn::WaySearched>(*searched).job, 6U);
}

TEST(Jobs, AResultOfNoKnownKindIsNone) { EXPECT_FALSE(Jobs::input_of({1, 7})); }

}  // namespace
}  // namespace skein::ddn
