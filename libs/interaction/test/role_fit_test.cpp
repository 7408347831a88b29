// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/role_fit.hpp"

#include <gtest/gtest.h>

#include "skein/config/parse.hpp"
#include "skein/foundation/random.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "testing/random_automaton.hpp"
#include "testing/small_library.hpp"

namespace skein::interaction {
namespace {

std::vector<std::string> path_of(const std::string& yaml) {
  const auto automaton = read_automaton(yaml, "a.yaml");
  EXPECT_TRUE(automaton) << to_text(automaton.error());
  std::vector<std::string> all;
  if (!automaton) return all;
  for (const NominalStep& step : nominal_path(*automaton)) {
    std::string text = step.task;
    for (const std::string& one : step.computed) text += " " + one;
    all.push_back(text);
  }
  return all;
}
using Path = std::vector<std::string>;

TEST(NominalPath, GoesThroughTheTasksInOrderWithWhatIsComputed) {
  const Path path = path_of(R"yaml(
block: b1
local: {p: "best-view()"}
content:
  - {task: t1, type: goto}
  - {block: b2, pre: [[{componel: t1, state: ended}]], local: {q: "x()"}, content: [{task: t2, type: look}]}
)yaml");

  EXPECT_EQ(path, (Path{"t1 p", "t2 q"}));
}

TEST(NominalPath, LeavesContingenciesOut) {
  const Path path = path_of(R"yaml(
block: b1
content:
  - {task: t1, type: goto}
  - {block: b2, pre: [[{message: mcs2 violated}]], content: [{action: a1, modality: role-allocation}]}
)yaml");

  EXPECT_EQ(path, (Path{"t1"}));
}

TEST(NominalPath, GoesOnceRoundALoop) {
  const Path path = path_of(R"yaml(
block: b1
type: loop
exit: [[{message: stop}]]
content: [{task: t1, type: goto}]
)yaml");

  EXPECT_EQ(path, (Path{"t1"}));
}

TEST(NominalPath, WaitsForInstants) {
  const Path path = path_of(R"yaml(
block: b1
content:
  - {block: b2, pre: [[{time: 60, since: start, is: passed}]], content: [{task: t1, type: goto}]}
)yaml");

  EXPECT_EQ(path, (Path{"t1"}));
}

TEST(NominalPath, OfAnyAutomatonEndsAndHasNoTaskTwice) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Automaton automaton = testing::RandomAutomaton(seed).make();
    std::set<std::string> seen;
    for (const NominalStep& step : nominal_path(automaton)) {
      EXPECT_TRUE(seen.insert(step.task).second) << seed;
      ASSERT_TRUE(automaton.find(step.task)) << seed;
      EXPECT_NE(automaton[*automaton.find(step.task)].task(), nullptr) << seed;
    }
  }
}

TEST(VariantFor, IsTheFirstThatSoManyCanPlay) {
  const auto library = testing::library_of(testing::small_library());
  const Model& model = library->models.at("looking");

  EXPECT_EQ(variant_for(model, 1), nullptr) << "looker and helper are two";
  for (std::size_t members = 2; members <= 4; ++members) {
    ASSERT_NE(variant_for(model, members), nullptr);
    EXPECT_EQ(variant_for(model, members)->name, "pair");
  }
  EXPECT_EQ(variant_for(model, 5), nullptr) << "three helpers at most";
}

TEST(VariantFor, WithoutAnUpperBoundAnyNumberWillDo) {
  const auto library =
      testing::library_of(testing::small_library("{between: [1, 3]}", "{at-least: 2}"));

  EXPECT_EQ(variant_for(library->models.at("looking"), 2), nullptr);
  EXPECT_NE(variant_for(library->models.at("looking"), 30), nullptr);
}

}  // namespace
}  // namespace skein::interaction
