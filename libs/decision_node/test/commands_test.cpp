// SPDX-License-Identifier: Apache-2.0
// Commands are executed once: any order, any repetition, against a list of all that was ever said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "skein/foundation/random.hpp"
#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using testing::FlownNode;

/// What a node should do with changes of degree: all answers are remembered, by key.
class AllAnswers {
 public:
  static constexpr std::size_t kKept = 256;

  void expect(const Command& command, const Effects& effects) {
    const auto answers = testing::all<Answer>(effects);
    const auto changes = testing::all<DegreeChanged>(effects);
    if (const auto known = all_.find(command.key); known != all_.end() || is_old(command.key)) {
      RC_ASSERT(changes.empty());
      const bool kept = known != all_.end() && is_kept(command.key);
      RC_ASSERT(effects.size() == (kept ? 1U : 0U));
      if (kept) RC_ASSERT(answers.at(0).accepted == known->second);
      return;
    }
    const int wanted = std::get<mission::ChangeDegree>(command.request).degree;
    const bool possible = wanted <= 3;  // no planning domain
    RC_ASSERT(answers.size() == 1U);
    RC_ASSERT(answers[0].key == command.key);
    RC_ASSERT(answers[0].accepted == possible);
    RC_ASSERT(answers[0].why.empty() == possible);
    RC_ASSERT(changes.size() == (possible ? 1U : 0U));
    if (possible) RC_ASSERT(changes[0].degree == wanted);
    all_.emplace(command.key, possible);
  }

 private:
  // Those that were executed and are among the greatest keys.
  bool is_kept(const CommandKey& key) const {
    return static_cast<std::size_t>(std::distance(all_.lower_bound(key), all_.end())) <= kKept;
  }
  // Not after the greatest of what is kept no more.
  bool is_old(const CommandKey& key) const {
    if (all_.size() <= kKept) return false;
    auto dropped = all_.end();
    std::advance(dropped, -static_cast<std::ptrdiff_t>(kKept) - 1);
    return key <= dropped->first;
  }
  std::map<CommandKey, bool> all_;
};

RC_GTEST_PROP(Commands, AreExecutedOnceAndAnsweredTheSameWhileTheirAnswerIsKept, ()) {
  FlownNode node(3);
  AllAnswers model;
  std::vector<Command> given;
  CommandKey next{1, 1};
  const int steps = *rc::gen::inRange(1, 700);
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  for (int i = 0; i < steps; ++i) {
    if (given.empty() || !random.chance(0.25)) {
      if (random.chance(0.01)) next = {next.incarnation + 1, 0};
      next.number += 1 + random.below(3);
      given.push_back({next, mission::ChangeDegree{1 + static_cast<int>(random.below(4)), false}});
      if (random.chance(0.05)) given.back().key.number -= 1;  // on a way of its own, overtaken
    }
    const std::size_t which = random.chance(0.75) ? given.size() - 1 : random.below(given.size());
    const Command& command = given[which];
    model.expect(command, node.give(command));
  }
}

TEST(Commands, OneThatCouldNotBeReadIsAnsweredTheSameWhenItComesAgain) {
  FlownNode node(3);
  const UnreadableCommand unreadable{{1, 1}, mission::RequestKind::kStart, 4, "no type"};

  const Effects first = node.give(unreadable);
  const Effects again = node.give(unreadable);

  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(std::get<Answer>(again[0]).why, "no type");
  EXPECT_EQ(testing::all<Answer>(first).size(), 1U);
}

TEST(Commands, OneThatWasRefusedIsNotExecutedWhenItWouldBePossible) {
  FlownNode node(1);
  const Command start{{1, 1}, testing::start_of(1, "goto")};
  node.give(start);
  node.give(Command{{1, 2}, mission::ChangeDegree{3}});

  const Effects again = node.give(start);

  ASSERT_EQ(again.size(), 1U);
  EXPECT_FALSE(std::get<Answer>(again[0]).accepted);
}

TEST(Commands, IdsOfTheNodesOwnAreRefusedToTheGround) {
  FlownNode node(3);

  EXPECT_TRUE(node.answer_to(testing::start_of(499'999'999, "goto")).accepted);
  const Answer answer = node.answer_to(testing::start_of(500'000'000, "goto"));
  EXPECT_FALSE(answer.accepted);
  EXPECT_EQ(answer.why, "ids from 500000000 are the decision node's own");
}

}  // namespace
}  // namespace skein::decision_node
