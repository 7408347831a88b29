// SPDX-License-Identifier: Apache-2.0
// Every load-time check of spec 7.1.
#include "skein/interaction/read_library.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "skein/foundation/random.hpp"
#include "skein/interaction/draw_model.hpp"
#include "testing/small_library.hpp"

namespace skein::interaction {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::library_of;
using testing::small_library;

// Of the small library with something in place of something else.
std::string errors_of(const std::string& old, const std::string& put) {
  const auto library = library_of(small_library(old, put));
  return library ? "" : to_text(library.error());
}

TEST(ReadLibrary, ReadsRolesScmsAndModels) {
  const auto library = library_of(small_library());

  ASSERT_TRUE(library) << to_text(library.error());
  const Role& looker = library->roles.at("looker");
  EXPECT_THAT(
      looker.requirements,
      ElementsAre(Requirement{"hovering", std::monostate{}}, Requirement{"camera", "visible"},
                  Requirement{"endurance", Requirement::Bound{Relation::kAtLeast, 900}}));
  EXPECT_THAT(looker.parameters, ElementsAre(Parameter{"target", ParameterType::kObj},
                                             Parameter{"home", ParameterType::kPoint},
                                             Parameter{"span", ParameterType::kTime}));
  const Variant& pair = library->models.at("looking").variants.at(0);
  EXPECT_EQ(pair.table.arities.at("helper"), (Arity{1, 3}));
  EXPECT_EQ(pair.table.correspondences.at(0).number, 1);
  EXPECT_EQ(pair.table.correspondences.at(1).number, std::nullopt);
  EXPECT_EQ(pair.table.parameters.at("looker").at("home"), "base");
}

TEST(ReadLibrary, AnObjMayStandForAPoint) {
  EXPECT_EQ(errors_of("home: base, span", "home: what, span"), "");
}

TEST(ReadLibrary, AConditionOnTimeMayNameAParameterOfTheRole) {
  const auto library = library_of(small_library(
      "{block: l4, end: immediate,",
      "{block: l4, end: immediate, exit: [[{time: span, since: \"l5:running\", is: passed}]],"));

  ASSERT_TRUE(library) << to_text(library.error());
  const Automaton& looker = library->roles.at("looker").automaton;
  EXPECT_THAT(named_times(looker), ElementsAre("span"));
  const Automaton timed = with_times(looker, {{"span", 90}, {"home", 4}});
  EXPECT_THAT(named_times(timed), IsEmpty());
  const auto& exit = timed[*timed.find("l4")].block()->exit;
  EXPECT_EQ(std::get<TimeIs>(exit[0][0].condition).after, Duration::seconds(90));
}

TEST(ReadLibrary, TheBlocksOfARoleHoldWhatTheTableSays) {
  const auto library = library_of(small_library());
  ASSERT_TRUE(library);
  const Variant& pair = library->models.at("looking").variants.at(0);

  EXPECT_THAT(automaton_in(*library, pair, "looker")[0].block()->scms, ElementsAre("ring"));
  EXPECT_THAT(library->roles.at("looker").automaton[0].block()->scms, ElementsAre());
}

TEST(ReadLibrary, DocumentsMayComeInAnyOrder) {
  const std::string text = small_library();
  const std::size_t models = text.find("models:");
  const auto first = config::parse_yaml(text.substr(models), "models.yaml");
  const auto second = config::parse_yaml(text.substr(0, models), "rest.yaml");

  EXPECT_TRUE(read_library({{"models.yaml", *first}, {"rest.yaml", *second}}));
  const auto twice = read_library({{"a.yaml", *second}, {"b.yaml", *second}});
  ASSERT_FALSE(twice);
  EXPECT_THAT(to_text(twice.error()), HasSubstr("roles.looker: 'looker' is defined twice"));
}

TEST(ReadLibrary, EveryErrorIsToldAtOnceWithItsPlace) {
  std::string text = small_library("roles: [looker, helper]", "roles: [loker, helper]");
  text.replace(text.find("to: spot"), 8, "to: spt ");
  const auto library = library_of(text);

  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().size(), 2U) << to_text(library.error());
  EXPECT_THAT(
      to_text(library.error()),
      AllOf(HasSubstr("lib.yaml:22:47: roles.looker.automaton.content[0].params.to: unknown "
                      "name 'spt'"),
            HasSubstr("did you mean 'spot'"),
            HasSubstr("lib.yaml:33:17: models.looking.variants.pair.roles[0]: unknown name "
                      "'loker'")));
}

