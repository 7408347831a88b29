// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "builders.hpp"
#include "reading/field_reader.hpp"
#include "skein/report/journal.hpp"
#include "synthetic_mission.hpp"

namespace skein::report {
namespace {

using testing::salvage;

TEST(ReadJournal, EveryKindOfTheSchemaIsRead) {
  std::istringstream in(
      R"({"at":1,"node":"m","kind":"task","uav":"m","task":3,"type":"goto","state":"running","reason":"r"}
{"at":1,"node":"m","kind":"request","uav":"m","request":"START","mode":"SEQ","task":3,"accepted":false,"why":"w"}
{"at":1,"node":"g","kind":"command","uav":"m","command":4,"what":"goto","state":"expired","why":"w"}
{"at":1,"node":"m","kind":"sync","id":551,"from":"m","to":"h","direction":"received"}
{"at":1,"node":"m","kind":"message","slot":"Alarm","from":"m","to":"g","sequence":9,"direction":"sent"}
{"at":1,"node":"sim","kind":"link","from":"m","to":"g","up":true}
{"at":1,"node":"m","kind":"reach","peer":"g","reachable":false}
{"at":1,"node":"sim","kind":"telemetry","uav":"m","position":[1,2,3],"velocity":[4,5,6],"heading":0.5,"energy":0.75,"airborne":true}
{"at":1,"node":"sim","kind":"object","name":"fire","type":"fire","position":[1,2,3],"radius":6,"active":true}
{"at":1,"node":"g","kind":"perception","uav":"m","device":"ir","detections":2}
{"at":1,"node":"g","kind":"alarm","alarm":7,"state":"infirmed","position":[1,2,3],"belief":0.25}
{"at":1,"node":"g","kind":"phase","name":"Detection"}
{"at":1,"node":"g","kind":"operator","does":"stop"}
{"at":1,"node":"g","kind":"lost-uav","uav":"m"}
{"at":1,"node":"g","kind":"found-uav","uav":"m"}
{"at":1,"node":"g","kind":"degree","uav":"m","degree":4}
{"at":1,"node":"r","kind":"fault","what":"kill","target":"m"}
{"at":1,"node":"r","kind":"process","name":"ddn-m","state":"crashed","why":"signal 9"}
{"at":1,"node":"m","kind":"dropped","slot":"Alarm","origin":"x","field":"belief","why":"w"}
{"at":1,"node":"m","kind":"expired","slot":"Alarm","to":"g","sequence":8,"from":"m"}
{"at":1,"node":"m","kind":"lost","slot":"Alarm","to":"g","sequence":9,"last":9,"from":"m"}
{"at":1,"node":"g","kind":"mission","state":"finished"}
{"at":1,"node":"r","kind":"expectation","name":"e","passed":true,"seen":"s"}
)");

  const Result<Journal, Diagnostics> read = read_journal(in, "e.jsonl");

  ASSERT_TRUE(read) << to_text(read.error());
  EXPECT_EQ(read->tasks.at(0).state, TaskState::kRunning);
  EXPECT_EQ(read->tasks.at(0).reason, "r");
  EXPECT_EQ(read->requests.at(0).task, 3);
  EXPECT_FALSE(read->requests.at(0).accepted);
  EXPECT_EQ(read->commands.at(0).state, CommandState::kExpired);
  EXPECT_EQ(read->syncs.at(0).id, "551");
  EXPECT_EQ(read->syncs.at(0).direction, Direction::kReceived);
  EXPECT_EQ(read->messages.at(0).sequence, 9);
  EXPECT_TRUE(read->links.at(0).up);
  EXPECT_FALSE(read->reaches.at(0).reachable);
  EXPECT_EQ(read->telemetry.at(0).velocity, (Position{4, 5, 6}));
  EXPECT_DOUBLE_EQ(read->telemetry.at(0).energy, 0.75);
  EXPECT_EQ(read->objects.at(0).position, (Position{1, 2, 3}));
  EXPECT_EQ(read->perceptions.at(0).detections, 2);
  EXPECT_EQ(read->alarms.at(0).state, AlarmState::kInfirmed);
  EXPECT_EQ(read->phases.at(0).name, "Detection");
  EXPECT_EQ(read->operators.at(0).does, "stop");
  EXPECT_EQ(read->operators.at(1).does, "m is lost");
  EXPECT_EQ(read->operators.at(2).does, "m is found");
  EXPECT_EQ(read->degrees.at(0).degree, 4);
  EXPECT_EQ(read->faults.at(0).target, "m");
  EXPECT_EQ(read->processes.at(0).state, "crashed");
  EXPECT_EQ(read->dropped.at(0).field, "belief");
  EXPECT_TRUE(read->undelivered.at(0).expired);
  EXPECT_FALSE(read->undelivered.at(1).expired);
  EXPECT_EQ(read->missions.at(0).state, "finished");
  EXPECT_TRUE(read->expectations.at(0).passed);
  EXPECT_EQ(read->tasks.at(0).stamp.line, 1U);
  EXPECT_EQ(read->expectations.at(0).stamp.line, 23U);
}

TEST(ReadJournal, OptionalKeysMayBeAbsentOrNull) {
  const SalvagedJournal read = salvage(
      "{\"at\":0,\"node\":\"m\",\"kind\":\"task\",\"uav\":\"m\",\"task\":1,\"type\":\"t\","
      "\"state\":\"ended\"}\n"
      "{\"at\":0,\"node\":\"m\",\"kind\":\"request\",\"uav\":\"m\",\"request\":\"PROCESS-MSG\","
      "\"task\":null,\"accepted\":true,\"why\":null}\n");

  EXPECT_TRUE(read.errors.empty()) << to_text(read.errors);
  EXPECT_FALSE(read.journal.requests.at(0).task);
}

TEST(ReadJournal, UnknownKeysAreKept) {
  const SalvagedJournal read =
      salvage(R"({"at":2,"node":"g","kind":"phase","name":"A","colour":"red","deep":{"x":[1]}})");

  ASSERT_EQ(read.journal.phases.size(), 1U);
  EXPECT_EQ(read.journal.phases[0].stamp.extra, R"({"colour":"red","deep":{"x":[1]}})");
}

TEST(ReadJournal, KnownLinesKeepNothingExtra) {
  const SalvagedJournal read = salvage(R"({"at":2,"node":"g","kind":"phase","name":"A"})");

  EXPECT_EQ(read.journal.phases.at(0).stamp.extra, "");
}

TEST(ReadJournal, UnknownKindsAreKept) {
  const SalvagedJournal read = salvage(R"({"at":2,"node":"g","kind":"weather","wind":3})");

  EXPECT_TRUE(read.errors.empty());
  ASSERT_EQ(read.journal.others.size(), 1U);
  EXPECT_EQ(read.journal.others[0].kind, "weather");
  EXPECT_EQ(read.journal.others[0].stamp.extra, R"({"wind":3})");
}

TEST(ReadJournal, ABadLineIsToldWithItsNumberAndTheOthersAreSalvaged) {
  const SalvagedJournal read = salvage(
      "{\"at\":1,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"A\"}\n"
      "\n"
      "not json\n"
      "[1,2]\n"
      "{\"at\":4,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"B\"}\r\n"
      "{\"at\":5,\"node\":\"g\",\"kind\":\"pha");

  EXPECT_EQ(to_text(read.errors),
            "e.jsonl:3: not valid JSON\n"
            "e.jsonl:4: not a JSON object\n"
            "e.jsonl:6: not valid JSON\n");
  EXPECT_EQ(read.journal.phases.size(), 2U);
  EXPECT_EQ(read.journal.unreadable, 3U);
}

TEST(ReadJournal, OneBadLineFailsTheStrictReading) {
  std::istringstream in("{\"at\":1}\n");

  const Result<Journal, Diagnostics> read = read_journal(in, "e.jsonl");

  ASSERT_FALSE(read);
  EXPECT_EQ(to_text(read.error()),
            "e.jsonl:1: node: missing key\n"
            "e.jsonl:1: kind: missing key\n");
}

TEST(ReadJournal, AllFaultsOfALineAreTold) {
  const SalvagedJournal read = salvage(
      R"({"at":"x","node":3,"kind":"task","uav":"m","task":1.5,"type":7,"state":"runing"})");

  EXPECT_EQ(to_text(read.errors),
            "e.jsonl:1: at: not a number; expected a number\n"
            "e.jsonl:1: task: not an identifier; expected an unsigned 64-bit integer\n"
            "e.jsonl:1: type: not a text; expected a string\n"
            "e.jsonl:1: state: unknown value 'runing'; expected scheduled, started, running, "
            "aborting, ended, aborted; did you mean 'running'?\n");
  EXPECT_TRUE(read.journal.tasks.empty());
}

TEST(ReadJournal, NumbersOutOfRangeAreRefused) {
  const SalvagedJournal read = salvage(
      "{\"at\":1e9,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"A\"}\n"
      "{\"at\":1e999,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"A\"}\n"
      "{\"at\":1,\"node\":\"g\",\"kind\":\"alarm\",\"alarm\":1,\"state\":\"raised\","
      "\"position\":[0,0,1e300],\"belief\":1}\n"
      "{\"at\":1,\"node\":\"g\",\"kind\":\"degree\",\"uav\":\"m\",\"degree\":18446744073709551615}"
      "\n");

  EXPECT_EQ(read.errors.size(), 4U) << to_text(read.errors);
  EXPECT_TRUE(read.journal.phases.empty());
  EXPECT_TRUE(read.journal.alarms.empty());
  EXPECT_TRUE(read.journal.degrees.empty());
}

TEST(ReadJournal, AnIdentifierMayBeDecimalText) {
  const SalvagedJournal read = salvage(
      "{\"at\":1,\"node\":\"m\",\"kind\":\"lost\",\"slot\":\"Alarm\",\"to\":\"g\","
      "\"sequence\":\"18446744073709551615\",\"last\":1,\"from\":\"m\"}\n"
      "{\"at\":1,\"node\":\"m\",\"kind\":\"lost\",\"slot\":\"Alarm\",\"to\":\"g\","
      "\"sequence\":\"12x\",\"last\":1,\"from\":\"m\"}\n"
      "{\"at\":1,\"node\":\"m\",\"kind\":\"lost\",\"slot\":\"Alarm\",\"to\":\"g\","
      "\"sequence\":-1,\"last\":1,\"from\":\"m\"}\n");

  ASSERT_EQ(read.journal.undelivered.size(), 1U);
  EXPECT_EQ(read.journal.undelivered[0].sequence, UINT64_MAX);
  EXPECT_EQ(read.errors.size(), 2U);
}

TEST(ReadJournal, PositionsHaveThreeNumbers) {
  for (const char* bad : {"[1,2]", "[1,2,3,4]", "[1,2,\"3\"]", "{}", "null", "7"}) {
    const SalvagedJournal read =
        salvage(std::string(R"({"at":1,"node":"g","kind":"alarm","alarm":1,"state":"raised",)") +
                R"("belief":1,"position":)" + bad + "}");

    EXPECT_EQ(read.errors.size(), 1U) << bad;
    EXPECT_TRUE(read.journal.alarms.empty()) << bad;
  }
}

TEST(ReadJournal, DeepNestingIsRefusedNotFollowed) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');

