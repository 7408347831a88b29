// SPDX-License-Identifier: Apache-2.0
#include "interaction/joint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/watch_and_relay.hpp"

namespace skein::decision_node {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::string why_not(const mission::ElementaryTask& task, const std::string& self = "marvin") {
  const auto joint = joint_of(task, testing::watching_library(), self, {"heliv", "karma"});
  return joint ? "" : joint.error().why;
}

mission::ElementaryTask without(const std::string& name) {
  mission::ElementaryTask task = testing::watching();
  std::vector<executive::Parameter> all = task.parameters.all();
  std::erase_if(all, [&](const auto& one) { return one.name == name; });
  task.parameters = executive::Parameters(std::move(all));
  return task;
}

TEST(Joint, IsTheSameForAllWhoAreAskedForTheSame) {
  const Joint one = testing::joint("marvin"), other = testing::joint("heliv");

  EXPECT_EQ(one.subject, "watching(fire 0,0,5 60) of heliv, marvin");
  EXPECT_EQ(other.subject, one.subject);
  EXPECT_EQ(other.hash, one.hash);
  EXPECT_THAT(one.members, ElementsAre("heliv", "marvin"));
  EXPECT_EQ(one.variant->name, "pair");
}

TEST(Joint, IsRefusedWithItsReason) {
  mission::ElementaryTask other = testing::watching();
  other.type = "joint:lifting";

  EXPECT_EQ(why_not(testing::watching()), "");
  EXPECT_EQ(why_not(other), "no interaction model 'lifting'");
  EXPECT_EQ(why_not(without("front")), "parameter 'front' is missing");
  EXPECT_EQ(why_not(testing::watching("heliv karma")), "'marvin' is not among its members");
  EXPECT_EQ(why_not(testing::watching("marvin hawk")), "no UAV 'hawk'");
  EXPECT_EQ(why_not(testing::watching("marvin marvin")), "a member is named twice");
  EXPECT_EQ(why_not(testing::watching("marvin heliv karma")),
            "no variant of 'watching' for 3 UAVs");
  EXPECT_THAT(joint_of(testing::watching(), nullptr, "marvin", {}).error().why,
              HasSubstr("no interaction models"));
}

TEST(Joint, AParameterOfAnotherTypeIsRefused) {
  mission::ElementaryTask task = without("duration");
  task.parameters.add("duration", std::string("long"));

  EXPECT_EQ(why_not(task), "parameter 'duration' is not a number");
}

TEST(Joint, OtherValuesOfTheSameAreNamed) {
  const Joint joint = testing::joint("marvin");

  EXPECT_EQ(difference(joint, "watching(fire 0,0,5 90) of heliv, marvin"), "duration 90, not 60");
  EXPECT_THAT(difference(joint, "watching(fire 1,0,5 90) of heliv, marvin").value_or(""),
              HasSubstr("; duration 90, not 60"));
  for (const char* other :
       {"watching(fire 0,0,5 60) of heliv, marvin", "watching(lake 0,0,5 90) of heliv, marvin",
        "watching(fire 0,0,5 90) of heliv, karma", "lifting(fire 0,0,5 90) of heliv, marvin",
        "watching(fire 90) of heliv, marvin", "watching() of heliv, marvin", "watching(", ""})
    EXPECT_EQ(difference(joint, other), std::nullopt) << other;
}

TEST(Joint, AmongFewerIsInTheVariantForSoManyAndMeansTheSame) {
  auto library = std::make_shared<interaction::Library>(*testing::watching_library());
  auto& variants = library->models.at("watching").variants;
  variants.front().table.arities.at("relay") = {2, 2};
  variants.push_back(variants.front());
  variants.back().name = "fewer";
  variants.back().table.arities.at("relay") = {1, 1};
  const Joint three =
      joint_of(testing::watching("marvin heliv karma"), library, "marvin", {"heliv", "karma"})
          .value();

  const auto two = among(three, {"karma", "marvin"});

  ASSERT_TRUE(two);
  EXPECT_EQ(three.variant->name, "pair");
  EXPECT_EQ(two->variant->name, "fewer");
  EXPECT_EQ(two->subject, three.subject);
  EXPECT_EQ(two->members, (std::vector<std::string>{"karma", "marvin"}));
  EXPECT_EQ(two->arguments.at("uavs"), Argument(std::vector<std::string>{"karma", "marvin"}));
  EXPECT_FALSE(among(three, {"marvin"}));
}

TEST(Joint, ParametersOfARoleComeFromThoseOfTheModel) {
  const Arguments watch = arguments_of(testing::joint(), "watch");

  EXPECT_EQ(std::get<std::string>(watch.at("front")), "fire");
  EXPECT_EQ(std::get<double>(watch.at("duration")), 60);
  EXPECT_FALSE(watch.contains("ground"));
  EXPECT_EQ(std::get<interaction::Position>(arguments_of(testing::joint(), "relay").at("ground")),
            (interaction::Position{0, 0, 5}));
}

TEST(Joint, AnExpressionIsANameOfTheScopeOrALiteral) {
  const Arguments scope{{"place", interaction::Position{1, 2, 3}}};
  const auto value = [&](const std::string& yaml) {
    return value_of(config::parse_yaml(yaml, "test").value(), scope);
  };

  EXPECT_EQ(std::get<interaction::Position>(*value("place")), (interaction::Position{1, 2, 3}));
  EXPECT_EQ(std::get<double>(*value("2.5")), 2.5);
  EXPECT_EQ(std::get<std::string>(*value("'place'")), "place");
  EXPECT_EQ(std::get<interaction::Position>(*value("[4, 5, 6]")), (interaction::Position{4, 5, 6}));
  EXPECT_THAT(std::get<std::vector<std::string>>(*value("[heliv, marvin]")),
              ElementsAre("heliv", "marvin"));
  EXPECT_EQ(value("elsewhere").error().why, "'elsewhere' has no value");
}

TEST(Joint, PlacesOfAConstraintAreHoldersOthersAndPoints) {
  const Joint joint = testing::joint();
  const Holders holders{{"heliv", "relay"}, {"marvin", "watch"}};
  const auto& scms = joint.variant->table.scms;

  const auto apart = binding_of(joint, scms.at(0), holders, "marvin");
  const auto in_view = binding_of(joint, scms.at(1), holders, "marvin");

  EXPECT_THAT(apart.places.at("from"), ElementsAre("heliv"));
  EXPECT_EQ(apart.numbers.at("least"), 20);
  EXPECT_THAT(in_view.places.at("target"), ElementsAre("fire"));
  EXPECT_FALSE(is_about_places(joint, scms.at(0)));
  EXPECT_TRUE(is_about_places(joint, scms.at(1)));
}

TEST(Joint, WithoutPartnersThereIsNobodyToKeepApartFrom) {
  const Joint joint = testing::joint();

  EXPECT_THAT(binding_of(joint, joint.variant->table.scms.at(0), {}, "marvin").places.at("from"),
              IsEmpty());
}

Holders held_by(const std::vector<std::string>& uavs) {
  Holders holders;
  for (const std::string& uav : uavs) holders[uav] = "watch";
  return holders;
}

TEST(Holders, OfWhoGoOnApartTheMoreOutweighAndElseThoseWithTheFirstName) {
  EXPECT_TRUE(outweigh(held_by({"karma", "marvin"}), held_by({"heliv"})));
  EXPECT_FALSE(outweigh(held_by({"heliv"}), held_by({"karma", "marvin"})));
  EXPECT_TRUE(outweigh(held_by({"heliv"}), held_by({"marvin"})));
  EXPECT_FALSE(outweigh(held_by({"marvin"}), held_by({"heliv"})));
}

TEST(Holders, WhoIsNotAwareYetThatTheOthersLostItIsOutweighedByThemAll) {
  EXPECT_TRUE(outweigh(held_by({"heliv", "karma"}), held_by({"heliv", "karma", "marvin"})));
  EXPECT_FALSE(outweigh(held_by({"marvin"}), held_by({"heliv", "karma", "marvin"})));
}

// If both yielded, nobody would map what was theirs; a third one that both hear counts for both.
TEST(Holders, OfTwoSidesThatGoOnWithoutEachOtherExactlyOneOutweighs) {
  const std::vector<std::string> uavs{"a", "b", "c", "d", "e"};
  const auto side = [&](unsigned bits) {
    std::vector<std::string> some;
    for (std::size_t i = 0; i < uavs.size(); ++i)
      if ((bits >> i & 1U) != 0) some.push_back(uavs[i]);
    return held_by(some);
  };
  for (unsigned one = 1; one < 32; ++one) {
    for (unsigned other = 1; other < 32; ++other) {
      if ((one & ~other) == 0 || (other & ~one) == 0) continue;  // nobody of one is lost there
      EXPECT_NE(outweigh(side(one), side(other)), outweigh(side(other), side(one)))
          << one << " and " << other;
    }
  }
}

}  // namespace
}  // namespace skein::decision_node
