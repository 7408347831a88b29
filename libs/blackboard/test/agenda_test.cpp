// SPDX-License-Identifier: Apache-2.0
#include "agenda.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace skein::blackboard {
namespace {

/// What was last said of each peer, gone through entirely at each question.
struct Naive {
  std::map<NodeNumber, std::pair<std::optional<Duration>, std::optional<MissionTime>>> said;

  std::vector<NodeNumber> due(Now now) const {
    std::vector<NodeNumber> peers;
    for (const auto& [peer, times] : said) {
      const bool is_due = times.first && *times.first <= now.steady;
      const bool has_expired = times.second && *times.second < now.mission;
      if (is_due || has_expired) peers.push_back(peer);
    }
    return peers;
  }
  std::optional<Duration> next_due() const {
    std::optional<Duration> next;
    for (const auto& [peer, times] : said) {
      if (times.first && (!next || *times.first < *next)) next = times.first;
    }
    return next;
  }
  std::optional<MissionTime> next_expiry() const {
    std::optional<MissionTime> next;
    for (const auto& [peer, times] : said) next = earliest(next, times.second);
    return next;
  }
};

Duration any_duration() { return Duration::milliseconds(*rc::gen::inRange(0, 8)); }
MissionTime any_instant() { return MissionTime() + any_duration(); }

RC_GTEST_PROP(Agenda, AnswersAsOneWhoLooksAtEveryPeer, ()) {
  Agenda agenda;
  Naive naive;
  const int steps = *rc::gen::inRange(1, 60);
  for (int i = 0; i < steps; ++i) {
    const NodeNumber peer(static_cast<std::uint32_t>(*rc::gen::inRange(1, 7)));
    std::optional<Duration> due;
    std::optional<MissionTime> expires;
    if (*rc::gen::arbitrary<bool>()) due = any_duration();
    if (*rc::gen::arbitrary<bool>()) expires = any_instant();
    agenda.set(peer, due, expires);
    naive.said[peer] = {due, expires};
    const Now now{any_instant(), any_duration()};
    RC_ASSERT(agenda.due(now) == naive.due(now));
    RC_ASSERT(agenda.next_due() == naive.next_due());
    RC_ASSERT(agenda.next_expiry() == naive.next_expiry());
  }
}

TEST(Agenda, APeerIsDueAtItsTimeAndAnEventExpiresAfterIt) {
  Agenda agenda;
  agenda.set(NodeNumber(1), Duration::milliseconds(5), std::nullopt);
  agenda.set(NodeNumber(2), std::nullopt, MissionTime::seconds(1));

  const Now at_once{MissionTime::seconds(1), Duration::milliseconds(5)};
  const Now later{MissionTime::seconds(1.001), Duration::milliseconds(5)};

  EXPECT_EQ(agenda.due(at_once), (std::vector<NodeNumber>{NodeNumber(1)}));
  EXPECT_EQ(agenda.due(later), (std::vector<NodeNumber>{NodeNumber(1), NodeNumber(2)}));
}

}  // namespace
}  // namespace skein::blackboard
