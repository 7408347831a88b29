// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/model_hash.hpp"

#include <gtest/gtest.h>

#include <set>

#include "testing/small_library.hpp"

namespace skein::interaction {
namespace {

using testing::library_of;
using testing::small_library;

ModelHash hash_of_text(const std::string& text) {
  const auto library = library_of(text);
  EXPECT_TRUE(library) << to_text(library.error());
  return library ? hash_of(*library, "looking") : ModelHash{};
}

ModelHash hash_with(const std::string& old, const std::string& put) {
  return hash_of_text(small_library(old, put));
}

struct Change {
  std::string old, put;
  friend void PrintTo(const Change& change, std::ostream* to) {
    *to << change.old << " -> " << change.put;
  }
};

class ModelHashOfTheSame : public ::testing::TestWithParam<Change> {};
class ModelHashOfAnother : public ::testing::TestWithParam<Change> {};

TEST_P(ModelHashOfTheSame, StaysWhatItIs) {
  EXPECT_EQ(hash_with(GetParam().old, GetParam().put), hash_of_text(small_library()));
}

TEST_P(ModelHashOfAnother, IsAnother) {
  EXPECT_NE(hash_with(GetParam().old, GetParam().put).value, hash_of_text(small_library()).value);
}

TEST(ModelHash, TellsSecondsFromThoseThatAParameterSays) {
  const auto hash_until = [](const std::string& time) {
    return hash_with("pre: [[{componel: l1, state: ended}]]",
                     "pre: [[{time: " + time + ", is: passed}]]")
        .value;
  };
  EXPECT_NE(hash_until("0"), hash_until("span"));
}

INSTANTIATE_TEST_SUITE_P(
    HoweverWritten, ModelHashOfTheSame,
    ::testing::Values(Change{"roles:\n", "\n# what they do\nroles:   # all\n"},
                      Change{"near: 25, far: 50", "far: 50.0, near: 2.5e1"},
                      Change{"to: spot, speed: 5", "speed: 5.0, to: spot"},
                      Change{"{action: l3, modality: role-allocation}",
                             "{modality: role-allocation, action: l3}"},
                      Change{"roles: [looker, helper]", "roles: [helper, looker]"},
                      Change{"[hovering, {camera: visible}, \"endurance >= 900\"]",
                             "[\"endurance >= 900\", hovering, {camera: visible}]"},
                      Change{"blocks: {ring: {looker: [l0]}, close: {helper: [h0]}}",
                             "blocks: {close: {helper: [h0]}, ring: {looker: [l0]}}"},
                      Change{"parameters: {place: Place, most: Number}",
                             "parameters: {most: Number, place: Place}"},
                      Change{"helper: {home: base}", "helper:\n              home: base"},
                      Change{"  goto: {to: Point, \"speed?\": Number}\n",
                             "  goto: {to: Point, \"speed?\": Number}\n  nap: {until: Time}\n"}));

INSTANTIATE_TEST_SUITE_P(
    InWhatItSays, ModelHashOfAnother,
    ::testing::Values(Change{"near: 25, far: 50", "near: 25, far: 51"},
                      Change{"tolerance: 0.1", "tolerance: 0.2"},
                      Change{"endurance >= 900", "endurance > 900"},
                      Change{"endurance >= 900", "endurance >= 901"},
                      Change{"camera: visible", "camera: infrared"}, Change{"speed: 5", "speed: 6"},
                      Change{"end: immediate, ", ""},
                      Change{"{message: ring violated}", "{message: ring satisfied}"},
                      Change{"{componel: l1, state: ended}", "{componel: l1, state: over}"},
                      Change{"helper: {between: [1, 3]}", "helper: {between: [1, 2]}"},
                      Change{"who: everyone", "who: 1"},
                      Change{"close: {helper: [h0]}", "close: {helper: [h0], looker: [l4]}"},
                      Change{"between(target, home)", "between(home, target)"},
                      Change{"to: [1, 2, 3]", "to: [1, 3, 2]"}, Change{"pair:", "couple:"},
                      Change{"what: Obj, base: Point", "base: Point, what: Obj"}));

TEST(ModelHash, NoTwoModelsOfTheSmallChangesShareOne) {
  std::set<std::uint64_t> seen;
  for (int far = 40; far < 140; ++far) {
    seen.insert(hash_with("far: 50", "far: " + std::to_string(far)).value);
  }

  EXPECT_EQ(seen.size(), 100U);
}

TEST(ModelHash, IsWrittenAsSixteenDigits) {
  EXPECT_EQ(to_text(ModelHash{0xabc}), "0000000000000abc");
  EXPECT_EQ(to_text(ModelHash{0xfedcba9876543210}), "fedcba9876543210");
}

// Other UAVs are other builds: the number must not depend on this one.
TEST(ModelHash, IsTheSameEverywhere) {
  EXPECT_EQ(to_text(hash_of_text(small_library())), "94ce96b6aa0f08e1");
}

}  // namespace
}  // namespace skein::interaction
