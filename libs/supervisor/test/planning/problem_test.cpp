// SPDX-License-Identifier: Apache-2.0
// The planner is given the problem that a reader makes of the same situation in the planner's
// language.
#include "planning/problem.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "skein/foundation/random.hpp"
#include "test_cases.hpp"
#include "testing/planning_lab.hpp"
#include "testing/problem_text.hpp"

namespace skein::supervisor {
namespace {

using namespace std::string_literals;
using testing::PlanningLab;
using world::Vector3;

std::string shown(const htn::Problem& problem, const htn::TermStore& store) {
  std::string text;
  for (const htn::Term fact : problem.facts) text += store.to_text(fact) + "\n";
  for (const htn::TaskNetwork& task : problem.tasks.children)
    text += store.to_text(task.task) + "\n";
  return text;
}

/// Requests that say anything a situation may say.
class AnyRequest {
 public:
  AnyRequest(std::uint64_t seed, PlanningRequest base)
      : random_(seed, "request"), base_(std::move(base)) {}

  PlanningRequest draw() {
    PlanningRequest request = base_;
    if (random_.chance(0.1)) {
      Knowledge driving = *base_.knowledge;
      driving.vehicle.ground.emplace();
      request.knowledge = std::make_shared<Knowledge>(driving);
    }
    Situation& now = request.situation;
    now.origin = MissionTime::seconds(number());
    now.position = place();
    now.airborne = random_.chance(0.5);
    if (random_.chance(0.3)) now.land_at = place();
    now.motion = line();
    for (int i = 0; i < 2 && random_.chance(0.5); ++i) now.riders.push_back(line());
    for (const world::SensorModel& sensor : request.knowledge->vehicle.sensors) {
      if (random_.chance(0.5)) now.devices[sensor.device] = line();
      if (random_.chance(0.2)) now.broken.insert(sensor.device);
    }
    now.next_id = executive::TaskId(id());
    for (int i = 0; i < 3; ++i) request.tasks.push_back(task());
    for (const mission::HighLevelTask& task : request.tasks)
      if (random_.chance(0.5)) now.done[task.id] = progress();
    return request;
  }

 private:
  double number() {
    switch (random_.below(6)) {
      case 0:
        return static_cast<double>(random_.below(1000));
      case 1:
        return -static_cast<double>(random_.below(1000));
      case 2:
        return random_.chance(0.5) ? 0.0 : -0.0;
      case 3:
        return random_.uniform(-1e-6, 1e-6);
      case 4:
        return random_.uniform(-1e17, 1e17);
      default:
        return random_.uniform(-1000, 1000);
    }
  }
  std::uint64_t id() { return random_.below(100'000); }
  Vector3 place() { return {number(), number(), number()}; }
  Duration duration() {
    return random_.chance(0.1) ? Duration::max() : Duration::seconds(random_.uniform(0, 5000));
  }
  std::string name() {
    static const std::vector<std::string> names = {
        "P1",    "lousa-fire", "visible", "z_2", "20",     "two words", "bar|and\\back",
        "Señal", "nil",        "-5",      "a.b", "(list)", "k:v",       "'quoted",
        "1/2",   "#x",         ";"};
    return names[random_.below(names.size())];
  }
  mission::Argument argument() {
    switch (random_.below(4)) {
      case 0:
        return name();
      case 1:
        return number();
      case 2:
        return place();
      default: {
        std::vector<std::string> names;
        for (std::uint64_t i = random_.below(3); i > 0; --i) names.push_back(name());
        return names;
      }
    }
  }
  mission::HighLevelTask task() {
    mission::HighLevelTask task{mission::GoalId(id()), "general-gotoxyz", {}, {}};
    if (random_.chance(0.5)) task.name = "perform-detection";
    for (std::uint64_t i = random_.below(4); i > 0; --i) task.arguments.push_back(argument());
    for (auto* bound : {&task.time.start_before, &task.time.start_after, &task.time.end_before,
                        &task.time.end_after})
      if (random_.chance(0.3)) *bound = MissionTime::seconds(random_.uniform(0, 5000));
    return task;
  }
  Timeline line() {
    Timeline line;
    line.free = {duration(), duration()};
    if (!random_.chance(0.6)) return line;
    constexpr std::array kKinds = {mission::DependenceKind::kEnded, mission::DependenceKind::kOver,
                                   mission::DependenceKind::kRunning};
    line.after = {kKinds[random_.below(kKinds.size())], executive::TaskId(id())};
    return line;
  }
  mission::Progress progress() {
    mission::Progress done;
    for (std::uint64_t i = random_.below(3); i > 0; --i) done.reached.push_back(place());
    for (std::uint64_t i = random_.below(3); i > 0; --i)
      done.looks.push_back({name(), place(), duration()});
    if (random_.chance(0.4)) done.waited = duration();
    for (std::uint64_t i = random_.below(3); i > 0; --i) done.synchronised.insert(id());
    if (random_.chance(0.4)) done.rest = {name(), {place(), place()}};
    return done;
  }

  Random random_;
  PlanningRequest base_;
};

TEST(PlanningProblem, IsWhatAReaderMakesOfItsText) {
  const auto cases = ::skein::testing::cases<std::uint64_t>(200, 20'000);
  const PlanningRequest base = PlanningLab().request();
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const PlanningRequest request = AnyRequest(seed, base).draw();
    htn::TermStore store;
    const std::string text = testing::problem_text(request, "request");
    Diagnostics errors;
    const auto read = testing::read_problem(text, store, errors);
    ASSERT_TRUE(read) << to_text(errors) << text;

    const htn::Problem made = problem_of(request, store);

    ASSERT_EQ(made.name, read->name);
    ASSERT_EQ(made.facts, read->facts) << "seed " << seed << "\n" << text << shown(made, store);
    ASSERT_EQ(made.tasks, read->tasks) << "seed " << seed << "\n" << text << shown(made, store);
    ASSERT_TRUE(made.past.empty());
  }
}

TEST(PlanningProblem, TakesNumbersThatNoTextCanSay) {
  PlanningLab lab;
  lab.task(1, "general-gotoxyz", {std::numeric_limits<double>::infinity()});
  htn::TermStore store;

  const htn::Problem made = problem_of(lab.request(), store);

  const htn::Term said = store.items(made.tasks.children.at(0).task).at(1);
  ASSERT_TRUE(said.is(htn::TermKind::kNumber));
  EXPECT_EQ(to_double(store.value(said)), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace skein::supervisor
