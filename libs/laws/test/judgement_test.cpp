// SPDX-License-Identifier: Apache-2.0
// One judgement by all laws.
#include "skein/laws/judgement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "skein/journal/lines/radio.hpp"

namespace skein::laws {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;

scenario::Scenario comets() {
  return *scenario::read_scenario(SKEIN_SOURCE_DIR "/scenarios/comets/confirmed.yaml");
}

/// Karma is in contact with Heliv, whom the radio has never connected to it.
std::vector<journal::Record> contact_from_nowhere() {
  return {journal::record_of(MissionTime::seconds(0), "sim",
                             journal::lines::Link{.from = "heliv", .to = "karma", .up = false}),
          journal::record_of(MissionTime::seconds(9), "karma",
                             journal::lines::Reach{.peer = "heliv", .reachable = true})};
}

/// A command is settled that nobody issued.
std::vector<journal::Record> settled_from_nowhere() {
  return {journal::Record(MissionTime::seconds(1), "ground", "command")
              .with("command", 5)
              .with("to", "heliv")
              .with("state", "acknowledged")};
}

std::vector<std::string> laws_of(const std::vector<Violation>& violations) {
  std::set<std::string> names;
  for (const Violation& one : violations) names.insert(one.law);
  return {names.begin(), names.end()};
}

TEST(Judgement, IsByLawsOfTruthOfTheProtocolAndOfTheRadio) {
  std::vector<std::string> names;
  for (const Statement& one : judged_by())
    names.insert(names.end(), one.names.begin(), one.names.end());

  EXPECT_THAT(names, IsSupersetOf({"separation", "energy", "protocol", "healing", "contact"}));
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << "each name once";
}

TEST(Judgement, OfNothingFindsNothing) { EXPECT_THAT(judge(comets(), {}), IsEmpty()); }

TEST(Judgement, FindsWhatBreaksTheProtocol) {
  EXPECT_THAT(laws_of(judge(comets(), settled_from_nowhere())), ElementsAre("protocol"));
}

TEST(Judgement, FindsContactsThatTheRadioDoesNotGive) {
  EXPECT_THAT(laws_of(judge(comets(), contact_from_nowhere())), ElementsAre("contact"));
}

TEST(Judgement, OverDdsDoesNotAskWhenContactsBegan) {
  EXPECT_THAT(judge(comets(), contact_from_nowhere(), {{}, Duration::seconds(1)}), IsEmpty());
}

/// Karma's message to Heliv is sent, or received.
journal::Record message(double at, const char* node, const char* direction) {
  return journal::record_of(MissionTime::seconds(at), node,
                            journal::lines::Message{.slot = "Decision",
                                                    .from = "karma",
                                                    .to = "heliv",
                                                    .sequence = 1,
                                                    .direction = direction});
}

/// Their link goes down.
journal::Record cut(double at) {
  return journal::record_of(MissionTime::seconds(at), "sim",
                            journal::lines::Link{.from = "karma", .to = "heliv", .up = false});
}

/// What Heliv hears of Karma so long after their link went down.
std::vector<std::string> laws_on_what_comes_after_a_cut(double seconds,
                                                        const scenario::RadioSpec& radio) {
  scenario::Scenario scenario = comets();
  scenario.radio = radio;
  return laws_of(
      judge(scenario,
            {message(9.9, "karma", "sent"), cut(10), message(10 + seconds, "heliv", "received")},
            {{"protocol"}, {}}));
}

// Found by random missions (--anything --capacity 9600 985006).
TEST(Judgement, OfANarrowSilentRadioWhatWasOnTheAirArrives) {
  scenario::RadioSpec narrow = comets().radio;
  narrow.silent = true;
  narrow.model.capacity = 9'600;
  scenario::RadioSpec wide = narrow, told = narrow;
  wide.model.capacity = 0;
  told.silent = false;

  EXPECT_THAT(laws_on_what_comes_after_a_cut(1.5, narrow), IsEmpty());
  EXPECT_THAT(laws_on_what_comes_after_a_cut(4, narrow), ElementsAre("protocol"));
  EXPECT_THAT(laws_on_what_comes_after_a_cut(1.5, wide), ElementsAre("protocol"));
  EXPECT_THAT(laws_on_what_comes_after_a_cut(1.5, told), ElementsAre("protocol"));
}

// Found by random missions (--minds --capacity 19200 985005).
TEST(Judgement, WhatWasTransmittedBeforeACutArrives) {
  scenario::RadioSpec slow = comets().radio;
  slow.model.latency = Duration::milliseconds(800);

  EXPECT_THAT(laws_on_what_comes_after_a_cut(0.72, slow), IsEmpty());
  EXPECT_THAT(laws_on_what_comes_after_a_cut(0.72, comets().radio), ElementsAre("protocol"));
}

/// Heliv hears Karma over a link that has been down for a minute.
std::vector<journal::Record> heard_over_no_link() {
  return {cut(0), message(60, "karma", "sent"), message(61, "heliv", "received")};
}

TEST(Judgement, FindsWhatComesOverNoLinkUnlessTheRadioIsNotThatOfTheSimulator) {
  scenario::Scenario silent = comets();
  silent.radio.silent = true;

  EXPECT_THAT(laws_of(judge(comets(), heard_over_no_link(), {{}, Duration::seconds(1)})),
              ElementsAre("protocol"));
  EXPECT_THAT(judge(silent, heard_over_no_link(), {{}, Duration::seconds(1)}), IsEmpty());
}

TEST(Judgement, IsByTheLawsAskedForAlone) {
  EXPECT_THAT(judge(comets(), settled_from_nowhere(), {{"contact", "energy"}}), IsEmpty());
}

}  // namespace
}  // namespace skein::laws
