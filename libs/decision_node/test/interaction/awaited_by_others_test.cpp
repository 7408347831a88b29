// SPDX-License-Identifier: Apache-2.0
// "marvin" has not begun a joint task that "karma" is at; "heliv", the third, falls silent before
// the start is agreed on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "testing/flown_node.hpp"
#include "testing/joint_host.hpp"
#include "testing/negotiating_partner.hpp"

namespace skein::decision_node {
namespace {

using interaction::JointPhase;
using interaction::JointTaskStatus;
using interaction::SessionMessage;
using testing::all;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

Config of_three() {
  Config config = testing::stood_in_config("");
  config.others = {"heliv", "karma"};
  auto library = std::make_shared<interaction::Library>(*config.interaction);
  auto& variants = library->models.at("watching").variants;
  variants.front().table.arities.at("relay") = {2, 2};
  variants.push_back(variants.front());
  variants.back().name = "fewer";
  variants.back().table.arities.at("relay") = {1, 1};
  config.interaction = library;
  return config;
}

class AwaitedByOthers : public ::testing::Test {
 protected:
  AwaitedByOthers() {
    host_.bus().begin(now_);
    host_.partners().start(now_);
    for (const char* uav : {"heliv", "karma"}) host_.partners().contact({uav, false, true}, now_);
    interaction_.start();
    interaction_.vehicle_told(testing::flying(true));
    interaction_.load({testing::watching("marvin heliv karma"), {{Duration(), Duration::max()}}});
    exchange();
  }

  /// Heliv is out of reach from now on.
  void heliv_is_silent() {
    is_silent_ = true;
    host_.bus().begin(now_);
    host_.partners().contact({"heliv", false, false}, now_);
  }

  /// Karma says that it is at it with marvin.
  void karma_runs() {
    JointTaskTold told;
    told.status = said_;
    told.status.uav = "karma";
    told.status.phase = JointPhase::kRunning;
    told.status.holders.erase("heliv");
    told.at = now_;
    host_.bus().begin(now_);
    interaction_.hear(told);
    exchange();
  }

  void run(int seconds) {
    for (int i = 0; i < seconds; ++i) {
      now_ = now_ + Duration::seconds(1);
      host_.bus().begin(now_);
      interaction_.time_passes();
      exchange();
    }
  }

  /// Of sessions about roles that marvin opened since it was asked last.
  std::vector<std::vector<std::string>> members() { return std::exchange(members_, {}); }
  const JointTaskStatus& said() const { return said_; }

 private:
  /// Until nobody says anything more.
  void exchange() {
    std::deque<SendNegotiation> sent;
    const auto note = [&] {
      const Effects effects = host_.bus().end();
      host_.bus().begin(now_);
      for (const auto& one : all<SendNegotiation>(effects)) sent.push_back(one);
      for (const auto& one : all<JointTaskChanged>(effects)) said_ = one.status;
    };
    note();
    while (!sent.empty()) {
      const SendNegotiation one = sent.front();
      sent.pop_front();
      const interaction::Terms& terms = one.message.terms;
      if (terms.subject.ends_with("/roles") && terms.opener == "marvin")
        members_.push_back(terms.members);
      const bool to_heliv = one.to == "heliv";
      if (to_heliv && is_silent_) continue;
      for (const SessionMessage& answer :
           (to_heliv ? heliv_ : karma_)
               .answers(interaction::SessionMessageReceived{one.message}, now_)) {
        interaction_.hear(answer);
        note();
      }
    }
  }

  testing::NegotiatingPartner::Offer offer(const interaction::Terms& terms) const {
    if (terms.modality == "time-interval") return failure("not yet");
    return interaction::Rows{{"watch", "", {5}}, {"relay", "", {1}}};
  }

  MissionTime now_ = MissionTime::seconds(10);
  testing::LoneJointHost host_{of_three()};
  Interaction interaction_{host_};
  JointTaskStatus said_;
  std::vector<std::vector<std::string>> members_;
  bool is_silent_ = false;
  testing::NegotiatingPartner heliv_{[this](const auto&terms) { return offer(terms); }},
      karma_{[this](const auto&terms) { return offer(terms); }, "karma"};
};

// Found by random missions (--sharing --deaths 17): it waited for the lease of who had died.
TEST_F(AwaitedByOthers, WhoIsLostIsDoneWithoutWhereAnotherIsAtIt) {
  ASSERT_EQ(said().holders.size(), 3U);
  heliv_is_silent();
  run(1);
  karma_runs();
  members();

  run(50);
  EXPECT_EQ(said().holders.size(), 3U);
  EXPECT_THAT(members(), ::testing::IsEmpty());
  run(50);
  EXPECT_THAT(members(), Contains(ElementsAre("karma", "marvin")));
}

TEST_F(AwaitedByOthers, WhereNobodyHasBegunItsLeaseIsWaitedFor) {
  ASSERT_EQ(said().holders.size(), 3U);
  heliv_is_silent();
  members();

  run(100);
  EXPECT_THAT(members(), Not(Contains(ElementsAre("karma", "marvin"))));
}

}  // namespace
}  // namespace skein::decision_node
