// SPDX-License-Identifier: Apache-2.0
// What perception processing and the following of objects go by: what is refused.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <limits>

#include "skein/ground_orders/object_spec.hpp"
#include "skein/ground_orders/pps_config.hpp"

namespace skein::ground_station {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- perception processing ----

TEST(PpsConfig, TheDefaultsAreUsable) { EXPECT_THAT(problems_of(PpsConfig()), IsEmpty()); }

TEST(PpsConfig, ReportsEveryProblemAtOnce) {
  PpsConfig config;
  config.devices["visible"].kinds["fire"] = {1.5, 0.1};
  config.devices["ir"].limit = 0;
  config.raise = 0.01;
  config.gate = 0;
  config.forget = Duration();

  EXPECT_EQ(problems_of(config).size(), 6U);
}

TEST(PpsConfig, OfTheModelOfAUavNamesDeviceAndUav) {
  PpsConfig config;
  config.models[{"karma", "sonar"}].limit = -1;

  EXPECT_THAT(problems_of(config), ElementsAre("device sonar of karma: limit must be positive"));
}

// A camera must leave something for "nothing": else a look without detections would be impossible.
TEST(PpsConfig, KindsOfADeviceAddUpToLessThanOne) {
  PpsConfig config;
  config.devices["visible"].kinds = {{"fire", {0.5, 0.1}}, {"smoke", {0.5, 0.1}}};

  EXPECT_THAT(problems_of(config), ElementsAre(HasSubstr("must add up to less than 1")));
}

TEST(PpsConfig, WhatIsNotANumberIsNoThreshold) {
  const std::vector<std::function<void(PpsConfig&)>> spoil{
      [](PpsConfig& it) { it.prior = kNan; },
      [](PpsConfig& it) { it.gate = kNan; },
      [](PpsConfig& it) { it.least_separation = kNan; },
      [](PpsConfig& it) { it.least_spread = kNan; },
      [](PpsConfig& it) { it.refine_distance = kNan; },
      [](PpsConfig& it) { it.devices["ir"].limit = kInfinity; },
      [](PpsConfig& it) { it.devices["ir"].kinds["fire"].if_fire = kNan; }};
  for (std::size_t i = 0; i < spoil.size(); ++i) {
    PpsConfig config;
    spoil[i](config);

    EXPECT_FALSE(problems_of(config).empty()) << "spoilt in way " << i;
  }
}

RC_GTEST_PROP(PpsConfig, ThresholdsAreUsableIfAndOnlyIfTheyAreInOrder, ()) {
  const auto any = [] { return *rc::gen::inRange(0, 11) / 10.0; };
  PpsConfig config;
  config.infirm = any();
  config.prior = any();
  config.raise = any();
  config.confirm = any();
  const std::vector<double> strictly{0, config.infirm, config.prior, config.raise};
  const bool ordered = std::is_sorted(strictly.begin(), strictly.end(), std::less_equal<>()) &&
                       std::adjacent_find(strictly.begin(), strictly.end()) == strictly.end() &&
                       config.raise <= config.confirm && config.confirm < 1;

  RC_ASSERT(problems_of(config).empty() == ordered);
}

// ---- objects ----

ObjectSpec front() { return {"fire-front", "fire", {90, 40, 0}, 50, 0.5}; }

TEST(ObjectSpec, SaysAllThatIsWrongAtOnce) {
  ObjectSpec other = front();
  other.kind = "";
  other.drift = 0;
  other.reach = -1;

  EXPECT_THAT(
      problems_of({front(), other}),
      ElementsAre(HasSubstr("the name is taken"), HasSubstr("no kind"),
                  HasSubstr("reach must be positive"), HasSubstr("drift must be positive")));
}

TEST(ObjectSpec, FiguresAreFinite) {
  ObjectSpec lost = front(), far = front(), fast = front();
  lost.thought.x() = kNan;
  far.reach = kInfinity;
  fast.drift = kNan;

  EXPECT_THAT(problems_of(std::vector{lost}), ElementsAre(HasSubstr("its place is not finite")));
  EXPECT_THAT(problems_of(std::vector{far}), ElementsAre(HasSubstr("reach must be positive")));
  EXPECT_THAT(problems_of(std::vector{fast}), ElementsAre(HasSubstr("drift must be positive")));
}

TEST(ObjectSpec, NoneAndGoodOnesAreFine) {
  ObjectSpec other = front();
  other.name = "truck";

  EXPECT_THAT(problems_of(std::vector<ObjectSpec>{}), IsEmpty());
  EXPECT_THAT(problems_of({front(), other}), IsEmpty());
}

}  // namespace
}  // namespace skein::ground_station
