// SPDX-License-Identifier: Apache-2.0
// The plans of the seeds: golden/NAME.txt, in their form. To write them anew:
// SKEIN_UPDATE_GOLDEN=1 skein_supervisor_planning_test --gtest_filter='*Golden*', and read what
// changed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "planning/domain_book.hpp"
#include "skein/htn/planner.hpp"
#include "skein/supervisor/plan_reader.hpp"
#include "skein/supervisor/planner_host.hpp"
#include "testing/planning_lab.hpp"
#include "testing/problem_text.hpp"

namespace skein::supervisor {
namespace {

using testing::PlanningLab;
using world::Vector3;
using namespace std::string_literals;
using Names = std::vector<std::string>;

void expect_golden(const std::string& name, const std::string& found) {
  const std::string path = "libs/supervisor/test/planning/golden/" + name + ".txt";
  if (std::getenv("SKEIN_UPDATE_GOLDEN") != nullptr)
    std::ofstream(std::string(SKEIN_SOURCE_DIR) + "/" + path) << found;
  EXPECT_EQ(found, testing::file_text(path));
}

/// A problem file of scenarios/domains, planned as `skein plan` does.
std::string planned_file(const std::string& name, const PlanningLab& lab) {
  const PlanningRequest request = lab.request();
  const PlannerHost host(request.knowledge, request.world, {}, 1);
  htn::Functions functions;
  host.offer(functions);
  DomainBook book(request.knowledge->domain, functions);
  Diagnostics errors;
  const auto problem =
      testing::read_problem(testing::file_text("scenarios/domains/" + name), book.store(), errors);
  if (!problem) return to_text(errors);
  const htn::Outcome outcome = htn::plan(*book.compiled(), *problem, {});
  if (outcome.plans.empty()) return "no plan";
  return mission::to_taskreq(
      read_plan(book.store(), outcome.plans.front(), *request.knowledge, {}).value());
}

PlanningLab karma() {
  PlanningLab lab;
  lab.first_id(100)
      .task(700, "general-takeoff")
      .task(701, "general-combined-goto-and-takeshot", {"P1"s, 20.0})
      .task(702, "perform-detection", {"Z2"s, "P2"s, 300.0})
      .task(703, "general-land");
  return lab;
}

/// In the seeds 20 is Marvin and 21 Heliv.
PlanningLab heliv() {
  const Names both = {"20"s, "21"s};
  PlanningLab lab;
  lab.uav("21", both)
      .first_id(20)
      .task(800, "general-takeoff")
      .task(801, "general-combined-goto-and-takeshot", {"lousa-fire"s, 30.0})
      .task(802, "general-combined-goto-and-synchro-and-takeshot",
            {551.0, both, both, "lousa-fire"s, 120.0})
      .task(803, "general-land");
  return lab;
}

PlanningLab marvin() {
  const Names both = {"20"s, "21"s};
  PlanningLab lab;
  lab.uav("20", both)
      .first_id(40)
      .flying_at({30, -30, 40})
      .task(900, "general-combined-goto-and-synchro-and-takeshot",
            {551.0, both, both, "lousa-fire"s, 120.0})
      .task(901, "general-land");
  return lab;
}

TEST(PlanningGolden, KarmaOfFigureVI9) { expect_golden("karma", karma().taskreq()); }
TEST(PlanningGolden, HelivOfFigureVI12) { expect_golden("heliv", heliv().taskreq()); }
TEST(PlanningGolden, MarvinOfFigureVI13) { expect_golden("marvin", marvin().taskreq()); }

TEST(PlanningGolden, ProblemFilesGiveTheSamePlans) {
  expect_golden("karma", planned_file("karma.lisp", karma()));
  expect_golden("heliv", planned_file("heliv.lisp", heliv()));
  expect_golden("marvin", planned_file("marvin.lisp", marvin()));
}

/// The three vehicles of IROS 2005 over flat ground with wind: A, L1 and L2.
PlanningLab iros(const std::string& uav, const std::string& model) {
  PlanningLab lab;
  lab.uav(uav, {"m"s, "h"s, "k"s})
      .vehicle(testing::vehicle_of("scenarios/comets/models/" + model + ".yaml"));
  lab.world.wind = {0.6, 2, 0.5};
  lab.world.zones.push_back({"A"s, lab.world.zones.front().polygon});
  lab.world.places["L1"] = Vector3(200, -100, 0);
  lab.world.places["L2"] = Vector3(-150, 150, 0);
  lab.world.places["base"] = Vector3::Zero();
  return lab;
}

TEST(PlanningGolden, BlimpOfIros) {
  PlanningLab k = iros("k", "karma");
  k.flying_at({0, 0, 40})
      .first_id(11)
      .task(1, "perform-detection", {"A"s, "P2"s, 900.0})
      .task(2, "send-signal", {1.0, Names{"h"s, "m"s}})
      .task(3, "general-gotoxyz", {"base"s});

  expect_golden("iros-k", k.taskreq());
}

TEST(PlanningGolden, HelicoptersOfIrosConfirm) {
  PlanningLab h1 = iros("h", "heliv"), m1 = iros("m", "marvin");
  h1.flying_at({0, 0, 40}).first_id(21);
  h1.task(1, "perceive", {"L1"s, 60.0}).task(2, "wait-for-orders");
  m1.flying_at({0, 0, 40}).first_id(31);
  m1.task(1, "perceive", {"L2"s, 60.0}).task(2, "wait-for-orders");

  expect_golden("iros-h1", h1.taskreq());
  expect_golden("iros-m1", m1.taskreq());
}

/// Where a plan leaves the vehicle, and the wait for orders to be taken over.
PlanningLab& goes_on(PlanningLab& lab, const mission::ElementaryPlan& before) {
  for (const mission::ElementaryTask& task : before.tasks)
    if (!task.way.empty()) lab.flying_at(task.way.back());
  const executive::TaskId last = before.tasks.back().id;
  lab.situation.motion.after = {mission::DependenceKind::kOver, last};
  lab.tasks.clear();
  return lab.first_id(last.value() + 1);
}

TEST(PlanningGolden, HelicoptersOfIrosMonitorTogether) {
  PlanningLab h = iros("h", "heliv"), m = iros("m", "marvin");
  h.flying_at({0, 0, 40})
      .first_id(21)
      .task(1, "perceive", {"L1"s, 60.0})
      .task(2, "wait-for-orders");
  m.flying_at({0, 0, 40})
      .first_id(31)
      .task(1, "perceive", {"L2"s, 60.0})
      .task(2, "wait-for-orders");
  const auto h1 = h.plan(), m1 = m.plan();
  ASSERT_TRUE(h1 && m1);

  goes_on(h, *h1).task(3, "monitor-until", {"L2", 2.0, Names{"m"s}, 1.0, "k"s});
  h.task(4, "general-gotoxyz", {"base"s});
  goes_on(m, *m1).task(3, "monitor-until", {"L2", 2.0, Names{"h"s}, 1.0, "k"s});
  m.task(4, "general-gotoxyz", {"base"s});

  expect_golden("iros-h2", h.taskreq());
  expect_golden("iros-m2", m.taskreq());
}

}  // namespace
}  // namespace skein::supervisor
