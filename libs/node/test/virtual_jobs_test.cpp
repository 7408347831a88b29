// SPDX-License-Identifier: Apache-2.0
#include "virtual_jobs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "testing/fake_node.hpp"

namespace skein::node {
namespace {

JobTimes always(double seconds) { return {Duration::seconds(seconds), Duration::seconds(seconds)}; }
const VirtualJobs::Owner kMarvin{"marvin", 1};

StartJob job(std::uint64_t id, bool aside = false) {
  StartJob result{id, [id](const TimeIsUp&) { return std::any(id); }};
  result.aside = aside;
  return result;
}

/// What ends, in its order: the job and when.
std::vector<std::pair<std::uint64_t, double>> all_done(VirtualJobs& jobs) {
  std::vector<std::pair<std::uint64_t, double>> result;
  while (const auto next = jobs.next())
    while (const auto one = jobs.take_done(*next))
      result.emplace_back(one->done.id, (*next - MissionTime()).to_seconds());
  return result;
}

using Ends = std::vector<std::pair<std::uint64_t, double>>;

TEST(VirtualJobs, ALaneDoesOneJobAfterTheOther) {
  VirtualJobs jobs(always(2), 1);
  jobs.submit(kMarvin, job(1), at(10));
  jobs.submit(kMarvin, job(2), at(11));

  EXPECT_FALSE(jobs.take_done(at(11.9)));
  EXPECT_EQ(all_done(jobs), (Ends{{1, 12}, {2, 14}}));
  jobs.submit(kMarvin, job(3), at(20));
  EXPECT_EQ(all_done(jobs), (Ends{{3, 22}}));
}

TEST(VirtualJobs, NoJobWaitsForTheOtherLaneNorForAnotherNode) {
  VirtualJobs jobs(always(2), 1);
  jobs.submit(kMarvin, job(1), at(10));
  jobs.submit(kMarvin, job(2, true), at(10.5));
  jobs.submit({"heliv", 1}, job(3), at(11));

  EXPECT_EQ(all_done(jobs), (Ends{{1, 12}, {2, 12.5}, {3, 13}}));
}

TEST(VirtualJobs, WhatIsDoneAtOneInstantComesInTheOrderOfItsSubmission) {
  VirtualJobs jobs(always(2), 1);
  jobs.submit({"marvin", 1}, job(1), at(10));
  jobs.submit({"heliv", 1}, job(2), at(10));
  jobs.submit({"karma", 1}, job(3), at(10));

  EXPECT_EQ(all_done(jobs), (Ends{{1, 12}, {2, 12}, {3, 12}}));
}

TEST(VirtualJobs, ItsTimeBeingUpAJobEndsInTheLeastTimeAndTheNextBegins) {
  VirtualJobs jobs({Duration::seconds(0.5), Duration::seconds(1000)}, 3);
  for (std::uint64_t id = 1; id <= 3; ++id) jobs.submit(kMarvin, job(id), at(10));

  for (std::uint64_t id = 1; id <= 3; ++id) jobs.stop(kMarvin, id, at(10.25));
  jobs.stop(kMarvin, 99, at(10.25));

  const Ends ends = all_done(jobs);
  ASSERT_EQ(ends.size(), 3U);
  EXPECT_LE(ends[0].second, 10.75);
  EXPECT_LE(ends[2].second, ends[0].second + 1);
}

TEST(VirtualJobs, TakeTimesBetweenTheLeastAndTheMostWhichTheSeedAloneGives) {
  const auto times = [](std::uint64_t seed) {
    VirtualJobs jobs({Duration::seconds(1), Duration::seconds(9)}, seed);
    for (std::uint64_t id = 0; id < 200; ++id) jobs.submit(kMarvin, job(id), at(0));
    Ends ends = all_done(jobs);
    std::vector<double> result;
    double before = 0;
    for (const auto& [id, end] : ends) result.push_back(end - std::exchange(before, end));
    return result;
  };
  const std::vector<double> first = times(1);

  EXPECT_EQ(first, times(1));
  EXPECT_NE(first, times(2));
  EXPECT_GE(*std::min_element(first.begin(), first.end()), 1 - 1e-6);
  EXPECT_LE(*std::max_element(first.begin(), first.end()), 9 + 1e-6);
  EXPECT_GT(*std::max_element(first.begin(), first.end()), 6) << "some are long";
  EXPECT_GT(std::count_if(first.begin(), first.end(), [](double one) { return one < 3; }), 100);
}

TEST(VirtualJobs, NoneTakesLongerThanItMay) {
  VirtualJobs jobs({Duration::seconds(1), Duration::seconds(900)}, 1);
  for (std::uint64_t id = 0; id < 50; ++id) {
    StartJob one = job(id);
    one.at_most = Duration::seconds(2);
    jobs.submit(kMarvin, std::move(one), at(0));
  }

  EXPECT_LE(all_done(jobs).back().second, 100 + 1e-6);
}

TEST(VirtualJobs, AFormerLifeHasALaneOfItsOwn) {
  VirtualJobs jobs(always(5), 1);
  jobs.submit({"marvin", 1}, job(1), at(10));
  jobs.submit({"marvin", 2}, job(1), at(11));

  const auto first = jobs.take_done(at(15));
  const auto second = jobs.take_done(at(16));

  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->owner.incarnation, 1U);
  EXPECT_EQ(second->owner.incarnation, 2U);
}

}  // namespace
}  // namespace skein::node
