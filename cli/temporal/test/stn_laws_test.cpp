// SPDX-License-Identifier: Apache-2.0
// What the commands say of one network agrees between them, between text and JSON, and does not
// depend on the format of the file; bad input of each kind ends alike.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_files/network_text.hpp"
#include "skein/temporal_lab/stnu_generator.hpp"
#include "skein/temporal_tool/stn.hpp"
#include "stn_runs.hpp"

namespace skein::temporal_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Outcome;
using testing::run;
using ::testing::StartsWith;

StnOptions as_json() {
  StnOptions options;
  options.json = true;
  return options;
}

nlohmann::json dates_of(const std::string& input) {
  const Outcome outcome = run(check_stn, StnCheckOptions{as_json(), true}, input);
  return nlohmann::json::parse(outcome.out).at("dates");
}

std::string converted(const std::string& input, const std::string& format) {
  const Outcome outcome = run(convert_stn, StnConvertOptions{{}, format, ""}, input);
  EXPECT_EQ(outcome.code, kExitOk) << outcome.err;
  return outcome.out;
}

/// Arcs between the same two nodes as one with the bounds of all, as files want them.
temporal::Stnu joined(temporal::Stnu network) {
  std::map<std::pair<temporal::NodeIndex, temporal::NodeIndex>, temporal::Arc> arcs;
  for (const temporal::Arc& arc : network.arcs) {
    temporal::Arc& one = arcs.emplace(std::pair(arc.from, arc.to), arc).first->second;
    one.min = std::max(one.min, arc.min);
    one.max = std::min(one.max, arc.max);
  }
  network.arcs.clear();
  for (const auto& [pair, arc] : arcs) network.arcs.push_back(arc);
  return network;
}

/// Ten networks, every other one not controllable.
std::vector<std::string> generated() {
  Random random(3);
  std::vector<std::string> texts;
  for (int i = 0; i < 10; ++i) {
    temporal::StnuGeneratorOptions options;
    options.nodes = 25;
    options.contingent = 3;
    options.lanes = 3;
    options.break_it = i % 2 == 1;
    const temporal::Stnu network = joined(temporal::generate_stnu(options, random));
    texts.push_back(temporal::write_network(network, temporal::Format::kJson).value());
  }
  return texts;
}