struct Wrong {
  const char* what;
  const char* old;
  const char* put;
  const char* error;
};

class ReadLibraryWrong : public ::testing::TestWithParam<Wrong> {};

TEST_P(ReadLibraryWrong, IsRefusedAndSaysWhy) {
  EXPECT_THAT(errors_of(GetParam().old, GetParam().put), HasSubstr(GetParam().error));
}

INSTANTIATE_TEST_SUITE_P(
    References, ReadLibraryWrong,
    ::testing::Values(
        Wrong{"Scm", "scm: near", "scm: neer",
              "unknown name 'neer'; expected an SCM that is defined"},
        Wrong{"Action", "action: l3, with", "action: l9, with", "unknown action 'l9'"},
        Wrong{"ActionThatIsATask", "target: h1", "target: h2", "unknown action 'h2'"},
        Wrong{"RoleOfArity", "arity: {looker: 1", "arity: {loker: 1", "unknown role 'loker'"},
        Wrong{"Block", "{looker: [l0]}", "{looker: [l1]}", "'l1' is no block of 'looker'"},
        Wrong{"ScmOfBlocks", "close: {helper", "clos: {helper", "unknown SCM 'clos'"},
        Wrong{"Function", "between(target", "betwixt(target", "unknown function 'betwixt'"},
        Wrong{"TaskType", "type: look,", "type: lok,", "unknown type of tasks 'lok'"},
        Wrong{"TaskParameter", "speed: 5", "sped: 5", "unknown parameter 'sped' of 'goto'"},
        Wrong{"Modality", "modality: role-allocation}, {task: h2", "modality: voting}, {task: h2",
              "unknown name 'voting'"},
        Wrong{"RoleParameter", "helper: {home: base}", "helper: {house: base}",
              "'helper' has no parameter 'house'"},
        Wrong{"VariantParameter", "span: time", "span: tyme", "unknown parameter 'tyme'"},
        Wrong{"Place", "place: looker, most", "place: nobody, most", "unknown place 'nobody'"},
        Wrong{"ScmParameter", "most: 100}", "most: 100, least: 5}",
              "'near' has no parameter 'least'"},
        Wrong{"TimeOfCondition", "pre: [[{componel: l1, state: ended}]]",
              "pre: [[{time: spam, is: passed}]]",
              "'spam' is no time; expected seconds, or a parameter of the role of type Time; did "
              "you mean 'span'?"},
        Wrong{"TimeOfConditionThatIsAPlace", "pre: [[{componel: l1, state: ended}]]",
              "pre: [[{time: home, is: passed}]]", "'home' is no time"},
        Wrong{"Key", "needs:", "neds:", "unknown key 'neds'"}),
    [](const auto& one) { return one.param.what; });

