// SPDX-License-Identifier: Apache-2.0
// What the report tells of random event logs, against a second reading of the same lines that knows
// nothing of it: the state of everything at sampled instants.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "builders.hpp"
#include "skein/foundation/random.hpp"
#include "story/air_story.hpp"
#include "story/encounters.hpp"
#include "story/joint_story.hpp"
#include "story/links.hpp"
#include "test_cases.hpp"

namespace skein::report {
namespace {

using Json = nlohmann::json;
using testing::salvage;

constexpr double kStep = 0.5;  // [s] between lines: what is sampled lies in between
constexpr int kSteps = 120;

/// Lines of a log, one at each of some instants.
class RandomLog {
 public:
  explicit RandomLog(std::uint64_t seed) : random_(seed) {}

  Random& random() { return random_; }
  std::string uav() { return "uav" + std::to_string(1 + random_.below(3)); }
  std::string other_than(const std::string& uav) {
    std::string other = uav;
    while (other == uav) other = this->uav();
    return other;
  }
  void add(int step, const std::string& node, const std::string& kind, Json rest) {
    Json line{{"at", step * kStep}, {"node", node}, {"kind", kind}};
    line.update(rest);
    lines_.push_back(line);
  }
  /// So that a UAV is known, and the log goes on so long.
  void see(int step, const std::string& uav) {
    add(step, "sim", "telemetry",
        {{"uav", uav},
         {"position", {0, 0, 0}},
         {"velocity", {0, 0, 0}},
         {"heading", 0},
         {"energy", 1},
         {"airborne", true}});
  }
  const std::vector<Json>& lines() const { return lines_; }
  std::string text() const {
    std::string all;
    for (const Json& line : lines_) all += line.dump() + "\n";
    return all;
  }

 private:
  Random random_;
  std::vector<Json> lines_;
};

struct Read {
  explicit Read(const RandomLog& log) : journal(salvage(log.text()).journal) {
    sort_by_time(journal);
    story = tell({}, journal);
  }
  std::string name(std::size_t uav) const { return story.uavs.at(uav).name; }

