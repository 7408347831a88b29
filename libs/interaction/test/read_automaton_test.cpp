// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/read_automaton.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <iterator>

#include "skein/foundation/random.hpp"

namespace skein::interaction {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string errors_of(const std::string& text) {
  const auto read = read_automaton(text, "a.yaml");
  return read ? "" : to_text(read.error());
}

TEST(ReadAutomaton, JsonAndYamlAreTheSame) {
  const auto json = read_automaton(
      R"json({"block":"b","type":"loop","end":"immediate","scms":["m"],"local":{"z":"f()","a":"g()"},
          "exit":[[{"time":1.5,"since":"t:running","is":"passed","effect":"continue"}]],
          "content":[{"task":"t","type":"goto","params":{"to":[1,2,{"x":null}]}}]
})json",
      "a.json");
  const auto yaml = read_automaton(R"(
block: b
type: loop
end: immediate
scms: [m]
local: {z: f(), a: g()}
exit: [[{time: 1.5, since: "t:running", is: passed, effect: continue}]]
content: [{task: t, type: goto, params: {to: [1, 2, {x: null}]}}]
)",
                                   "a.yaml");

  ASSERT_TRUE(json && yaml);
  const Block& block = *(*json)[0].block();
  EXPECT_EQ(block.exit, (*yaml)[0].block()->exit);
  EXPECT_EQ(block.type, BlockType::kLoop);
  EXPECT_EQ(block.end, EndMode::kImmediate);
  EXPECT_EQ(block.locals[0].name, "z") << "in the order written";
  EXPECT_EQ((*json)[1].id, "t");
}

TEST(ReadAutomaton, DefaultsArePlanAndWait) {
  const auto read = read_automaton("{block: b, content: [{task: t, type: goto}]}", "a");

  ASSERT_TRUE(read);
  EXPECT_EQ((*read)[0].block()->type, BlockType::kPlan);
  EXPECT_EQ((*read)[0].block()->end, EndMode::kWait);
  EXPECT_TRUE((*read)[0].block()->precondition.empty());
}

TEST(ReadAutomaton, FindsEveryErrorAtOnceWithItsPlace) {
  const std::string errors = errors_of(R"(block: b
kind: plan
exit: [[{componel: tt, state: ended}, {message: m, effect: continue}]]
content:
  - {task: t, type: goto}
  - {task: t, type: goto}
  - {block: c, type: loop, content: [{block: d, content: []}]}
  - {block: e, pre: [[{time: soon, is: passed}, {time: 1, since: "t:gone", is: passed}]], content: [{}]}
)");

  EXPECT_THAT(errors,
              AllOf(HasSubstr("a.yaml:2:7: kind: unknown key 'kind'"),
                    HasSubstr("a.yaml:3:20: exit[0][0].componel: unknown componel 'tt'"),
                    HasSubstr("did you mean 't'"), HasSubstr("only a loop can continue"),
                    HasSubstr("a.yaml:6:12: content[1].task: the id 't' is there twice"),
                    HasSubstr("a loop with nothing to do in it"), HasSubstr("an empty content")));
  EXPECT_THAT(errors, AllOf(HasSubstr("'soon'"), HasSubstr("unknown state 'gone'"),
                            HasSubstr("exactly one of block, task and action")));
}

TEST(ReadAutomaton, WhatIsNoBlockIsNoAutomaton) {
  EXPECT_THAT(errors_of("{task: t, type: goto}"), HasSubstr("not a block"));
  EXPECT_THAT(errors_of("[1]"), HasSubstr("not a componel"));
  EXPECT_THAT(errors_of("{block: b}"), HasSubstr("content: missing"));
  EXPECT_THAT(errors_of("{block: b, pre: [{message: m}], content: [{task: t, type: goto}]}"),
              HasSubstr("list"));
}

TEST(ReadAutomaton, EveryPieceThatIsWrongIsNamed) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"local: {p: }, content: [{task: t, type: goto}]", "no initialiser"},
      {"content: [{task: '', type: goto}]", "an empty id"},
      {"content: [{task: t, type: goto, params: [1]}]", "not a map"},
      {"pre: [[{}]], content: [{task: t, type: goto}]", "not a literal"},
      {"pre: [[{message: m, componel: t, state: ended}]], content: [{task: t, type: goto}]",
       "exactly one of componel, message and time"},
      {"pre: [[{message: m, effect: exit}]], content: [{task: t, type: goto}]",
       "a precondition has no effect"},
      {"pre: [[{time: 1, since: nothing, is: passed}]], content: [{task: t, type: goto}]",
       "'nothing' is no instant"},
      {"pre: [[{time: 1, since: 'u:ended', is: passed}]], content: [{task: t, type: goto}]",
       "unknown componel 'u'"},
      {"content: [{task: t, type: goto, modality: role-allocation}]", "unknown key 'modality'"},
      {"content: [{action: t}]", "modality: missing"}};
  for (const auto& [piece, why] : wrong) {
    EXPECT_THAT(errors_of("{block: b, " + piece + "}"), HasSubstr(why)) << piece;
  }
}

TEST(ReadAutomaton, AnExitOfOneLiteralWithoutListsIsRefused) {
  EXPECT_NE(errors_of("{block: b, exit: {message: m}, content: [{task: t, type: goto}]}"), "");
}

// Bytes changed, lost and doubled: an automaton or errors, and nothing else.
RC_GTEST_PROP(ReadAutomaton, NeverFailsOnDamagedText, ()) {
  static const std::string kText =
      R"({"block":"b10","type":"loop","exit":[[{"componel":"t11","state":"ended","not":true}]],
 "content":[{"task":"t11","type":"goto"},{"block":"b1","pre":[[{"time":3,"since":"t11:over","is":"passed"}]],
 "content":[{"action":"a","modality":"role-allocation"}]}]})";
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  std::string text = kText;
  for (std::uint64_t k = 1 + random.below(6); k > 0; --k) {
    const std::size_t at = random.below(text.size());
    if (random.chance(0.4)) text[at] = kText[random.below(kText.size())];
    if (random.chance(0.3)) text.erase(at, 1 + random.below(4));
    if (random.chance(0.3)) text.insert(at, kText.substr(random.below(kText.size()), 5));
    if (text.empty()) text = "{";
  }

  const auto read = read_automaton(text, "damaged");

  if (!read) {
    RC_ASSERT(!read.error().empty());
    return;
  }
  RC_ASSERT(!read->empty());
  for (const Componel& one : read->componels()) {
    RC_ASSERT((one.block() == nullptr || !one.block()->content.empty()));
  }
}

}  // namespace
}  // namespace skein::interaction
