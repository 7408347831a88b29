// SPDX-License-Identifier: Apache-2.0
#include "../src/reckoning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// `a` and `b` give out two roles, and both have offered.
struct OfTwo : ::testing::Test {
  explicit OfTwo(bool as_jobs = false) {
    const BeginNegotiation begin = testing::begin_roles(2);
    terms.subject = begin.subject;
    terms.modality = begin.modality;
    terms.members = begin.members;
    terms.parameters = begin.parameters;
    terms.opener = "a";
    terms.deadline = MissionTime::seconds(10);
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      facts[i].offered = true;
      facts[i].offer = testing::role_costs(i);
    }
    reckoning.begin(testing::modalities(as_jobs).at(terms.modality));
  }
  static Terms of_two() {
    Terms terms;
    terms.members = testing::names(2);
    return terms;
  }

  Terms terms = of_two();
  Facts facts{of_two()};
  Reckoning reckoning;
  NegotiationEffects out;
};

struct OfTwoAsJobs : OfTwo {
  OfTwoAsJobs() : OfTwo(true) {}
};

TEST_F(OfTwo, TheResultIsThatOfTheModality) {
  EXPECT_EQ(reckoning.reckon(terms, facts, out), std::nullopt);

  EXPECT_THAT(out, IsEmpty());
  EXPECT_FALSE(reckoning.is_under_way());
  const Offers offers{{"a", testing::role_costs(0)}, {"b", testing::role_costs(1)}};
  EXPECT_EQ(reckoning.result(), *reckoning.modality().settle(terms, offers));
}

TEST_F(OfTwo, TheResultStaysWhatItWasFirst) {
  reckoning.know(Rows{{"mine", "", {1}}});

  EXPECT_EQ(reckoning.reckon(terms, facts, out), std::nullopt);

  EXPECT_EQ(reckoning.result(), (Rows{{"mine", "", {1}}}));
}

TEST_F(OfTwo, AnOfferIsBadWithItsReasonButNotBeforeItWasMade) {
  EXPECT_EQ(reckoning.bad_offer(terms, facts), std::nullopt);
  facts[1].offer = {{"nothing", "", {1}}};

  const auto bad = reckoning.bad_offer(terms, facts);

  ASSERT_TRUE(bad.has_value());
  EXPECT_THAT(*bad, HasSubstr("the offer of b: "));
  facts[1].offered = false;
  EXPECT_EQ(reckoning.bad_offer(terms, facts), std::nullopt);
}

TEST_F(OfTwo, EveryFigureAndWordOfAResultCountsWhenItIsCompared) {
  const auto fingerprint_of = [](const Row& row) {
    Reckoning one;
    one.know(Rows{row});
    return one.fingerprint();
  };
  const std::uint64_t print = fingerprint_of({"a", "watch", {1, 2}});

  EXPECT_EQ(fingerprint_of({"a", "watch", {1, 2}}), print);
  EXPECT_NE(fingerprint_of({"b", "watch", {1, 2}}), print);
  EXPECT_NE(fingerprint_of({"a", "relay", {1, 2}}), print);
  EXPECT_NE(fingerprint_of({"a", "watch", {1, 3}}), print);
  EXPECT_NE(fingerprint_of({"a", "watch", {1}}), print);
}

TEST_F(OfTwoAsJobs, TheResultIsAskedForOnceWithAllOffers) {
  reckoning.reckon(terms, facts, out);
  reckoning.reckon(terms, facts, out);

  ASSERT_THAT(out, SizeIs(1));
  const auto& asked = std::get<ReckonResult>(out[0]);
  EXPECT_EQ(asked.offers.at("b"), testing::role_costs(1));
  EXPECT_TRUE(reckoning.is_under_way());
  EXPECT_EQ(reckoning.result(), std::nullopt);
}

TEST_F(OfTwoAsJobs, TheAnswerIsTheResultOrWhyThereIsNone) {
  reckoning.reckon(terms, facts, out);

  EXPECT_EQ(reckoning.know(failure("no way")), "no way");
  EXPECT_EQ(reckoning.result(), std::nullopt);
  EXPECT_FALSE(reckoning.is_under_way());

  EXPECT_EQ(reckoning.know(Rows{{"a", "watch", {}}}), std::nullopt);
  EXPECT_EQ(reckoning.result(), (Rows{{"a", "watch", {}}}));
}

}  // namespace
}  // namespace skein::interaction