  const SalvagedJournal read =
      salvage(R"({"at":1,"node":"g","kind":"phase","name":"A","x":)" + deep + "}");

  EXPECT_EQ(to_text(read.errors), "e.jsonl:1: nested too deeply; expected at most 64 levels\n");
}

TEST(ReadJournal, BadUtf8IsABadLine) {
  const SalvagedJournal read =
      salvage("{\"at\":1,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"\xff\"}");

  EXPECT_EQ(read.errors.size(), 1U);
}

TEST(ReadJournal, RecordsComeInTheOrderOfTimeThenOfTheFile) {
  const SalvagedJournal read = salvage(
      "{\"at\":5,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"C\"}\n"
      "{\"at\":1,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"A\"}\n"
      "{\"at\":1,\"node\":\"g\",\"kind\":\"phase\",\"name\":\"B\"}\n");

  ASSERT_EQ(read.journal.phases.size(), 3U);
  EXPECT_EQ(read.journal.phases[0].name, "A");
  EXPECT_EQ(read.journal.phases[1].name, "B");
  EXPECT_EQ(read.journal.phases[2].name, "C");
}

TEST(ReadJournal, AnEmptyFileIsAnEmptyJournal) {
  std::istringstream in("");

  const Result<Journal, Diagnostics> read = read_journal(in, "e.jsonl");

  ASSERT_TRUE(read);
  EXPECT_TRUE(read->tasks.empty());
}

TEST(ReadJournal, TheSyntheticMissionIsWithoutFault) {
  const SalvagedJournal read = salvage(testing::comets_journal());

  EXPECT_TRUE(read.errors.empty()) << to_text(read.errors);
  EXPECT_TRUE(read.journal.others.empty());
}

RC_GTEST_PROP(ReadJournal, AnyBytesAreReadOrTold, (const std::string& text)) {
  const SalvagedJournal read = salvage(text);

  RC_ASSERT(read.errors.size() >= read.journal.unreadable);
}

// A good line, with one place overwritten by noise: read or refused, never anything else.
RC_GTEST_PROP(ReadJournal, ADamagedLineIsReadOrTold, ()) {
  std::string line = R"({"at":1.5,"node":"sim","kind":"telemetry","uav":"m","position":[1,2,3],)"
                     R"("velocity":[4,5,6],"heading":0.5,"energy":0.75,"airborne":true})";
  const auto place = *rc::gen::inRange<std::size_t>(0, line.size());
  line.replace(place, *rc::gen::inRange<std::size_t>(0, 4), *rc::gen::arbitrary<std::string>());

  const SalvagedJournal read = salvage(line);

  const std::size_t kept = read.journal.telemetry.size() + read.journal.others.size();
  RC_ASSERT(kept + read.journal.unreadable >= 1U ||
            line.find_first_not_of("\r\n") == std::string::npos);
}

TEST(Nesting, IgnoresWhatIsQuoted) {
  EXPECT_EQ(nesting(R"({"a":"[[[[","b":["\"[["]})"), 2U);
  EXPECT_EQ(nesting("]]]]"), 0U);
  EXPECT_EQ(nesting(""), 0U);
}

}  // namespace
}  // namespace skein::report
