// SPDX-License-Identifier: Apache-2.0
// Of how many sessions one member may tell another: who opens them without end takes no room.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "skein/negotiation/negotiation_manager.hpp"
#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::begin_roles;
using testing::name_of;
using testing::Team;

MissionTime instant(double seconds) { return MissionTime::seconds(seconds); }

NegotiationManager manager_of_a(MissionTime born = {}) {
  return NegotiationManager("a", 1, standard_modalities(), {}, born);
}

constexpr std::size_t kMost = 4 * kMostMembers;
constexpr const char* kTooMany = "it tells of more than 64 sessions in which a takes no part";

/// What `from` says of its nth session about something that nobody else negotiates.
SessionMessage nth_session(const std::string& from, std::size_t nth, MissionTime opened,
                           MissionTime deadline) {
  SessionMessage message;
  message.from = from;
  message.terms = {"nothing that anybody knows, " + std::to_string(nth),
                   1,
                   "role-allocation",
                   {"a", from},
                   ModelHash{7},
                   {},
                   from,
                   opened,
                   deadline};
  for (const std::string& uav : message.terms.members) {
    message.entries.emplace_back();
    message.entries.back().uav = uav;
  }
  return message;
}

std::size_t records(const NegotiationManager& manager) {
  const std::string text = manager.state_text();
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Why it had no effect; empty: it had.
std::string reason_of(NegotiationManager& manager, const SessionMessage& message, MissionTime now) {
  const auto effects = manager.handle(SessionMessageReceived{message}, now);
  for (const auto& one : *effects)
    if (const auto* rejected = std::get_if<MessageRejected>(&one)) return rejected->why;
  return "";
}

TEST(ManySessions, WhoOpensSessionsWithoutEndIsHeardOfSoManyAndRejectedWithTheReason) {
  NegotiationManager manager = manager_of_a();

  for (std::size_t i = 0; i < 1000; ++i) {
    const std::string why =
        reason_of(manager, nth_session("b", i, instant(1), instant(3600)), instant(2));
    EXPECT_EQ(why, i < kMost ? "" : kTooMany) << i;
  }

  EXPECT_EQ(records(manager), kMost);
}

TEST(ManySessions, SessionsThatAreSoonOverTakeNoMoreRoom) {
  NegotiationManager manager = manager_of_a();

  for (std::size_t i = 0; i < 1000; ++i) {
    const double now = 2 + 0.01 * static_cast<double>(i);
    const auto message = nth_session("b", i, instant(1), instant(now + 0.005));
    EXPECT_EQ(reason_of(manager, message, instant(now)), "") << i;
  }

  EXPECT_EQ(records(manager), kMost);
}

TEST(ManySessions, SessionsFromBeforeItsBirthTakeNoMoreRoom) {
  NegotiationManager manager = manager_of_a(instant(10));

  for (std::size_t i = 0; i < 1000; ++i)
    reason_of(manager, nth_session("b", i, instant(1), instant(i % 2 == 0 ? 3600 : 9)),
              instant(20));

  EXPECT_EQ(records(manager), kMost);
}

TEST(ManySessions, EarlierAndEarlierSessionsOfTheSameTakeNoMoreRoom) {
  NegotiationManager manager = manager_of_a();
  ASSERT_TRUE(manager.handle(begin_roles(2), instant(100)));

  for (std::size_t i = 0; i < 1000; ++i) {
    auto message = nth_session("b", 0, instant(99 - 0.001 * static_cast<double>(i)), instant(110));
    message.terms.subject = begin_roles(2).subject;
    message.terms.parameters = begin_roles(2).parameters;
    reason_of(manager, message, instant(100));
  }

  EXPECT_EQ(records(manager), kMost + 3);  // with two of its own, and that which it is in
}

TEST(ManySessions, OthersAreHeardBesideWhoOpensSessionsWithoutEnd) {
  Team team(3, [](std::size_t, std::size_t, MissionTime) { return Duration::milliseconds(100); });
  team.begin_when_invited(1, begin_roles(2));
  for (std::size_t i = 0; i < 1000; ++i) {
    for (const std::size_t to : {0, 1}) {
      const double now = 0.001 * static_cast<double>(i);
      auto message = nth_session("c", i, instant(now / 10), instant(30));
      message.terms.subject = i % 2 == 0 ? begin_roles(2).subject : message.terms.subject;
      message.terms.members[0] = name_of(to);
      message.entries[0].uav = name_of(to);
      team.at(instant(now),
              [&team, to, message] { team.give(to, SessionMessageReceived{message}); });
    }
  }
  team.at(instant(0.5), [&] { team.begin(0, begin_roles(2)); });

  team.run_until(instant(20));

  ASSERT_EQ(team.ends().size(), 2U);
  for (const auto& [member, end] : team.ends())
    EXPECT_EQ(end.kind, NegotiationOutcome::Kind::kAgreed) << name_of(member) << ": " << end.why;
  EXPECT_THAT(team.rejected(), ::testing::Contains(kTooMany));
}

}  // namespace
}  // namespace skein::interaction
