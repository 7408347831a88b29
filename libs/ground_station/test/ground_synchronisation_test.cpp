// SPDX-License-Identifier: Apache-2.0
// Synchronisation messages at the ground: relayed, used here, said again, withdrawn.
#include "skein/ground_station/ground_control.hpp"

#include "testing/builders.hpp"
#include "testing/one_ground.hpp"

namespace skein::ground_station {
namespace {

using testing::abort_of;
using testing::at;
using testing::command;
using testing::control;
using testing::first;
using ::testing::IsEmpty;
using testing::only;
using ::testing::SizeIs;
using Effects = std::vector<GroundControl::Effect>;

TEST(GroundSynchronisation, SynchronisationMessagesGoWhereTheReceiversMleIs) {
  GroundControl ground = control({{"karma", 1, {}}, {"heliv", 2, {}}, {"marvin", 3, {}}});

  const Effects relayed = ground.handle(SyncReceived{551, "heliv", "marvin"}, at(1));
  const Effects used = ground.handle(SyncReceived{551, "heliv", "karma"}, at(1));
  const Effects unknown = ground.handle(SyncReceived{551, "heliv", "nobody"}, at(1));

  EXPECT_EQ(first<SendSync>(relayed).to, "marvin");
  EXPECT_EQ(first<SendSync>(relayed).from, "heliv");
  EXPECT_THAT(only<SendSync>(used), IsEmpty());
  EXPECT_EQ(first<LocalSync>(used).direction, SyncDirection::kReceived);
  EXPECT_THAT(only<Anomaly>(unknown), SizeIs(1));
}

TEST(GroundSynchronisation, RelayedMessagesAreSentAgainToWhoComesBack) {
  GroundControl ground = control({{"heliv", 2, {}}, {"marvin", 3, {}}});
  ground.handle(SyncReceived{551, "heliv", "marvin"}, at(1));
  EXPECT_THAT(only<SendSync>(ground.handle(PeerReachable{"marvin", false, false}, at(2))),
              IsEmpty());

  const Effects effects = ground.handle(PeerReachable{"marvin", true, false}, at(3));

  EXPECT_THAT(only<SendSync>(effects), SizeIs(1));
}

TEST(GroundSynchronisation, WhoComesBackHearsTheLastWordOfEachPartnerAndWhenItWasSaid) {
  using executive::SyncWord;
  GroundControl ground = control({{"heliv", 2, {}}, {"marvin", 3, {}}});
  ground.handle(SyncReceived{551, "heliv", "marvin", SyncWord::kThere, at(1)}, at(2));
  ground.handle(SyncReceived{551, "heliv", "marvin", SyncWord::kWithdrawn, at(5)}, at(6));
  ground.handle(SyncReceived{551, "heliv", "marvin", SyncWord::kThere, at(3)}, at(7));

  const auto sent = only<SendSync>(ground.handle(PeerReachable{"marvin", true, false}, at(9)));

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent[0].word, SyncWord::kWithdrawn);
  EXPECT_EQ(sent[0].said, at(5));
}

TEST(GroundSynchronisation, APartnerWhoseMleIsHereWithdrawsFromHere) {
  executive::Config config;
  config.sync_validity = Duration::seconds(30);
  GroundControl ground = control({{"marvin", 1, config}, {"heliv", 3, {}}});
  executive::Task meeting;
  meeting.id = executive::TaskId(7);
  meeting.type = "synchronise";
  meeting.synchronisation =
      executive::Synchronisation{551, {"marvin", "heliv"}, {"marvin", "heliv"}, {}};
  ground.handle(command(executive::Start{meeting, executive::InsertionMode::kSeq}), at(1));

  const auto sent =
      only<SendSync>(ground.handle(command(executive::Abort{executive::TaskId(7)}), at(4)));

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent[0].to, "heliv");
  EXPECT_EQ(sent[0].word, executive::SyncWord::kWithdrawn);
  EXPECT_EQ(sent[0].said, at(4));
}

}  // namespace
}  // namespace skein::ground_station
