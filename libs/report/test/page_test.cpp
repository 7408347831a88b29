// SPDX-License-Identifier: Apache-2.0
// The page as a whole: complete, self-contained, safe with any names, small enough.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "builders.hpp"
#include "skein/foundation/random.hpp"
#include "skein/report/report.hpp"
#include "synthetic_mission.hpp"

namespace skein::report {
namespace {

using testing::count;
using testing::expectation;
using testing::message;
using testing::salvage;
using testing::stamp;
using testing::task;
using testing::telemetry;

// The page without its own style sheet and scripts, where markup characters have other meanings.
std::string without_code(std::string html) {
  for (const char* name : {"style", "script"}) {
    const std::string open = "<" + std::string(name), close = "</" + std::string(name) + ">";
    for (std::size_t i = html.find(open); i != std::string::npos; i = html.find(open)) {
      const std::size_t end = html.find(close, i);
      EXPECT_NE(end, std::string::npos);
      html.erase(i, end + close.size() - i);
    }
  }
  return html;
}

// An independent check that elements nest; "" or what is wrong.
std::string nesting_error(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t i = html.find('<'); i != std::string::npos; i = html.find('<', i + 1)) {
    const std::size_t end = html.find('>', i);
    if (end == std::string::npos) return "unclosed tag";
    const std::string tag = html.substr(i + 1, end - i - 1);
    if (tag[0] == '!') continue;
    const std::string name =
        tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != name) return "unexpected </" + name + ">";
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : "left open: " + open.back();
}

std::string comets_page() {
  return html_report(testing::comets_info(), salvage(testing::comets_journal()).journal);
}

TEST(Page, IsWellNested) {
  EXPECT_EQ(nesting_error(without_code(comets_page())), "");
  EXPECT_EQ(nesting_error(without_code(html_report({}, {}))), "");
}

TEST(Page, NeedsNothingFromOutside) {
  const std::string html = comets_page();

  EXPECT_EQ(count(html, "<link"), 0U);
  EXPECT_EQ(count(html, "src="), 0U);
  EXPECT_EQ(count(html, "@import"), 0U);
  EXPECT_EQ(count(html, "url(http"), 0U);
  EXPECT_EQ(count(html, "href=\"http"), 0U);
  EXPECT_EQ(count(html, "fetch("), 0U);
}

TEST(Page, TheSameRunGivesTheSameBytes) { EXPECT_EQ(comets_page(), comets_page()); }

TEST(Page, TheOrderOfTheLogDoesNotMatter) {
  const Journal ordered = salvage(testing::comets_journal()).journal;
  Journal shuffled = ordered;
  std::reverse(shuffled.telemetry.begin(), shuffled.telemetry.end());
  std::reverse(shuffled.alarms.begin(), shuffled.alarms.end());
  std::reverse(shuffled.phases.begin(), shuffled.phases.end());

  const RunInfo info = testing::comets_info();

  EXPECT_EQ(html_report(info, shuffled).size(), html_report(info, ordered).size());
}

TEST(Page, ARunFolderIsEnoughToMakeItAgain) {
  const RunInfo info = testing::comets_info();
  const Journal journal = salvage(testing::comets_journal()).journal;

  const Result<RunInfo, Diagnostics> again = run_info_from_json(to_json(info), "run.json");

  ASSERT_TRUE(again);
  const std::string first = html_report(*again, journal);
  EXPECT_EQ(html_report(*run_info_from_json(to_json(*again), "run.json"), journal), first);
}

TEST(Page, ShowsVerdictExpectationsAndFigures) {
  const std::string html = comets_page();

  EXPECT_EQ(count(html, "<h1>comets-confirmed</h1>"), 1U);
  EXPECT_EQ(count(html, ">1 of 6 failed</span>"), 1U);
  EXPECT_EQ(count(html, "heliv landed at 22:58, 58 s late"), 1U);
  EXPECT_LT(html.find("heliv is home before 22 min"),
            html.find("the alarm at the fire is confirmed"));
  EXPECT_GE(count(html, ">least separation</div>"), 1U);
}

TEST(Page, AGoodRunSaysSo) {
  Journal j;
  j.expectations = {expectation("e", true, "s")};

  EXPECT_EQ(count(html_report({}, j), "<span class=\"verdict passed\">passed</span>"), 1U);
}

TEST(Page, AnEmptyRunIsStillAPage) {
  const std::string html = html_report({}, {});

  EXPECT_EQ(count(html, "nothing expected"), 1U);
  EXPECT_EQ(count(html, "The log holds no checked expectation."), 1U);
}

TEST(Page, TablesTellMessagesAndLinks) {
  const std::string html = comets_page();

  EXPECT_EQ(count(html, "Event messages by slot and channel"), 1U);
  EXPECT_EQ(count(html, "<td>heliv → ground</td>"), 3U);  // two slots, one link
  EXPECT_EQ(count(html, "Links: truth and belief"), 1U);
  EXPECT_EQ(count(html, "<td>95.0 %</td><td>1</td>"), 2U);
}

TEST(Page, TheChronicleTellsWhatWentWrong) {
  const std::string html = comets_page();

  EXPECT_EQ(count(html, "ddn-karma crashed: signal 9</td>"), 1U);
  EXPECT_EQ(count(html, "heliv refused ABORT: unknown task</td>"), 1U);
  EXPECT_EQ(count(html, "link heliv → ground down</td>"), 1U);
}

TEST(Page, TheDataForTheScriptIsJson) {
  const std::string html = comets_page();
  const std::string open = "id=\"data\">";
  const std::size_t begin = html.find(open) + open.size();

  const auto data =
      nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));

  EXPECT_EQ(data.at("uavs").size(), 3U);
  EXPECT_EQ(data.at("uavs").at(0).at("t").size(), data.at("uavs").at(0).at("x").size());
  EXPECT_EQ(data.at("phases").at(0).at(1), "Detection");
  EXPECT_GE(data.at("tasks").size(), 20U);
}

