// SPDX-License-Identifier: Apache-2.0
// What a member says that it has of the ledger.
#include <gtest/gtest.h>

#include "skein/auction/team_member.hpp"
#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

Beat beat(std::uint64_t term, std::uint64_t revision) {
  auto ledger = std::make_shared<Ledger>();
  ledger->term = term;
  ledger->revision = revision;
  return {term, revision, ledger};
}

/// The revision that one of two says it has after a beat of the other.
std::uint64_t said(TeamMember& one, const Beat& beat, double second) {
  for (const TeamEffect& effect : one.handle(Heard{MemberNumber(1), beat}, at(second)))
    if (const auto* tell = std::get_if<Tell>(&effect))
      if (const auto* status = std::get_if<Status>(&tell->message)) return status->revision;
  ADD_FAILURE() << "nothing is said";
  return 0;
}

// Found by random teams: the last revision that a member had heard of a holder that was cut off had
// the number of the next holder's, which took it for its own. The member was never told any other.
TEST(Revisions, OfAnEarlierTermAreNotTheHoldersOfTheSameNumber) {
  TeamSetup setup;
  setup.self = MemberNumber(0);
  setup.roster = {MemberNumber(0), MemberNumber(1)};
  TeamMember one(std::move(setup));

  EXPECT_EQ(said(one, beat(2, 22), 1), 22U);
  EXPECT_EQ(said(one, {3, 22, nullptr}, 2), 0U);
  EXPECT_EQ(said(one, beat(3, 22), 3), 22U);
}

}  // namespace
}  // namespace skein::auction