INSTANTIATE_TEST_SUITE_P(
    Types, ReadLibraryWrong,
    ::testing::Values(
        Wrong{"OfRoleParameter", "span: time", "span: base",
              "'base' is of type Point; expected one of type Time"},
        Wrong{"OfCall", "between(target, home)", "between(target, span)",
              "'span' is of type Time; expected one of type Point"},
        Wrong{"CountOfCall", "between(target, home)", "between(target)", "1 arguments; expected 2"},
        Wrong{"OfTask", "at: target", "at: home",
              "'home' is of type Point; expected one of type Obj"},
        Wrong{"MissingOfTask", "{at: target, duration: span}", "{at: target}",
              "'look' without its parameter 'duration'"},
        Wrong{"OfLiteral", "speed: 5", "speed: [5]", "a list"},
        Wrong{"OfPlace", "place: what", "place: time",
              "'time' is of type Time; expected an Obj or a Point"},
        Wrong{"Unknown", "what: Obj", "what: Thing", "unknown name 'Thing'"},
        Wrong{"NotGiven", "span: time", "", "the parameter 'span' of 'looker' is not given"},
        Wrong{"Condition", "endurance >= 900", "endurance >= long", "is no condition"},
        Wrong{"NameTaken", "local: {spot:", "local: {home:", "the name 'home' is taken already"}),
    [](const auto& one) { return one.param.what; });

INSTANTIATE_TEST_SUITE_P(
    Coordination, ReadLibraryWrong,
    ::testing::Values(
        Wrong{"OtherModality", "{action: l3, modality: role-allocation}",
              "{action: l3, modality: relay-chain}",
              "'l3' is relay-chain and 'h1' is role-allocation"},
        Wrong{"NotSymmetric",
              "            - {role: helper, action: h1, with: looker, target: l3, who: everyone}\n",
              "", "'h1' of 'helper' does not answer it"},
        Wrong{"Nothing", "{block: l2, pre: [[{message: ring violated}]], content: [{action: l3,",
              "{block: l2, content: [{action: l6, modality: role-allocation}, {action: l3,",
              "'l6' of 'looker' corresponds to nothing"},
        Wrong{"TooMany", "target: h1, who: 1", "target: h1, who: 4",
              "no team has 4 others who play 'helper'"},
        Wrong{"NoArity", "arity: {looker: 1, helper: {between: [1, 3]}}", "arity: {looker: 1}",
              "no arity of 'helper'"},
        Wrong{"EmptyRange", "between: [1, 3]", "between: [3, 1]", "no number is between them"},
        Wrong{"NoTeam", "arity: {looker: 1, helper: {between: [1, 3]}}",
              "arity: {looker: 1, helper: {at-most: 0}}", "arity.helper.at-most"}),
    [](const auto& one) { return one.param.what; });

INSTANTIATE_TEST_SUITE_P(
    NeverHolds, ReadLibraryWrong,
    ::testing::Values(
        Wrong{"Distances", "near: 25, far: 50", "near: 50, far: 25", "no position satisfies it"},
        Wrong{"Azimuth", "than: 0, tolerance", "than: 7, tolerance", "from 0 to 6.28319 rad"},
        Wrong{"Equality", "than: 0, tolerance: 0.1", "than: 0", "= without tolerance"},
        Wrong{"ScmOfMessage", "message: ring violated", "message: close violated",
              "waits for 'close violated', which can never come"},
        Wrong{"ScmNowhere", "close: {helper: [h0]}", "close: {helper: []}",
              "the SCM 'close' holds nowhere"},
        Wrong{"Block", "{componel: l1, state: ended}", "{componel: l4, state: ended}",
              "the block 'l4' can never be activated"},
        Wrong{"NamedTimesThatExclude", "pre: [[{componel: l1, state: ended}]]",
              "pre: [[{time: span, is: passed}], [{time: span, is: not-yet-passed}]]",
              "the block 'l4' can never be activated"},
        Wrong{"Loop", "{block: h0,", "{block: h0, type: loop,", "the loop 'h0' has no way out"}),
    [](const auto& one) { return one.param.what; });

