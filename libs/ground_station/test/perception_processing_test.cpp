// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/perception_processing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/foundation/random.hpp"
#include "testing/builders.hpp"
#include "testing/looks.hpp"

namespace skein::ground_station {
namespace {

using testing::flat_terrain;
using testing::kFire;
using testing::look;
using testing::seeing;
using world::Detection;
using world::Perception;
using world::Terrain;
using world::TerrainSpec;
using world::Vector3;

std::vector<PerceptionProcessing::Effect> give(PerceptionProcessing& pps, const Perception& p) {
  return pps.handle(p, p.at);
}

std::vector<AlarmState> states(const std::vector<PerceptionProcessing::Effect>& effects) {
  std::vector<AlarmState> out;
  for (const auto& effect : effects) {
    if (const auto* event = std::get_if<AlarmEvent>(&effect)) out.push_back(event->alarm.state);
  }
  return out;
}

// Marvin's fire sensor sees the heat until the alarm is raised; the instant of the last look.
double raise(PerceptionProcessing& pps, double from = 0,
             const std::string& device = "fire-sensor") {
  for (int i = 0; i < 20; ++i) {
    const double at = from + 2.0 * i;
    if (!states(give(pps, seeing(look("marvin", device, at), "fire"))).empty()) return at;
  }
  ADD_FAILURE() << "never raised";
  return 0;
}

TEST(PerceptionProcessing, OneDetectionDoesNotMakeAnAlarm) {
  PerceptionProcessing pps({}, flat_terrain());

  const auto effects = give(pps, seeing(look("marvin", "fire-sensor", 1), "fire"));

  ASSERT_EQ(effects.size(), 1U);
  const auto& logged = std::get<PerceptionLogged>(effects.front());
  EXPECT_EQ(logged.uav, "marvin");
  EXPECT_EQ(logged.detections, 1U);
  EXPECT_TRUE(pps.alarms().empty());
}

TEST(PerceptionProcessing, RepeatedDetectionsRaiseOneAlarm) {
  PerceptionProcessing pps({}, flat_terrain());

  raise(pps);

  ASSERT_EQ(pps.alarms().size(), 1U);
  const Alarm alarm = pps.alarms().front();
  EXPECT_EQ(alarm.id, AlarmId(1));
  EXPECT_EQ(alarm.state, AlarmState::kRaised);
  EXPECT_GE(alarm.belief, 0.9);
  EXPECT_NEAR((alarm.position - kFire).norm(), 0, 1e-9);
}

TEST(PerceptionProcessing, BeliefFollowsBayesRule) {
  PpsConfig config;
  config.devices["fire-sensor"].limit = 1000;
  PerceptionProcessing pps(config, flat_terrain());
  // The same by plain multiplication of probabilities.
  double fire = 0.1;
  double none = 0.9;
  const std::vector<bool> outcomes = {true, true, false, true, true, false, true, true, true};

  double at = 0;
  for (const bool seen : outcomes) {
    Perception p = look("marvin", "fire-sensor", at += 5);
    give(pps, seen ? seeing(p, "fire") : p);
    fire *= seen ? 0.8 : 1 - 0.8;
    none *= seen ? 0.1 : 1 - 0.1;
  }

  ASSERT_EQ(pps.alarms().size(), 1U);
  EXPECT_NEAR(pps.alarms().front().belief, fire / (fire + none), 1e-12);
}

TEST(PerceptionProcessing, RandomLooksOfSeveralDevicesFollowBayesRule) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    PpsConfig config;
    for (auto& [name, device] : config.devices) device.limit = 1000;
    config.infirm = 1e-9;
    PerceptionProcessing pps(config, flat_terrain());
    double fire = 0.1;
    double none = 0.9;