  Journal journal;
  Chronology story;
};

/// Between two lines.
std::vector<double> instants() {
  std::vector<double> all;
  for (int step = 0; step < kSteps; ++step) all.push_back((step + 0.5) * kStep);
  return all;
}

const char* word_of(TaskState state) {
  constexpr const char* kWords[] = {"scheduled", "started", "running",
                                    "aborting",  "ended",   "aborted"};
  return kWords[static_cast<std::size_t>(state)];
}

bool holds(const Span& span, double t) { return span.from <= t && t < span.to; }

class Recount : public ::testing::TestWithParam<int> {
 protected:
  std::uint64_t seed() const { return static_cast<std::uint64_t>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Seeds, Recount, ::testing::Range(1, skein::testing::cases(25, 500)));

// ---- tasks ----

/// Tasks in random states, also repeated ones and ends that two nodes write.
RandomLog log_of_tasks(std::uint64_t seed) {
  RandomLog log(seed);
  const std::vector<std::string> next[] = {{"started", "aborted", "scheduled"},
                                           {"running", "aborting", "aborted", "started"},
                                           {"ended", "aborting", "aborted", "running"},
                                           {"aborted", "ended"}};
  const std::map<std::string, int> stage{
      {"scheduled", 0}, {"started", 1}, {"running", 2}, {"aborting", 3}};
  std::map<std::string, std::map<int, std::string>> states;
  for (int step = 0; step < kSteps; ++step) {
    const std::string uav = log.uav();
    const int task = 1 + static_cast<int>(log.random().below(6));
    std::string& state = states[uav][task];
    if (state == "ended" || state == "aborted") {
      if (log.random().chance(0.5))
        log.add(step, "ground", "task",
                {{"uav", uav}, {"task", task}, {"type", "goto"}, {"state", state}});
      continue;
    }
    if (state.empty()) {
      state = "scheduled";
    } else {
      const auto& choices = next[stage.at(state)];
      state = choices[log.random().below(choices.size())];
    }
    log.add(step, uav, "task", {{"uav", uav}, {"task", task}, {"type", "goto"}, {"state", state}});
  }
  return log;
}

TEST_P(Recount, ATaskIsDrawnInTheStateThatWasLastLogged) {
  const RandomLog log = log_of_tasks(seed());
  const Read read(log);

  for (const double t : instants()) {
    std::map<std::pair<std::string, std::uint64_t>, std::string> logged, drawn;
    for (const Json& line : log.lines()) {
      if (line["at"] > t) continue;
      const std::pair key{line["uav"].get<std::string>(), line["task"].get<std::uint64_t>()};
      logged[key] = line["state"];
    }
    std::erase_if(logged,
                  [](const auto& one) { return one.second == "ended" || one.second == "aborted"; });
    for (const TaskBar& bar : read.story.tasks) {
      for (const TaskSegment& segment : bar.segments)
        if (holds(segment.span, t) && t < read.story.time.to)
          drawn[{read.name(bar.uav), bar.id}] = word_of(segment.state);
    }
    if (t < read.story.time.to) {
      EXPECT_EQ(drawn, logged) << t;
    }
  }
}

TEST_P(Recount, EachTaskIsOneBarWithTheOutcomeOfItsFirstEnd) {
  const RandomLog log = log_of_tasks(seed());
  const Read read(log);

  std::map<std::pair<std::string, std::uint64_t>, std::string> logged, drawn;
  for (const Json& line : log.lines()) {
    const std::string state = line["state"];
    const bool over = state == "ended" || state == "aborted";
    std::string& outcome = logged[{line["uav"], line["task"]}];
    if (over && outcome.empty()) outcome = state;
  }
  for (const TaskBar& bar : read.story.tasks)
    EXPECT_TRUE(drawn
                    .emplace(std::pair{read.name(bar.uav), bar.id},
                             bar.outcome ? word_of(*bar.outcome) : "")
                    .second);
  EXPECT_EQ(drawn, logged);
}

// ---- synchronisations ----

TEST_P(Recount, TwoMeetOnceForEachSynchronisationBothWaysOfWhichWereHeard) {
  RandomLog log(seed());
  for (int step = 0; step < kSteps; ++step) {
    const std::string from = log.uav(), to = log.other_than(from);
    const auto id = 500 + log.random().below(3);
    const bool sent = log.random().chance(0.5);
    log.add(step, sent ? from : to, "sync",
            {{"id", id}, {"from", from}, {"to", to}, {"direction", sent ? "sent" : "received"}});
    // UAVs are known by what they fly.
    log.see(step, log.uav());
  }
  const Read read(log);

  std::set<std::pair<std::string, std::set<std::string>>> heard, met;
  for (const Json& line : log.lines())
    if (line["kind"] == "sync" && line["direction"] == "received")
      heard.insert({std::to_string(line["id"].get<int>()), {line["from"], line["to"]}});
  double last = 0;
  for (const Encounter& one : encounters_of(read.story)) {
    EXPECT_TRUE(met.insert({one.id, {read.name(one.one), read.name(one.other)}}).second);
    EXPECT_GE(one.t(), last);
    last = one.t();
  }
  EXPECT_EQ(met, heard);
}

// ---- air ----

TEST_P(Recount, AUavHasOrWaitsForTheAirThatWasLastLogged) {
  RandomLog log(seed());
  for (int step = 0; step < kSteps; ++step) {
    const char* states[] = {"waits", "had", "unasked", "aside", "given-up"};
    const std::string uav = log.uav();
    log.add(step, uav, "air",
            {{"uav", uav},
             {"task", 7},
             {"type", "goto"},
             {"state", states[log.random().below(5)]},
             {"waited", 0}});
    log.see(step, log.uav());
  }
  const Read read(log);
  const std::vector<AirUse> uses = tell_air(read.journal, read.story);

  for (const double t : instants()) {
    if (t >= read.story.time.to) continue;
    std::map<std::string, std::string> logged, told;
    for (const Json& line : log.lines())
      if (line["kind"] == "air" && line["at"] <= t) logged[line["uav"]] = line["state"];
    std::erase_if(logged, [](const auto& one) { return one.second == "given-up"; });
    for (const AirUse& use : uses)
      if (holds(use.span, t)) {
        EXPECT_TRUE(told.emplace(read.name(use.uav), use.state).second) << t;
      }
    EXPECT_EQ(told, logged) << t;
  }
}

// ---- constraints ----

/// Constraints that are violated and kept, and joint tasks that end meanwhile.
RandomLog log_of_constraints(std::uint64_t seed) {
  RandomLog log(seed);
  const std::string joint = "watch(P1) of uav1, uav2, uav3";
  for (int step = 0; step < kSteps; ++step) {
    const std::string uav = log.uav(), scm = "mcs" + std::to_string(1 + log.random().below(2));
    if (log.random().chance(0.1)) {
      for (const char* phase : {"running", "ended"})
        log.add(step, uav, "joint",
                {{"uav", uav},
                 {"joint", joint},
                 {"task", 2},
                 {"model", "watch"},
                 {"variant", "v"},
                 {"phase", phase}});
    } else {
      const bool violated = log.random().chance(0.6);
      log.add(step, uav, "scm",
              {{"uav", uav},
               {"joint", joint},
               {"role", "r"},
               {"scm", scm},
               {"state", violated ? "violated" : "satisfied"},
               {"place", "P1"},
               {"relation", "<"},
               {"measured", 60},
               {"required", 50}});
    }
  }
  log.see(kSteps + 1, "uav1");
  return log;
}

TEST_P(Recount, AConstraintIsViolatedFromWhenItIsSaidUntilItIsKeptOrItsJointTaskIsOver) {
  const RandomLog log = log_of_constraints(seed());
  const Read read(log);
  const JointTasks told = tell_joint_tasks(read.journal, read.story);

  for (const double t : instants()) {
    std::set<std::pair<std::string, std::string>> logged, drawn;
    for (const Json& line : log.lines()) {
      if (line["at"] > t) continue;
      const std::string uav = line["uav"];
      if (line["kind"] == "joint")
        std::erase_if(logged, [&](const auto& one) { return one.first == uav; });
      if (line["kind"] != "scm") continue;
      logged.erase({uav, line["scm"]});
      if (line["state"] == "violated") logged.insert({uav, line["scm"]});
    }
    for (const ViolationStory& one : told.violations)
      if (holds(one.span, t)) {
        EXPECT_TRUE(drawn.insert({one.uav, one.scm}).second) << t;
      }
    EXPECT_EQ(drawn, logged) << t;
  }
}

// ---- temporal messages ----

TEST_P(Recount, EachWordOnAPlanThatWasHeardIsInOneMessageOfItsSender) {
  RandomLog log(seed());
  for (int step = 0; step < kSteps; ++step) {
    const std::string by = log.uav(), from = log.other_than(by);
    log.add(step, by, "frontier",
            {{"uav", by}, {"direction", "received"}, {"from", from}, {"meetings", 1}, {"arcs", 2}});
    log.see(step, log.uav());
  }
  const Read read(log);

  std::map<std::pair<std::string, std::string>, int> logged, told;
  for (const Json& line : log.lines())
    if (line["kind"] == "frontier") ++logged[{line["from"], line["uav"]}];
  double last = 0;
  for (const TemporalMessage& one : temporal_messages_of(read.journal, read.story)) {
    EXPECT_GE(one.t, last);
    last = one.t;
    const std::set<std::size_t> once(one.heard_by.begin(), one.heard_by.end());
    EXPECT_EQ(once.size(), one.heard_by.size());
    for (const std::size_t by : one.heard_by) ++told[{read.name(one.sender), read.name(by)}];
  }
  EXPECT_EQ(told, logged);
}

// ---- links ----

using Way = std::pair<std::string, std::string>;

/// Of a line on a link, or on what a node believes of one.
Way way_of(const Json& line) {
  const bool link = line["kind"] == "link";
  return {line[link ? "from" : "node"].get<std::string>(),
          line[link ? "to" : "peer"].get<std::string>()};
}

TEST_P(Recount, ALinkIsUpAndBelievedAsItWasLastLogged) {
  RandomLog log(seed());
  for (int step = 0; step < kSteps; ++step) {
    const std::string from = log.uav(), to = log.other_than(from);
    const bool on = log.random().chance(0.5);
    if (log.random().chance(0.5))
      log.add(step, "sim", "link", {{"from", from}, {"to", to}, {"up", on}});
    else
      log.add(step, from, "reach", {{"peer", to}, {"reachable", on}});
  }
  const Read read(log);

  for (const double t : instants()) {
    if (t >= read.story.time.to) continue;
    std::set<Way> up, believed, drawn_up, drawn_believed, known;
    for (const Json& line : log.lines()) {
      const Way way = way_of(line);
      if (line["kind"] == "link") known.insert({way, {way.second, way.first}});
    }
    for (const Json& line : log.lines()) {
      if (line["at"] > t) continue;
      const bool link = line["kind"] == "link";
      const Way way = way_of(line);
      auto& holding = link ? up : believed;
      const bool on = line[link ? "up" : "reachable"];
      // Of a pair without radio nothing is told.
      on&& known.count(way) > 0 ? (void)holding.insert(way) : (void)holding.erase(way);
    }
    for (const LinkStory& pair : read.story.links) {
      const Way ways[] = {{pair.first, pair.second}, {pair.second, pair.first}};
      for (int i = 0; i < 2; ++i) {
        for (const Span& span : pair.up[i])
          if (holds(span, t)) drawn_up.insert(ways[i]);
        for (const Span& span : pair.believed[i])
          if (holds(span, t)) drawn_believed.insert(ways[i]);
      }
    }
    EXPECT_EQ(drawn_up, up) << t;
    EXPECT_EQ(drawn_believed, believed) << t;
  }
}

}  // namespace
}  // namespace skein::report
