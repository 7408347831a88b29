// SPDX-License-Identifier: Apache-2.0
// What a host makes of what it is told of links.
#include <gtest/gtest.h>

#include <limits>

#include "skein/node/host.hpp"
#include "testing/hosts.hpp"

namespace skein::node {
namespace {

using testing::abort_request;
using testing::Hosts;
using testing::link;

TEST_F(Hosts, AnEventWaitsForALinkThatIsDown) {
  meet();
  set_link("ground", "marvin", false);

  act("ground", {Send{number("marvin"), abort_request(7)}});
  advance(5);
  const auto during = (*this)["marvin"].diary.samples<wire::TaskRequest>().size();
  set_link("ground", "marvin", true);
  advance(2);

  EXPECT_EQ(during, 0U);
  EXPECT_EQ((*this)["marvin"].diary.samples<wire::TaskRequest>().size(), 1U);
}

TEST_F(Hosts, OneLinkThatIsDownLeavesTheOthersAlone) {
  meet();
  set_link("ground", "marvin", false);

  act("ground", {Send{number("heliv"), abort_request(7)}});
  act("heliv", {Send{number("marvin"), wire::SyncMessage{}}});
  advance(1);

  EXPECT_EQ((*this)["heliv"].diary.samples<wire::TaskRequest>().size(), 1U);
  EXPECT_EQ((*this)["marvin"].diary.samples<wire::SyncMessage>().size(), 1U);
}

// Found by random missions: the ground station was in contact for three heartbeats with UAVs that
// were never in its reach.
TEST_F(Hosts, WhatComesInTheMomentInWhichItsLinkIsToldToBeDownMakesNoContact) {
  (*this)["marvin"].host->step(now());  // says that it is there
  (*this)["heliv"].host->step(now());

  set_link("ground", "marvin", false);
  advance(5);

  const auto contacts_with = [this](const std::string& peer) {
    return std::ranges::count_if((*this)["ground"].lines("reach"), [&](const std::string& line) {
      return line.find(peer) != line.npos;
    });
  };
  EXPECT_EQ(contacts_with("marvin"), 0);
  EXPECT_EQ(contacts_with("heliv"), 1);
}

// The transport gives its history again each time; nobody replays it.
TEST_F(Hosts, ALinkThatFlapsFasterThanSilenceIsNoticedAccusesNobody) {
  meet();
  act("ground",
      {Send{number("marvin"), abort_request(7)}, Send{number("marvin"), abort_request(8)}});
  advance(3);

  for (int i = 0; i < 10; ++i) {
    set_link("ground", "marvin", false);
    advance(0.3);
    set_link("ground", "marvin", true);
    advance(0.3);
  }

  EXPECT_EQ((*this)["marvin"].diary.samples<wire::TaskRequest>().size(), 2U);
  EXPECT_TRUE((*this)["marvin"].lines("dropped").empty());
}

TEST_F(Hosts, ALinkStateOfStrangersIsDisregarded) {
  meet();

  (*this)["sim"].host->publish(link(NodeNumber(70), NodeNumber(71), false), now());
  (*this)["sim"].host->publish(link(NodeNumber(70), number("marvin"), false), now());
  advance(5);

  EXPECT_TRUE((*this)["marvin"].host->all_peers_heard());
  EXPECT_EQ((*this)["marvin"].lines("reach").size(), 3U);
}

TEST_F(Hosts, TheLatencyOfALinkIsMissionTime) {
  for (const char* name : {"ground", "marvin"}) start(name, 2, 10);
  meet();
  wire::LinkState slow = link(number("ground"), number("marvin"), true);
  slow.latency = Duration::seconds(5).count();
  (*this)["sim"].host->publish(slow, now());
  settle();

  act("ground", {Send{number("marvin"), abort_request(7)}});
  advance(0.45);  // steady: 4.5 s of mission time at rate 10
  const auto early = (*this)["marvin"].diary.samples<wire::TaskRequest>().size();
  advance(0.1);

  EXPECT_EQ(early, 0U);
  EXPECT_EQ((*this)["marvin"].diary.samples<wire::TaskRequest>().size(), 1U);
}

TEST_F(Hosts, TheCapacityOfALinkIsOfMissionTime) {
  for (const char* name : {"marvin", "heliv"}) start(name, 2, 10);
  meet();
  wire::LinkState slow = link(number("marvin"), number("heliv"), true);
  slow.capacity = 1000;  // [bit/s]: at rate 10, ten thousand in a steady second
  (*this)["sim"].host->publish(slow, now());
  settle();
  const wire::FunctionalRequest event;

  act("marvin", {Send{number("heliv"), event}, Send{number("heliv"), event}});
  const double airtime = 8 * static_cast<double>(blackboard::channel_bytes(event)) / 10'000;
  advance(0.9 * airtime);
  const std::size_t soon = (*this)["heliv"].diary.samples<wire::FunctionalRequest>().size();
  advance(20 * airtime);

  EXPECT_LE(soon, 1U);
  EXPECT_EQ((*this)["heliv"].diary.samples<wire::FunctionalRequest>().size(), 2U);
}

TEST_F(Hosts, AHostThatIsToldOfNoCutsKeepsItsChannelsUp) {
  told = ToldOfLinks::kNotOfCuts;
  start("marvin", 2);
  start("heliv", 2);
  meet();

  set_link("marvin", "heliv", false);
  act("marvin", {Send{number("heliv"), wire::FunctionalRequest{}}});
  advance(0.2);

  EXPECT_EQ((*this)["heliv"].diary.samples<wire::FunctionalRequest>().size(), 1U);
  EXPECT_TRUE((*this)["marvin"].host->all_peers_heard());
}

// Found by random missions (--anything --capacity 9600 12): a channel without a limit took a plan
// of 5 kB whole, and when the link was back nothing else was heard for 4 s.
TEST_F(Hosts, AHostThatIsToldOfNoCutsKeepsTheCapacityInOne) {
  told = ToldOfLinks::kNotOfCuts;
  start("marvin", 2);
  start("heliv", 2);
  meet();
  wire::LinkState narrow = link(number("marvin"), number("heliv"), true);
  narrow.capacity = 10'000;
  (*this)["sim"].host->publish(narrow, now());
  settle();
  set_link("marvin", "heliv", false);

  const wire::FunctionalRequest event;
  act("marvin", {Send{number("heliv"), event}, Send{number("heliv"), event}});
  advance(0.9 * 8 * static_cast<double>(blackboard::channel_bytes(event)) / 10'000);

  EXPECT_LE((*this)["heliv"].diary.samples<wire::FunctionalRequest>().size(), 1U);
}

TEST_F(Hosts, AHostThatIsToldNothingOfLinksLosesNothingOfItself) {
  told = ToldOfLinks::kNothing;
  start("marvin", 2);
  start("heliv", 2);
  meet();
  wire::LinkState bad = link(number("marvin"), number("heliv"), false);
  bad.loss = 1;
  bad.latency = 60'000'000'000;
  (*this)["sim"].host->publish(bad, now());
  settle();

  act("marvin", {Send{number("heliv"), wire::FunctionalRequest{}}});
  advance(0.2);

  EXPECT_EQ((*this)["heliv"].diary.samples<wire::FunctionalRequest>().size(), 1U);
}

TEST_F(Hosts, AllStreamsAreLostOnALinkThatLosesAll) {
  meet();
  wire::LinkState bad = link(number("marvin"), number("ground"), true);
  bad.loss = 1;
  (*this)["sim"].host->publish(bad, now());
  settle();

  act("marvin",
      {Send{number("ground"), wire::Telemetry{}}, Send{number("ground"), wire::PlanBoard{}}});
  settle();

  EXPECT_TRUE((*this)["ground"].diary.samples<wire::Telemetry>().empty());
  EXPECT_EQ((*this)["ground"].diary.samples<wire::PlanBoard>().size(), 1U);
}

// Found by skein_dds_foul_words_test: time-outs were reckoned with it, and the daemon ended.
TEST_F(Hosts, AnImpossibleRadioEndsNobodyWhoHasSomethingToSay) {
  for (const char* name : {"marvin", "heliv"}) start(name, 2, 10);
  meet();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr std::int64_t kLongest = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t latency : {kLongest, kLongest / 10, -kLongest, std::int64_t{0}}) {
    for (const double figure : {1e-300, 1e300, -1e300, kNaN}) {
      for (const auto& [from, to] : {std::pair("marvin", "heliv"), std::pair("heliv", "marvin")}) {
        wire::LinkState bad = link(number(from), number(to), true);
        bad.latency = latency;
        bad.capacity = bad.loss = figure;
        (*this)["sim"].host->publish(bad, now());
      }
      settle();
      act("marvin", {Send{number("heliv"), wire::FunctionalRequest{}}});
      advance(1);
    }
  }
  EXPECT_TRUE((*this)["marvin"].host->started());
}

}  // namespace
}  // namespace skein::node
