// SPDX-License-Identifier: Apache-2.0
// Records in words.
#include "skein/journal/log_line.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace skein::journal {
namespace {

Record line(const std::string& kind) { return {MissionTime::seconds(1), "marvin", kind}; }

std::string said(const Record& record) {
  const auto line = log_line_of(record);
  return line ? line->text : "nothing";
}

TEST(LogLine, OfADecisionSaysWhatBecauseOfWhat) {
  EXPECT_EQ(said(line("decision")
                     .with("operator", "repair")
                     .with("cause", "late")
                     .with("outcome", "planned anew")),
            "decides repair because of late: planned anew");
}

TEST(LogLine, IsThereForRefusalsAndNotForWhatWentWell) {
  const auto request = [](bool accepted) {
    return line("request").with("request", "START").with("accepted", accepted).with("why", "busy");
  };
  EXPECT_EQ(said(request(false)), "refuses START: busy");
  EXPECT_EQ(said(request(true)), "nothing");
  EXPECT_EQ(said(line("command").with("state", "acknowledged")), "nothing");
  EXPECT_EQ(said(line("telemetry").with("uav", "marvin")), "nothing");
}

TEST(LogLine, OfAnExpectationThatIsNotMetIsAnError) {
  const auto told = log_line_of(
      line("expectation").with("name", "it lands").with("passed", false).with("seen", "never"));

  ASSERT_TRUE(told.has_value());
  EXPECT_EQ(told->level, Level::kError);
  EXPECT_EQ(told->text, "it lands: not met: never");
}

TEST(LogLine, OfATaskIsThereWhenItWasAborted) {
  const auto task = [](const char* state) {
    return line("task")
        .with("task", 4)
        .with("type", "goto")
        .with("state", state)
        .with("reason", "wind");
  };
  EXPECT_EQ(said(task("aborted")), "task 4 goto aborted: wind");
  EXPECT_EQ(said(task("ended")), "nothing");
}

// ---- every kind that is told, by a table derived from docs/journal.md ----

struct Told {
  const char* json;  ///< behind at and node
  Level level;
  const char* text;
};

Record parsed(const std::string& rest) {
  auto record = parse_record(R"({"at":1,"node":"marvin",)" + rest + "}");
  EXPECT_TRUE(record.has_value()) << rest;
  return record.value_or(Record());
}

TEST(LogLine, OfEachKindIsASentenceOfItsLevel) {
  const std::vector<Told> all = {
      {R"("kind":"command","uav":"heliv","state":"refused","what":"LAND","why":"busy")",
       Level::kWarning, "command to heliv refused: LAND: busy"},
      {R"("kind":"command","uav":"heliv","state":"expired","what":"LAND")", Level::kWarning,
       "command to heliv expired: LAND"},
      {R"("kind":"answer","mission":7,"planned":false,"why":"no method")", Level::kWarning,
       "cannot plan mission 7: no method"},
      {R"("kind":"goal","goal":3,"statement":"perceive P1 60","state":"failed","why":"wind")",
       Level::kWarning, "goal 3 perceive P1 60 is failed: wind"},
      {R"("kind":"goal","goal":3,"statement":"perceive P1 60","state":"achieved")", Level::kInfo,
       "goal 3 perceive P1 60 is achieved"},
      {R"("kind":"task","task":4,"type":"goto","state":"aborted")", Level::kWarning,
       "task 4 goto aborted"},
      {R"("kind":"alarm","alarm":2,"state":"confirmed")", Level::kWarning, "alarm 2 confirmed"},
      {R"("kind":"expectation","name":"it lands","passed":true,"seen":"at 5 s")", Level::kInfo,
       "it lands: met"},
      {R"("kind":"process","name":"ddn-marvin","state":"crashed","why":"signal 9")", Level::kError,
       "ddn-marvin crashed: signal 9"},
      {R"("kind":"degree","uav":"heliv","degree":3)", Level::kInfo, "heliv is at degree 3"},
      {R"("kind":"phase","name":"confirm")", Level::kInfo, "phase confirm"},
      {R"("kind":"mission","state":"begins")", Level::kInfo, "mission begins"},
      {R"("kind":"operator","does":"closes the air")", Level::kInfo, "operator: closes the air"},
      {R"("kind":"fault","what":"kill","target":"heliv")", Level::kError, "fault: kill of heliv"},
      {R"("kind":"notice","text":"it rains")", Level::kInfo, "it rains"},
      {R"("kind":"contact","policy":"hold","why":"30 s")", Level::kWarning,
       "contact lost: hold: 30 s"},
      {R"("kind":"owner","task":5,"stage":"granted","owners":"heliv karma","why":"cheapest")",
       Level::kInfo, "team task 5 granted by heliv karma: cheapest"},
      {R"("kind":"owner","task":5,"stage":"for sale","owners":"")", Level::kInfo,
       "team task 5 for sale"},
  };
  for (const Told& one : all) {
    const auto line = log_line_of(parsed(one.json));
    ASSERT_TRUE(line.has_value()) << one.json;
    EXPECT_EQ(line->text, one.text);
    EXPECT_EQ(line->level, one.level) << one.json;
  }
}

TEST(LogLine, IsNotThereForWhatWentAsItShould) {
  for (const char* json :
       {R"("kind":"answer","mission":7,"planned":true)",
        R"("kind":"answer","mission":7,"planned":false,"evaluated":true)",
        R"("kind":"command","state":"issued")", R"("kind":"process","state":"started")",
        R"("kind":"task","state":"started")", R"("kind":"unheard-of","text":"x")"})
    EXPECT_FALSE(log_line_of(parsed(json)).has_value()) << json;
}

TEST(LogLine, NamesGreatIdsWithAllTheirDigits) {
  const auto aborted = [](std::uint64_t task) {
    return said(line("task").with("task", task).with("type", "goto").with("state", "aborted"));
  };
  EXPECT_EQ(aborted(9'007'199'254'740'993U), "task 9007199254740993 goto aborted");
  EXPECT_EQ(aborted(18'446'744'073'709'551'615U), "task 18446744073709551615 goto aborted");
}

TEST(LogLine, OfALineThatLacksItsFiguresOrHasUselessOnesIsOneAllTheSame) {
  EXPECT_EQ(said(parsed(R"("kind":"alarm","state":"raised")")), "alarm 0 raised");
  EXPECT_EQ(said(parsed(R"("kind":"alarm","alarm":1e300,"state":"raised")")),
            "alarm 1e+300 raised");
  EXPECT_EQ(said(parsed(R"("kind":"alarm","alarm":[1,2],"state":"raised")")), "alarm 0 raised");
}

}  // namespace
}  // namespace skein::journal