    double belief = 0;
    for (int i = 0; i < 30; ++i) {
      const bool visible = i > 3 && random.chance(0.5);
      const bool seen = i <= 3 || random.chance(0.6);
      const std::string kind = visible && seen && random.chance(0.3) ? "vehicle" : "fire";
      Perception p = look("marvin", visible ? "visible" : "ir", 10 + 2 * i);
      give(pps, seen ? seeing(p, kind) : p);
      const double p_fire = !visible ? (seen ? 0.85 : 0.15)
                            : !seen  ? 1 - 0.8 - 0.1 - 0.02
                                     : (kind == "fire" ? 0.8 : 0.01);
      const double p_none = !visible ? (seen ? 0.1 : 0.9)
                            : !seen  ? 1 - 0.02 - 0.02 - 0.4
                                     : (kind == "fire" ? 0.02 : 0.2);
      const double total = fire * p_fire + none * p_none;
      fire = fire * p_fire / total;
      none = none * p_none / total;
      ASSERT_FALSE(pps.alarms().empty() && i > 3);
      if (!pps.alarms().empty()) belief = pps.alarms().front().belief;
      if (i > 3 && fire <= 1e-9) break;
    }

    EXPECT_NEAR(belief, fire, 1e-6) << "seed " << seed;
  }
}

TEST(PerceptionProcessing, BeliefsAreCalibrated) {
  // Of many fires and no-fires looked at by a sensor that is as its likelihoods say, those believed
  // in with probability about p are fires about p of the time.
  Random random(7);
  PpsConfig config;
  config.devices["ir"].limit = 100;
  config.infirm = 1e-6;
  config.raise = 0.5;
  config.prior = 0.3;
  int believed = 0;
  int fires = 0;
  double expected = 0;

  for (int trial = 0; trial < 4000; ++trial) {
    const bool fire = random.chance(0.3);
    PerceptionProcessing pps(config, flat_terrain());
    int at = 0;
    for (int i = 0; i < 4; ++i) {
      Perception p = look("heliv", "ir", at += 2);
      give(pps, random.chance(fire ? 0.85 : 0.1) ? seeing(p, "fire") : p);
    }
    if (pps.alarms().empty()) continue;
    // Looks before the first detection made no candidate and so do not count.
    if (pps.alarms().front().first_seen != MissionTime::seconds(2)) continue;
    ++believed;
    fires += fire ? 1 : 0;
    expected += pps.alarms().front().belief;
  }

  ASSERT_GT(believed, 500);
  EXPECT_NEAR(static_cast<double>(fires) / believed, expected / believed, 0.02);
}

TEST(PerceptionProcessing, LooksCloserThanTheDecorrelationTimeCountOnce) {
  PerceptionProcessing pps({}, flat_terrain());

  for (int i = 0; i < 9; ++i) {
    give(pps, seeing(look("marvin", "fire-sensor", 1 + 0.1 * i), "fire"));
  }

  EXPECT_TRUE(pps.alarms().empty());
}

// A device that looks each second is woken a little early or late on a machine that has more to do.
TEST(PerceptionProcessing, LooksThatAreTheDecorrelationTimeApartButForAHairCountEach) {
  PerceptionProcessing pps({}, flat_terrain());

  give(pps, seeing(look("marvin", "fire-sensor", 1.002), "fire"));
  give(pps, seeing(look("marvin", "fire-sensor", 2.000), "fire"));
  const auto effects = give(pps, seeing(look("marvin", "fire-sensor", 2.998), "fire"));

  EXPECT_EQ(states(effects), std::vector{AlarmState::kRaised});
}

TEST(PerceptionProcessing, TwoDevicesAreIndependentAtOneInstant) {
  PerceptionProcessing pps({}, flat_terrain());

  give(pps, seeing(look("marvin", "fire-sensor", 1), "fire"));
  give(pps, seeing(look("heliv", "ir", 1), "fire"));
  const auto effects = give(pps, seeing(look("karma", "mapping", 1), "fire"));

  EXPECT_EQ(states(effects), std::vector{AlarmState::kRaised});
}

TEST(PerceptionProcessing, OneDeviceAloneNeverMakesCertain) {
  PerceptionProcessing pps({}, flat_terrain());
  raise(pps);

  for (int i = 0; i < 100; ++i)
    give(pps, seeing(look("marvin", "fire-sensor", 50 + 2 * i), "fire"));

  const double limit = std::log(0.1 / 0.9) + 5;
  EXPECT_NEAR(pps.alarms().front().belief, 1 / (1 + std::exp(-limit)), 1e-12);
  EXPECT_EQ(pps.alarms().front().state, AlarmState::kRaised);
}