INSTANTIATE_TEST_SUITE_P(
    Scms, ReadLibraryWrong,
    ::testing::Values(
        Wrong{"Name", "{place: Place, most: Number}", "{scm: Place, place: Place, most: Number}",
              "'scm' is no name of a parameter"},
        Wrong{"Kind", "most: Number}", "most: Figure}", "'Figure'; expected one of Place, Number"},
        Wrong{"NoConstraints", "constraints: [{distance-to: place, is: \"<\", than: most}]",
              "constraints: []", "no constraints; expected at least one"},
        Wrong{"TwoQuantities", "{distance-to: place, is: \">\"",
              "{distance-to: place, azimuth: [place, aside], is: \">\"",
              "exactly one of distance-to, azimuth and altitude"},
        Wrong{"Frame", "azimuth: [place, aside]", "azimuth: [place]", "no celestial frame"},
        Wrong{"Relation", "is: \">\"", "is: \"><\"", "unknown relation '><'"},
        Wrong{"PlaceAsDistance", "than: near}", "than: aside}",
              "a place where a distance is meant"},
        Wrong{"ThreePlaces", "than: far}", "than: [place, aside, place]}", "no reference"},
        Wrong{"Tolerance", "than: far}", "than: far, tolerance: 1}", "a tolerance without ="},
        Wrong{"NoTolerance", "tolerance: 0.1", "tolerance: 0",
              "nothing is equal to the last digit"},
        Wrong{"Place", "{distance-to: place, is: \"<\"", "{distance-to: plce, is: \"<\"",
              "unknown place 'plce'"}),
    [](const auto& one) { return one.param.what; });

TEST(ReadLibrary, OneUavIsNoTeam) {
  const auto library = library_of(R"(
roles: {alone: {automaton: {block: b, content: [{action: a, modality: role-allocation}]}}}
models: {m: {variants: {v: {roles: [alone], coordination: {arity: {alone: 1}, actions: [{role: alone, action: a, with: alone, target: a, who: 1}]}}}}})");

  ASSERT_FALSE(library);
  EXPECT_THAT(to_text(library.error()), AllOf(HasSubstr("no team can play this"),
                                              HasSubstr("no team has 1 others who play 'alone'")));
}

TEST(ReadLibrary, AllVariantsOfAModelTakeTheSameParameters) {
  std::string text = small_library();
  const std::size_t pair = text.find("      pair:");
  std::string other = text.substr(pair);
  other.replace(other.find("pair"), 4, "same");
  other.replace(other.find("base: Point, time"), 11, "base: Obj");

  const auto library = library_of(text + other);

  ASSERT_FALSE(library);
  EXPECT_THAT(to_text(library.error()), HasSubstr("other parameters than variant 'pair'"));
}

TEST(ReadLibrary, TheGroundMayPlayRolesOfTheVariantThatShareNoArea) {
  const auto with = [](const std::string& line) {
    std::string text = small_library();
    const std::size_t at = text.find("        coordination:");
    return library_of(text.insert(at, "        by-ground: " + line + "\n"));
  };
  const std::string first =
      library_of(small_library())->models.begin()->second.variants[0].roles[0];

  const auto allowed = with("[" + first + "]");
  const auto unknown = with("[nobody]");

  ASSERT_TRUE(allowed) << to_text(allowed.error());
  EXPECT_TRUE(has_roles_by_ground(allowed->models.begin()->second));
  EXPECT_FALSE(has_roles_by_ground(library_of(small_library())->models.begin()->second));
  ASSERT_FALSE(unknown);
  EXPECT_THAT(to_text(unknown.error()), HasSubstr("unknown role 'nobody'"));
}

// Bytes changed, lost and doubled: a library that can be drawn, or errors.
RC_GTEST_PROP(ReadLibrary, NeverFailsOnDamagedText, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const std::string whole = testing::kSmallLibrary;
  std::string text = whole;
  for (std::uint64_t k = 1 + random.below(4); k > 0; --k) {
    const std::size_t at = random.below(text.size());
    if (random.chance(0.4)) text[at] = whole[random.below(whole.size())];
    if (random.chance(0.3)) text.erase(at, 1 + random.below(8));
    if (random.chance(0.3)) text.insert(at, whole.substr(random.below(whole.size()), 9));
  }

  const auto library = library_of(text);

  if (library) {
    RC_ASSERT(!draw_svg(*library).empty());
  } else {
    RC_ASSERT(!library.error().empty());
  }
}

}  // namespace
}  // namespace skein::interaction