// a may start from 0 to 10; b ends 2 to 3 after it; the deadline of b is DEADLINE.
std::string with_deadline(const std::string& deadline) {
  return R"({"nodes":["v0","a","b"],
    "arcs":[{"from":"v0","to":"a","min":0,"max":10},{"from":"v0","to":"b","min":0,"max":)" +
         deadline + R"(}],"contingent":[{"from":"a","to":"b","min":2,"max":3}]})";
}

TEST(StnLaws, ExitCodesFollowTheVerdictAtTheVeryNanosecond) {
  EXPECT_EQ(run(check_stn_controllability, StnOptions{}, with_deadline("3")).code, kExitOk);
  EXPECT_EQ(run(check_stn_controllability, StnOptions{}, with_deadline("2.999999999")).code,
            kExitNegative);
  EXPECT_EQ(run(check_stn, StnCheckOptions{}, with_deadline("2")).code, kExitOk);
  EXPECT_EQ(run(check_stn, StnCheckOptions{}, with_deadline("1.999999999")).code, kExitNegative);
}

TEST(StnLaws, TextAndJsonSayTheSame) {
  for (const std::string& input : generated()) {
    const Outcome text = run(check_stn_controllability, StnOptions{}, input);
    const Outcome json = run(check_stn_controllability, as_json(), input);
    const nlohmann::json object = nlohmann::json::parse(json.out);

    EXPECT_EQ(text.code, json.code);
    EXPECT_EQ(object.at("controllable"), json.code == kExitOk);
    EXPECT_EQ(object.at("conflict").empty(), json.code == kExitOk);
    EXPECT_EQ(text.out.find("not dynamically controllable") == std::string::npos,
              json.code == kExitOk);
  }
}

TEST(StnLaws, ThePlanThatIsBrokenIsTheOneThatIsNotDispatched) {
  int broken = 0;
  for (const std::string& input : generated()) {
    const int dc = run(check_stn_controllability, StnOptions{}, input).code;
    for (const StnStarts starts : {StnStarts::kEarliest, StnStarts::kLatest, StnStarts::kRandom}) {
      StnDispatchOptions options;
      options.starts = starts;
      EXPECT_EQ(run(dispatch_stn, options, input).code, dc);
    }
    broken += dc == kExitNegative ? 1 : 0;
  }
  EXPECT_EQ(broken, 5);
}

TEST(StnLaws, TheFormatChangesNeitherVerdictNorDates) {
  for (const std::string& input : generated()) {
    const int verdict = run(check_stn_controllability, StnOptions{}, input).code;
    nlohmann::json dates = dates_of(input);
    dates.erase("z");
    for (const char* format : {"json", "graphml", "plain", "heatlab"}) {
      const std::string text = converted(input, format);

      EXPECT_EQ(run(check_stn_controllability, StnOptions{}, text).code, verdict) << format;
      nlohmann::json carried = dates_of(text);
      for (const char* origin : {"z", "Z", "0"}) carried.erase(origin);
      EXPECT_EQ(carried, dates) << format;
    }
  }
}

TEST(StnLaws, ConvertingTwiceIsConvertingOnce) {
  for (const std::string& input : generated()) {
    for (const char* format : {"json", "graphml", "plain", "heatlab"}) {
      const std::string once = converted(input, format);

      EXPECT_EQ(converted(once, format), once) << format;
    }
  }
}

TEST(StnCheckDates, AreExactAndNullWithoutABound) {
  const nlohmann::json dates = dates_of(
      R"({"nodes":["v0","a","b"],"arcs":[{"from":"v0","to":"a","min":0.000000001,"max":7.25},
          {"from":"a","to":"b","min":1,"max":null}]})");

  EXPECT_EQ(dates.dump(), R"({"a":[1e-09,7.25],"b":[1.000000001,null],"v0":[0,0]})");
}

TEST(StnCheckDates, AreNullOfAnInconsistentNetworkWhoseConflictIsNamed) {
  const Outcome outcome = run(check_stn, StnCheckOptions{as_json(), true}, with_deadline("1"));
  const nlohmann::json object = nlohmann::json::parse(outcome.out);

  EXPECT_EQ(outcome.code, kExitNegative);
  EXPECT_EQ(object.at("dates"), nullptr);
  EXPECT_EQ(object.at("controllable"), false);
  EXPECT_EQ(object.at("conflict").size(), 3U) << "a not before 0, 2 at least, 1 at most";
}

TEST(StnCheckDates, AreATableForPeople) {
  StnCheckOptions options;
  options.dates = true;

  const Outcome outcome = run(check_stn, options, with_deadline("5"));

  EXPECT_THAT(outcome.out, HasSubstr("node  earliest  latest"));
  EXPECT_THAT(outcome.out, HasSubstr("  b     2         5"));
}

TEST(StnDispatchLaws, StartsAtTheEarliestAndAtTheLatestDateThatNatureAllows) {
  const auto start_of_a = [](StnStarts starts) {
    StnDispatchOptions options;
    options.common.json = true;
    options.starts = starts;
    const Outcome outcome = run(dispatch_stn, options, with_deadline("8"));
    return nlohmann::json::parse(outcome.out).at("events").at(1).at("at").get<double>();
  };

  EXPECT_EQ(start_of_a(StnStarts::kEarliest), 0);
  EXPECT_EQ(start_of_a(StnStarts::kLatest), 5) << "8 less the longest duration";
}

