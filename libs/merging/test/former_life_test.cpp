// SPDX-License-Identifier: Apache-2.0
// With a witness, a request of before a restart may have been granted.
#include "skein/merging/former_life.hpp"

#include <gtest/gtest.h>

namespace skein::merging {
namespace {

constexpr std::uint64_t kBegun = 50'000;  // [ms]

FormerLife begun(bool with_witness) {
  FormerLife life(with_witness);
  life.lives(MissionTime::seconds(50));
  life.lives(MissionTime::seconds(90));
  return life;
}

TEST(FormerLife, ARequestOfBeforeItMayHaveBeenGranted) {
  EXPECT_TRUE(begun(true).may_have_granted(kBegun - 1));
  EXPECT_TRUE(begun(true).may_have_granted(kBegun + 999)) << "clocks are a second apart";
  EXPECT_FALSE(begun(true).may_have_granted(kBegun + 1'000)) << "it began at 50 s, not at 90 s";
}

TEST(FormerLife, NothingWasGrantedWhereThereWasNone) {
  FormerLife life = begun(true);
  life.was_none();
  EXPECT_FALSE(life.may_have_granted(kBegun - 1));
}

TEST(FormerLife, WithoutAWitnessEverybodyIsAskedAnyway) {
  EXPECT_FALSE(begun(false).may_have_granted(kBegun - 1));
}

}  // namespace
}  // namespace skein::merging