TEST(PerceptionProcessing, OnlyAConfirmingDeviceConfirms) {
  PerceptionProcessing pps({}, flat_terrain());
  double at = raise(pps);
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(states(give(pps, seeing(look("heliv", "ir", at += 2), "fire"))).empty());
  }

  const auto effects = give(pps, seeing(look("heliv", "visible", at += 2), "smoke"));

  EXPECT_EQ(states(effects), std::vector{AlarmState::kConfirmed});
}

TEST(PerceptionProcessing, AConfirmingDeviceRaisesAndConfirmsByItself) {
  PerceptionProcessing pps({}, flat_terrain());
  give(pps, seeing(look("heliv", "visible", 0), "fire"));

  const auto effects = give(pps, seeing(look("heliv", "visible", 2), "fire"));

  EXPECT_EQ(states(effects), (std::vector{AlarmState::kRaised, AlarmState::kConfirmed}));
}

TEST(PerceptionProcessing, AConfirmingDeviceThatSeesNothingInfirms) {
  PerceptionProcessing pps({}, flat_terrain());
  double at = raise(pps);

  std::vector<AlarmState> seen;
  for (int i = 0; i < 10 && seen.empty(); ++i) {
    seen = states(give(pps, look("heliv", "visible", at += 2)));
  }

  EXPECT_EQ(seen, std::vector{AlarmState::kInfirmed});
}

TEST(PerceptionProcessing, RecognisingAVehicleInfirmsAlthoughTheHeatIsSeenMeanwhile) {
  PerceptionProcessing pps({}, flat_terrain());
  double at = raise(pps);

  std::vector<AlarmState> seen;
  for (int i = 0; i < 30 && seen.empty(); ++i) {
    give(pps, seeing(look("heliv", "ir", at += 2), "fire"));
    seen = states(give(pps, seeing(look("heliv", "visible", at), "vehicle")));
  }

  EXPECT_EQ(seen, std::vector{AlarmState::kInfirmed});
}

double infirm(PerceptionProcessing& pps, double at) {
  for (int i = 0; i < 12; ++i) give(pps, look("heliv", "visible", at += 2));
  EXPECT_EQ(pps.alarms().front().state, AlarmState::kInfirmed);
  return at;
}

TEST(PerceptionProcessing, TheSameHeatDoesNotRaiseAnInfirmedAlarmAgain) {
  PerceptionProcessing pps({}, flat_terrain());
  double at = infirm(pps, raise(pps));

  for (int i = 0; i < 200; ++i) {
    EXPECT_TRUE(states(give(pps, seeing(look("marvin", "fire-sensor", at += 2), "fire"))).empty());
  }

  EXPECT_EQ(pps.alarms().size(), 1U);
}

TEST(PerceptionProcessing, AConfirmingDeviceReopensAnInfirmedAlarm) {
  PerceptionProcessing pps({}, flat_terrain());
  double at = infirm(pps, raise(pps));

  std::vector<AlarmState> seen;
  for (int i = 0; i < 10; ++i) {
    for (const AlarmState state :
         states(give(pps, seeing(look("heliv", "visible", at += 2), "fire")))) {
      seen.push_back(state);
    }
  }

  EXPECT_EQ(seen, (std::vector{AlarmState::kRaised, AlarmState::kConfirmed}));
}

TEST(PerceptionProcessing, AConfirmedAlarmIsForGood) {
  PerceptionProcessing pps({}, flat_terrain());
  double at = raise(pps);
  give(pps, seeing(look("heliv", "visible", at += 2), "fire"));

  for (int i = 0; i < 30; ++i) {
    EXPECT_TRUE(states(give(pps, look("heliv", "visible", at += 2))).empty());
  }

  EXPECT_EQ(pps.alarms().front().state, AlarmState::kConfirmed);
}

struct NotSeen {
  const char* why;
  Perception look;
};