// A journal in which every text is `name`.
Journal named(const std::string& name) {
  Journal j;
  j.tasks = {task(1, name, 1, TaskState::kRunning, name),
             task(2, name, 2, TaskState::kAborted, name)};
  j.tasks[0].type = j.tasks[1].type = name;
  j.requests = {{stamp(1, name), name, name, name, 1, false, name}};
  j.commands = {{stamp(1, name), name, 1, name, CommandState::kRefused, name}};
  j.syncs = {{stamp(1, name), name, name, "ground", Direction::kSent}};
  j.messages = {message(1, name, "ground", 1, Direction::kSent, name)};
  j.links = {{stamp(1), name, "ground", true}, {stamp(2), name, "ground", false}};
  j.reaches = {{stamp(1, name), "ground", true}};
  j.telemetry = {telemetry(0, name, {0, 0, 0}), telemetry(5, name, {50, 0, 0}, false)};
  j.objects = {{stamp(0), name, name, {5, 5, 0}, 1, true}};
  j.phases = {{stamp(0), name}};
  j.operators = {{stamp(0), name}};
  j.alarms = {{stamp(0), 1, AlarmState::kRaised, {9, 9, 0}, 1}};
  j.faults = {{stamp(0), name, name}};
  j.processes = {{stamp(0), name, name, name}};
  j.dropped = {{stamp(0, name), name, name, name, name}};
  j.undelivered = {{stamp(0, name), true, name, name, 1}};
  j.missions = {{stamp(0), name}};
  j.expectations = {expectation(name, false, name)};
  return j;
}

RunInfo named_info(const std::string& name) {
  RunInfo info;
  info.scenario = info.epoch = info.version = name;
  info.uavs = {{name, name, 3}};
  info.zones = {{name, {{0, 0}, {90, 0}, {90, 90}}}};
  info.places = {{name, {30, 30, 0}}};
  return info;
}

TEST(Page, NoNameCanEscapeIntoMarkup) {
  for (const char* name : {"<script>alert(1)</script>", "\"><img src=x onerror=alert(1)>",
                           "</title><script>", "'onmouseover='alert(1)", "</script><!--", "]]>"}) {
    const std::string html = html_report(named_info(name), named(name));

    EXPECT_EQ(nesting_error(without_code(html)), "") << name;
    EXPECT_EQ(count(html, "<script"), 2U) << name;
    EXPECT_EQ(count(html, "</script>"), 2U) << name;
    EXPECT_EQ(count(html, "<img"), 0U) << name;
    EXPECT_EQ(count(html, "<!--"), 0U) << name;
  }
}

RC_GTEST_PROP(Page, IsWellNestedWithAnyNames, (const std::string& name)) {
  const std::string html = html_report(named_info(name), named(name));

  RC_ASSERT(nesting_error(without_code(html)) == "");
  RC_ASSERT(count(html, "<script") == 2U);
}

// Any subset of the lines of a real log, in any order.
RC_GTEST_PROP(Page, AnyPartOfALogGivesAPage, ()) {
  static const std::string log = testing::comets_journal();
  static const std::vector<std::string> lines = [] {
    std::vector<std::string> all;
    std::istringstream in(log);
    for (std::string line; std::getline(in, line);) {
      if (line.find("telemetry") == std::string::npos || all.size() % 20 == 0)
        all.push_back(line);
      else if (line.size() % 37 == 0)
        all.push_back(line);
    }
    return all;
  }();
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::string text;
  for (std::uint64_t n = random.below(60); n > 0; --n)
    text += lines[random.below(lines.size())] + "\n";

  const std::string html = html_report({}, salvage(text).journal);

  RC_ASSERT(nesting_error(without_code(html)) == "");
}

TEST(Page, ExtremeNumbersGiveAPage) {
  Journal j;
  j.telemetry = {telemetry(-1e8, "m", {-1e9, 1e9, 1e9}), telemetry(1e8, "m", {1e9, -1e9, -1e9})};
  j.alarms = {{stamp(1e8), UINT64_MAX, AlarmState::kRaised, {1e9, 1e9, 0}, 1e9}};
  j.objects = {{stamp(0), "f", "fire", {-1e9, 0, 0}, 1e9, true}};
  j.tasks = {task(0, "m", UINT64_MAX, TaskState::kRunning)};

  const std::string html = without_code(html_report({}, j));

  EXPECT_EQ(nesting_error(html), "");
  EXPECT_EQ(count(html, "nan"), 0U);
  EXPECT_EQ(count(html, "=\"inf"), 0U);
}

TEST(Page, TwentyUavsAndAHundredThousandLinesStaySmallAndQuick) {
  const Journal journal = salvage(testing::swarm_journal(20, 100'000, 1)).journal;
  const auto begin = std::chrono::steady_clock::now();

  const std::string html = html_report(testing::swarm_info(20), journal);

  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(html.size(), 10'000'000U);
  // A machine under load or a sanitizer may be slow; 2 s is the goal of the benchmark.
  EXPECT_LT(taken.count(), 20.0);
  EXPECT_EQ(nesting_error(without_code(html)), "");
}

}  // namespace
}  // namespace skein::report
