// SPDX-License-Identifier: Apache-2.0
// What passes over radio is written into the journal.
#include <gtest/gtest.h>

#include "testing/hosts.hpp"

namespace skein::node {
namespace {

using testing::abort_request;
using testing::Hosts;

TEST_F(Hosts, EventsOverRadioAreLoggedAtBothEnds) {
  meet();

  act("ground", {Send{number("marvin"), abort_request(7)}});
  settle();

  EXPECT_EQ((*this)["ground"].lines("message"),
            (std::vector<std::string>{
                R"({"at":0.2,"node":"ground","kind":"message","slot":"TaskRequest",)"
                R"("from":"ground","to":"marvin","sequence":1,"direction":"sent"})"}));
  EXPECT_EQ((*this)["marvin"].lines("message"),
            (std::vector<std::string>{
                R"({"at":0.2,"node":"marvin","kind":"message","slot":"TaskRequest",)"
                R"("from":"ground","to":"marvin","sequence":1,"direction":"received"})"}));
}

TEST_F(Hosts, AMessageOfANegotiationIsLoggedWithItsSession) {
  meet();
  wire::NegotiationMessage message;
  message.from = "ground";
  message.to = "marvin";
  message.subject = "watch/roles";
  message.opener = "marvin";
  message.opened = 1'500'000'000;

  act("ground", {Send{number("marvin"), message}});
  settle();

  for (const char* name : {"ground", "marvin"}) {
    ASSERT_EQ((*this)[name].lines("message").size(), 1U) << name;
    const std::string line = (*this)[name].lines("message")[0];
    EXPECT_TRUE(line.ends_with(R"("subject":"watch/roles","opener":"marvin","opened":1.5})"))
        << line;
  }
}

TEST_F(Hosts, StatesStreamsAndOnboardEventsAreNoMessages) {
  meet();

  act("marvin",
      {Send{number("ground"), wire::PlanBoard{}}, Send{number("ground"), wire::Telemetry{}},
       Send{number("sim"), wire::FunctionalRequest{}}});
  settle();

  EXPECT_EQ((*this)["ground"].diary.all<Received>().size(), 2U);
  EXPECT_EQ((*this)["sim"].diary.samples<wire::FunctionalRequest>().size(), 1U);
  for (const char* name : {"marvin", "ground", "sim"}) {
    EXPECT_TRUE((*this)[name].lines("message").empty()) << name;
  }
}

}  // namespace
}  // namespace skein::node
