// SPDX-License-Identifier: Apache-2.0
// What comes over the wire need not make sense: from a node of another version, or a broken one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "skein/foundation/random.hpp"
#include "skein/negotiation/negotiation_manager.hpp"
#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::begin_roles;

MissionTime second(double seconds) { return MissionTime::seconds(seconds); }

NegotiationManager manager_of(const std::string& uav) {
  return NegotiationManager(uav, 1, standard_modalities(), {}, MissionTime());
}

/// Changes something in what a partner said: some fields at random, to values that are there in
/// others, that are none, or far out.
class Garbling {
 public:
  explicit Garbling(std::uint64_t seed) : random_(seed, "garbling") {}

  SessionMessage of(SessionMessage message) {
    for (std::uint64_t changes = 1 + random_.below(3); changes > 0; --changes) change(message);
    return message;
  }

 private:
  void change(SessionMessage& m) {
    Terms& terms = m.terms;
    switch (random_.below(14)) {
      case 0:
        m.from = name();
        break;
      case 1:
        terms.subject = random_.chance(0.5) ? "" : "another";
        break;
      case 2:
        terms.mission = static_cast<std::uint32_t>(random_.below(3));
        break;
      case 3:
        terms.modality = random_.chance(0.5) ? "time-interval" : "nonsense";
        break;
      case 4:
        terms.members.resize(random_.below(4), name());
        break;
      case 5:
        terms.model.value = random_.below(9);
        break;
      case 6:
        terms.parameters = rows();
        break;
      case 7:
        terms.opener = name();
        break;
      case 8:
        terms.opened = instant();
        break;
      case 9:
        terms.deadline = instant();
        break;
      case 10:
        m.entries.resize(random_.below(4));
        break;
      case 11:
        m.wants_echo = !m.wants_echo;
        break;
      default:
        if (!m.entries.empty()) change(m.entries[random_.below(m.entries.size())]);
    }
  }
  void change(Entry& entry) {
    switch (random_.below(6)) {
      case 0:
        entry.uav = name();
        break;
      case 1:
        entry.offered = !entry.offered;
        break;
      case 2:
        entry.offer = rows();
        break;
      case 3:
        entry.vow = static_cast<Entry::Vow>(random_.below(3));
        break;
      case 4:
        entry.result = random_.below(3);
        break;
      default:
        entry.lost = !entry.lost;
    }
  }
  std::string name() { return std::string(1, "abcz"[random_.below(4)]); }
  MissionTime instant() {
    constexpr std::array<std::int64_t, 5> kFar = {std::numeric_limits<std::int64_t>::min(), -1, 0,
                                                  1, std::numeric_limits<std::int64_t>::max()};
    return random_.chance(0.5) ? MissionTime::nanoseconds(kFar[random_.below(kFar.size())])
                               : second(random_.uniform(-20, 40));
  }
  Rows rows() {
    Rows all;
    for (std::uint64_t i = random_.below(3); i > 0; --i)
      all.push_back({random_.chance(0.5) ? "watch" : "relay", "",
                     std::vector<double>(random_.below(3), random_.chance(0.1) ? NAN : 1e300)});
    return all;
  }

  Random random_;
};

std::size_t ended(const NegotiationEffects& effects) {
  return static_cast<std::size_t>(std::count_if(
      effects.begin(), effects.end(),
      [](const NegotiationEffect& one) { return std::holds_alternative<NegotiationEnded>(one); }));
}

/// What `a` is told in a negotiation with b and c, and then much that is garbled.
TEST(GarbledMessages, WhateverPartnersSayItEndsOnceAndWhatIsRejectedChangesNothing) {
  std::size_t rejected = 0, taken = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    NegotiationManager manager = manager_of("a"), partner = manager_of("b");
    std::size_t ends = 0;
    const auto give = [&](const NegotiationInput& input, double when) {
      const auto effects = manager.handle(input, second(when));
      if (effects) ends += ended(*effects);
      return effects.value_or(NegotiationEffects{});
    };
    SessionMessage said;
    for (const auto& effect :
         testing::open_session(partner, begin_roles(3), testing::role_costs(1), second(1)))
      if (const auto* send = std::get_if<SendSessionMessage>(&effect)) said = send->message;
    give(SessionMessageReceived{said}, 1);
    give(begin_roles(3), 1);
    give(OfferPrepared{said.terms.id(), testing::role_costs(0)}, 1);
    Garbling garbling(seed);
    for (int i = 1; i <= 12; ++i) {
      const std::string before = manager.state_text();
      const auto effects = give(SessionMessageReceived{garbling.of(said)}, 1);
      const bool is_rejected =
          effects.size() == 1 && std::holds_alternative<MessageRejected>(effects.front());
      (is_rejected ? rejected : taken) += 1;
      if (is_rejected) {
        EXPECT_EQ(manager.state_text(), before) << "seed " << seed;
      }
    }
    for (int i = 2; i <= 21; ++i) give(NegotiationTick{}, i);  // begun at 1 for 10 s

    EXPECT_EQ(ends, 1U) << "seed " << seed;
  }
  EXPECT_GT(rejected, taken / 4);
  EXPECT_GT(taken, rejected / 20);
}

}  // namespace
}  // namespace skein::interaction