TEST(StnDispatchLaws, WhatIsControllableButBeginsBeforeTheOriginIsNotCalledUncontrollable) {
  // a comes 1 to 2 before v0, with which an execution begins.
  const std::string input =
      R"({"nodes":["v0","a"],"arcs":[{"from":"a","to":"v0","min":1,"max":2}]})";
  ASSERT_EQ(run(check_stn_controllability, StnOptions{}, input).code, kExitOk);

  const Outcome text = run(dispatch_stn, StnDispatchOptions{}, input);
  StnDispatchOptions options;
  options.common.json = true;
  const Outcome json = run(dispatch_stn, options, input);

  EXPECT_EQ(text.code, kExitNegative);
  EXPECT_THAT(text.out, HasSubstr("a node must come before 'v0'"));
  EXPECT_EQ(text.out.find("not dynamically controllable"), std::string::npos);
  EXPECT_EQ(json.code, kExitNegative);
  EXPECT_EQ(nlohmann::json::parse(json.out).at("controllable"), true);
  EXPECT_EQ(nlohmann::json::parse(json.out).at("complete"), false);
}

TEST(StnDispatchLaws, ThePartsOfAConflictAreThoseOfTheCheck) {
  StnDispatchOptions options;
  options.common.json = true;

  const Outcome dispatched = run(dispatch_stn, options, with_deadline("2.5"));
  const Outcome checked = run(check_stn_controllability, as_json(), with_deadline("2.5"));

  EXPECT_EQ(dispatched.code, kExitNegative);
  EXPECT_EQ(nlohmann::json::parse(dispatched.out).at("conflict"),
            nlohmann::json::parse(checked.out).at("conflict"));
}

TEST(StnBadInput, OfEveryKindIsSaidAtItsPlaceWithTheSameExitCode) {
  const auto link = [](const char* where, const std::string& min, const std::string& max) {
    const std::string text = R"({"from":"v0","to":"a","min":)" + min + R"(,"max":)" + max + "}";
    const bool contingent = std::string(where) == "contingent";
    return R"({"nodes":["v0","a"],"arcs":[)" + (contingent ? "" : text) + R"(],"contingent":[)" +
           (contingent ? text : "") + "]}";
  };
  struct Bad {
    std::string text;
    const char* what;
  };
  const std::vector<Bad> inputs = {
      {link("arcs", "2", "1"), "min 2 is greater than max 1"},
      {link("arcs", "0", "NaN"), "not a number"},
      {link("arcs", "0", "1e11"), "overflows"},
      {link("contingent", "0", "1"), "not positive"},
      {link("contingent", "1", "null"), "max is infinite"},
      {R"({"nodes":["v0"],"arcs":[{"from":"v0","to":"b","min":0,"max":1}]})", "unknown node 'b'"},
      {R"({"agents":["A"],"nodes":[{"name":"a","agent":"B"}],"arcs":[]})", "unknown agent 'B'"},
  };
  for (const Bad& bad : inputs) {
    const Outcome outcome = run(check_stn, StnCheckOptions{as_json(), true}, bad.text);

    EXPECT_EQ(outcome.code, kExitBadInput) << bad.text;
    EXPECT_THAT(outcome.out, IsEmpty()) << bad.text;
    EXPECT_THAT(outcome.err, StartsWith("standard input:")) << bad.text;
    EXPECT_THAT(outcome.err, HasSubstr(bad.what));
  }
}

TEST(StnBadInput, DatesThatOverflowAreAnErrorAndNoCrash) {
  const std::string far = R"("min":1152921504,"max":null})";
  const std::string input = R"({"nodes":["v0","a","b","c"],"arcs":[{"from":"v0","to":"a",)" + far +
                            R"(,{"from":"a","to":"b",)" + far + R"(,{"from":"b","to":"c",)" + far +
                            "]}";

  for (const Outcome& outcome : {run(check_stn, StnCheckOptions{}, input),
                                 run(check_stn_controllability, StnOptions{}, input),
                                 run(dispatch_stn, StnDispatchOptions{}, input)}) {
    EXPECT_EQ(outcome.code, kExitBadInput);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, StartsWith("standard input: "));
  }
  StnDrawOptions dot;
  dot.dot = true;
  EXPECT_EQ(run(draw_stn, dot, input).code, kExitOk) << "it is drawn all the same";
}

}  // namespace
}  // namespace skein::temporal_tool