TEST(PerceptionProcessing, ALookThatCouldNotHaveSeenItSaysNothing) {
  const Terrain ridge(TerrainSpec{.west = -1000,
                                  .south = -1000,
                                  .east = 1000,
                                  .north = 1000,
                                  .cell = 10,
                                  .base = 0,
                                  .hills = {{{160, 50}, 80, 50}},
                                  .elevations = {}});
  Perception far = look("heliv", "visible", 100);
  far.viewpoint = kFire + Vector3(0, 0, 160);
  Perception aside = look("heliv", "visible", 100);
  aside.direction = Vector3::UnitX();
  Perception hidden = look("heliv", "visible", 100);
  hidden.viewpoint = kFire + Vector3(130, 0, 20);
  hidden.direction = (kFire - hidden.viewpoint).normalized();
  Perception edge = look("heliv", "visible", 100);
  edge.viewpoint = kFire + Vector3(0, 61, 60);  // its place is in the cone, its uncertainty is not
  for (const NotSeen& c : {NotSeen{"out of range", far}, NotSeen{"not in the cone", aside},
                           NotSeen{"behind the ridge", hidden}, NotSeen{"at the edge", edge}}) {
    PerceptionProcessing pps({}, ridge);
    raise(pps);
    const double before = pps.alarms().front().belief;

    give(pps, c.look);

    EXPECT_EQ(pps.alarms().front().belief, before) << c.why;
  }
}

TEST(PerceptionProcessing, DistantDetectionsAreSeparateAlarms) {
  PerceptionProcessing pps({}, flat_terrain());
  const Vector3 other = kFire + Vector3(200, 0, 0);

  for (int i = 0; i < 10; ++i) {
    give(pps, seeing(look("marvin", "fire-sensor", 4 * i), "fire"));
    give(pps, seeing(look("marvin", "fire-sensor", 4 * i + 2, other), "fire", other));
  }

  ASSERT_EQ(pps.alarms().size(), 2U);
  EXPECT_NEAR((pps.alarms()[0].position - kFire).norm(), 0, 1e-9);
  EXPECT_NEAR((pps.alarms()[1].position - other).norm(), 0, 1e-9);
}

// An outlier makes a place of its own, which nearer looks are taken for, and with each of these it
// comes nearer to the fire (IROS 2005, seed 64: two alarms for one fire).
TEST(PerceptionProcessing, AnOutlierThatComesNearRaisesNoSecondAlarm) {
  PerceptionProcessing pps({}, flat_terrain());
  double at = raise(pps);

  for (const double off : {28, 17, 16, 17, 16, 17})
    give(pps, seeing(look("marvin", "fire-sensor", at += 2), "fire", kFire + Vector3(off, 0, 0)));

  EXPECT_EQ(pps.alarms().size(), 1U);
}

TEST(PerceptionProcessing, ThePositionIsTheInverseVarianceMean) {
  PerceptionProcessing pps({}, flat_terrain());

  give(pps, seeing(look("marvin", "fire-sensor", 0), "fire", kFire + Vector3(10, 0, 3), 10));
  give(pps, seeing(look("marvin", "fire-sensor", 2), "fire", kFire + Vector3(0, 0, -2), 5));
  give(pps, seeing(look("marvin", "fire-sensor", 4), "fire", kFire, 5));

  ASSERT_EQ(pps.alarms().size(), 1U);
  const Alarm alarm = pps.alarms().front();
  const double weights = 0.01 + 0.04 + 0.04;
  EXPECT_NEAR(alarm.position.x(), kFire.x() + 10 * 0.01 / weights, 1e-9);
  EXPECT_NEAR(alarm.position_sigma, 1 / std::sqrt(weights), 1e-9);
  EXPECT_EQ(alarm.position.z(), 0) << "a fire is on the ground";
}

TEST(PerceptionProcessing, TheErrorOfThePositionIsAsLargeAsItSays) {
  double sum = 0;
  const int trials = 400;
  for (int trial = 0; trial < trials; ++trial) {
    Random random(static_cast<std::uint64_t>(trial));
    PerceptionProcessing pps({}, flat_terrain());
    for (int i = 0; i < 25; ++i) {
      const Vector3 noisy = kFire + 5 * Vector3(random.normal(), random.normal(), random.normal());
      give(pps, seeing(look("marvin", "fire-sensor", 2 * i), "fire", noisy));
    }
    const Alarm alarm = pps.alarms().front();
    sum += (alarm.position - kFire).head<2>().squaredNorm() /
           (2 * alarm.position_sigma * alarm.position_sigma);
  }

  EXPECT_NEAR(sum / trials, 1, 0.15);
}

