// SPDX-License-Identifier: Apache-2.0
// Sessions that a member left for earlier ones.
#include <gtest/gtest.h>

#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::begin_roles;

MissionTime second(int number) { return MissionTime::seconds(number); }

/// What it sends about the session of this opener, as effects tell.
std::vector<SessionMessage> said_of(const std::string& opener, const NegotiationEffects& effects) {
  std::vector<SessionMessage> all;
  for (const NegotiationEffect& one : effects) {
    const auto* send = std::get_if<SendSessionMessage>(&one);
    if (send != nullptr && send->message.terms.opener == opener) all.push_back(send->message);
  }
  return all;
}

/// What it says when it opens one.
std::vector<SessionMessage> opened_by(const std::string& uav, NegotiationManager& manager,
                                      int instant) {
  return said_of(
      uav, testing::open_session(manager, begin_roles(2), testing::role_costs(0), second(instant)));
}

// b opens one, and then hears of one that a opened earlier: it goes over. Were a not told, it would
// take b's, which it may know from before, for an invitation once its own has failed.
TEST(ALeftSession, IsSaidToBeLeftToTheOpenerOfTheEarlierOne) {
  NegotiationManager a("a", 1, standard_modalities(), {}, MissionTime());
  NegotiationManager b("b", 1, standard_modalities(), {}, MissionTime());
  ASSERT_TRUE(b.handle(begin_roles(2), second(2)));
  const auto invited = opened_by("a", a, 1);
  ASSERT_FALSE(invited.empty());

  const auto left = said_of("b", b.handle(SessionMessageReceived{invited[0]}, second(2)).value());

  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].entries[1].why, "it moved to an earlier session");
}

// When the one it went over to has ended, what it says of the one it left is no longer where it is.
TEST(ALeftSession, IsRefusedByWhoIsInALaterOneSince) {
  NegotiationManager a("a", 1, standard_modalities(), {}, MissionTime());
  NegotiationManager b("b", 1, standard_modalities(), {}, MissionTime());
  const auto of_b = opened_by("b", b, 2);
  const auto of_a = opened_by("a", a, 1);
  ASSERT_TRUE(b.handle(SessionMessageReceived{of_a[0]}, second(2)));
  ASSERT_TRUE(b.handle(WithdrawNegotiation{"mref/roles", "no time"}, second(3)));
  ASSERT_TRUE(b.handle(begin_roles(2), second(4)));

  SessionMessage joins = of_b[0];
  joins.from = "a";
  joins.wants_echo = true;
  const auto answers = b.handle(SessionMessageReceived{joins}, second(4)).value();

  const auto said = said_of("b", answers);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].terms.opened, second(2));
  EXPECT_EQ(said[0].entries[1].why, "it moved to an earlier session");
}

}  // namespace
}  // namespace skein::interaction
