// SPDX-License-Identifier: Apache-2.0
// Small drawings, byte for byte, in test/golden. To accept a changed look, run once with
// SKEIN_UPDATE_GOLDEN=1 in the environment and look at the difference before committing it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "builders.hpp"
#include "page/views.hpp"

namespace skein::report {
namespace {

using testing::message;
using testing::stamp;
using testing::task;
using testing::telemetry;

std::string path_of(const std::string& name) {
  return std::string(SKEIN_SOURCE_DIR) + "/libs/report/test/golden/" + name;
}

// One element a line, so that a difference can be read.
std::string by_line(const std::string& svg) {
  std::string text;
  for (std::size_t i = 0; i < svg.size(); ++i) {
    text += svg[i];
    if (svg[i] == '>' && i + 1 < svg.size() && svg[i + 1] == '<') text += '\n';
  }
  return text;
}

void expect_golden(const std::string& name, const std::string& svg) {
  const std::string text = by_line(svg);
  if (std::getenv("SKEIN_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(path_of(name), std::ios::binary) << text;
  }
  std::ostringstream golden;
  golden << std::ifstream(path_of(name), std::ios::binary).rdbuf();
  EXPECT_EQ(text, golden.str());
}

// Two UAVs, two tasks, one rendezvous, one alarm, one cut: a little of everything.
Journal small_journal() {
  Journal j;
  for (int t = 0; t <= 60; t += 10) {
    const bool airborne = t >= 10 && t <= 50;
    j.telemetry.push_back(telemetry(t, "a", {10.0 * t, 0, airborne ? 30.0 : 0.0}, airborne));
    j.telemetry.push_back(telemetry(t, "b", {0, 10.0 * t, airborne ? 50.0 : 0.0}, airborne));
  }
  j.tasks = {
      task(5, "a", 1, TaskState::kScheduled), task(10, "a", 1, TaskState::kStarted),
      task(12, "a", 1, TaskState::kRunning),  task(50, "a", 1, TaskState::kEnded),
      task(5, "b", 1, TaskState::kScheduled), task(20, "b", 1, TaskState::kRunning),
      task(30, "b", 1, TaskState::kAborting), task(33, "b", 1, TaskState::kAborted, "alarm")};
  j.syncs = {{stamp(25, "a"), "551", "a", "b", Direction::kSent},
             {stamp(25.5, "b"), "551", "a", "b", Direction::kReceived}};
  j.messages = {message(30, "ground", "b", 1, Direction::kSent),
                message(30.1, "ground", "b", 1, Direction::kReceived)};
  j.alarms = {{stamp(29), 1, AlarmState::kRaised, {200, 210, 0}, 0.5}};
  j.objects = {{stamp(0), "fire", "fire", {203, 214, 0}, 6, true}};
  j.phases = {{stamp(0), "Detection"}, {stamp(29), "Confirmation"}};
  j.links = {{stamp(0), "a", "b", true}, {stamp(40), "a", "b", false}};
  j.missions = {{stamp(60), "finished"}};
  sort_by_time(j);
  return j;
}

RunInfo small_info() {
  RunInfo info;
  info.scenario = "small";
  info.uavs = {{"a", "heli", 3}, {"b", "blimp", 4}};
  info.zones = {{"Z", {{100, 100}, {300, 100}, {300, 300}}}};
  info.places = {{"base", {0, 0, 0}}};
  return info;
}

class Golden : public ::testing::Test {
 protected:
  const RunInfo info_ = small_info();
  const Journal journal_ = small_journal();
  const Chronology story_ = tell(info_, journal_);
  const Statistics figures_ = measure(story_, journal_);
  const Deliberation plans_ = tell_deliberation(journal_);
  const report::Run run_{info_, journal_, story_, figures_, plans_};
  Markup out_;
};

TEST_F(Golden, Timeline) {
  write_timeline(out_, run_);

  expect_golden("timeline.svg", out_.take());
}

TEST_F(Golden, Map) {
  write_map(out_, run_, frame_map(info_, story_));

  expect_golden("map.svg", out_.take());
}

TEST_F(Golden, Header) {
  write_header(out_, run_);
  write_expectations(out_, run_);

  expect_golden("header.html", out_.take());
}

}  // namespace
}  // namespace skein::report