TEST(PerceptionProcessing, TheRadiusExplainsTheScatterBeyondTheErrors) {
  Random random(3);
  PerceptionProcessing pps({}, flat_terrain());

  for (int i = 0; i < 600; ++i) {
    const double radius = 12 * std::sqrt(random.uniform());
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const Vector3 part = kFire + radius * Vector3(std::cos(angle), std::sin(angle), 0);
    const Vector3 noise = 4 * Vector3(random.normal(), random.normal(), 0);
    give(pps, seeing(look("marvin", "fire-sensor", 2 * i), "fire", part + noise, 4));
  }

  EXPECT_NEAR(pps.alarms().front().radius, 12, 2);
}

TEST(PerceptionProcessing, ViewsAreCountedBySide) {
  PerceptionProcessing pps({}, flat_terrain());
  Perception east = look("heliv", "visible", 0);
  Perception north = look("heliv", "visible", 2);
  north.viewpoint = kFire + Vector3(0, 30, 40);
  Perception south = look("heliv", "visible", 4);
  south.viewpoint = kFire + Vector3(-1, -30, 40);

  for (const Perception& p : {east, north, south}) give(pps, seeing(p, "fire"));

  const Alarm alarm = pps.alarms().front();
  EXPECT_EQ(alarm.views, 3U);
  EXPECT_EQ(alarm.views_by_bearing[0], 1U);
  EXPECT_EQ(alarm.views_by_bearing[3], 1U);
  EXPECT_EQ(alarm.views_by_bearing[8], 1U);
}

TEST(PerceptionProcessing, AnAlarmThatMovedIsToldAgain) {
  PpsConfig config;
  config.refine_distance = 6;
  PerceptionProcessing pps(config, flat_terrain());
  raise(pps);
  const Vector3 better = kFire + Vector3(8, 0, 0);

  const auto first = give(pps, seeing(look("heliv", "ir", 40), "fire", better, 2));
  const auto second = give(pps, seeing(look("heliv", "ir", 42), "fire", better, 2));

  EXPECT_EQ(first.size(), 1U) << "moved by 5.4 m";
  ASSERT_EQ(second.size(), 2U);
  EXPECT_GT(std::get<AlarmRefined>(second.back()).alarm.position.x(), kFire.x() + 6);
}

TEST(PerceptionProcessing, RandomFalseAlarmsOfAReliableSensorRaiseAlmostNothing) {
  Random random(11);
  PerceptionProcessing pps({}, flat_terrain());

  for (int i = 0; i < 5000; ++i) {
    Perception p = look("marvin", "fire-sensor", i, Vector3(i % 50 * 10.0, 0, 0));
    if (random.chance(0.01)) {
      const Vector3 error(random.uniform(-40, 40), random.uniform(-40, 40), 0);
      p = seeing(p, "fire", Vector3(i % 50 * 10.0, 0, 0) + error);
    }
    give(pps, p);
  }

  EXPECT_LE(pps.alarms().size(), 1U);
}

TEST(PerceptionProcessing, ContentThatIsNotFiniteIsDisregarded) {
  PerceptionProcessing pps({}, flat_terrain());
  const double nan = std::nan("");
  Perception odd = seeing(look("marvin", "fire-sensor", 1), "fire");
  odd.viewpoint.x() = nan;
  Perception no_direction = seeing(look("marvin", "fire-sensor", 2), "fire");
  no_direction.direction = Vector3::Zero();

  for (int i = 0; i < 10; ++i) {
    odd.at = no_direction.at = MissionTime::seconds(2 * i);
    give(pps, odd);
    give(pps, no_direction);
    give(pps, seeing(look("marvin", "fire-sensor", 2 * i), "fire", Vector3(nan, 0, 0)));
    give(pps, seeing(look("marvin", "fire-sensor", 2 * i), "fire", kFire, nan));
  }

  EXPECT_TRUE(pps.alarms().empty());
}

TEST(PerceptionProcessing, UnknownDevicesGiveNoEvidence) {
  PerceptionProcessing pps({}, flat_terrain());

  for (int i = 0; i < 20; ++i) give(pps, seeing(look("marvin", "sonar", 2 * i), "fire"));

  EXPECT_TRUE(pps.alarms().empty());
}

}  // namespace
}  // namespace skein::ground_station
