// SPDX-License-Identifier: Apache-2.0
// The simulator keeps the contract of a functional layer, and each way of breaking it is seen.
#include "skein/conformance/conformance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include "skein/sim/simulator.hpp"
#include "skein/world/vehicle_model_reader.hpp"

namespace skein::conformance {
namespace {

using functional::Request;
using functional::Status;
using functional::TaskState;
using functional::Verb;
using ::testing::Contains;
using ::testing::HasSubstr;

world::VehicleModel model_of(const std::string& name) {
  const std::string path = SKEIN_SOURCE_DIR "/scenarios/comets/models/" + name + ".yaml";
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return world::read_vehicle_model(text.str(), path).value();
}

/// Between the check and the simulator: what goes in and what comes out may be spoilt.
struct Spoilt {
  std::function<std::vector<Request>(const Request&)> in = [](const Request& it) {
    return std::vector<Request>{it};
  };
  std::function<std::vector<Status>(const Status&)> out = [](const Status& it) {
    return std::vector<Status>{it};
  };
  bool forgets = true;  ///< when it is restarted
  std::function<bool(const world::Telemetry&)> tells = [](const world::Telemetry&) { return true; };
};

class Bench {
 public:
  Bench(const std::string& vehicle, Spoilt spoilt)
      : model_(model_of(vehicle)),
        spoilt_(std::move(spoilt)),
        simulator_(world_with(model_)),
        check_(config_for(model_)) {}

  std::vector<Verdict> run() {
    for (int tenths = 0; tenths < 40'000 && !check_.done(); ++tenths) {
      now_ = MissionTime::seconds(tenths / 10.0);
      take(simulator_.handle(sim::Tick{}, now_));
      const auto wakeup = check_.next_wakeup();
      if (wakeup && *wakeup <= now_) give(Tick{});
      if (check_.wants_restart()) restart();
    }
    EXPECT_TRUE(check_.done());
    return check_.verdicts();
  }

 private:
  void restart() {
    if (spoilt_.forgets) (void)simulator_.handle(sim::LayerForgot{}, now_);
    give(Restarted{});
  }
  static sim::SimulatorConfig world_with(const world::VehicleModel& model) {
    world::TerrainSpec spec;
    spec.west = spec.south = -2000;
    spec.east = spec.north = 2000;
    sim::SimulatorConfig config{world::Terrain(spec)};
    config.radio = {5000, true, Duration::milliseconds(20), 0, 0.05};
    config.ground_station = {0, 0, 3};
    config.vehicles.push_back({"uav", model});
    return config;
  }
  static Config config_for(const world::VehicleModel& model) {
    Config config;
    config.hovers = model.hovers;
    config.restart_within = Duration::seconds(60);
    config.near = model.hovers ? 10 : 40;
    config.device = model.sensors.empty() ? "" : model.sensors.front().device;
    return config;
  }
  void give(const Input& input) {
    for (const Request& asked : check_.handle(input, now_)) {
      for (const Request& one : spoilt_.in(asked)) {
        take(simulator_.handle(sim::FunctionalRequest{"uav", one}, now_));
      }
    }
  }
  void take(const std::vector<sim::Effect>& effects) {
    for (const sim::Effect& effect : effects) {
      if (const auto* told = std::get_if<sim::FunctionalStatus>(&effect)) {
        for (const Status& one : spoilt_.out(told->status)) give(one);
      } else if (const auto* telemetry = std::get_if<sim::Telemetry>(&effect)) {
        if (spoilt_.tells(*telemetry)) give(*telemetry);
      } else if (const auto* look = std::get_if<sim::PerceptionOut>(&effect)) {
        give(look->perception);
      }
    }
  }

  world::VehicleModel model_;
  Spoilt spoilt_;
  sim::Simulator simulator_;
  Conformance check_;
  MissionTime now_;
};

/// "point: what was seen", of what is not kept.
std::vector<std::string> broken(const std::string& vehicle, Spoilt spoilt = {}) {
  std::vector<std::string> points;
  for (const Verdict& one : Bench(vehicle, std::move(spoilt)).run()) {
    if (!one.kept) points.push_back(one.point + ": " + one.seen);
  }
  return points;
}

/// The task that runs when the layer is restarted, as the check numbers them.
constexpr std::uint64_t kWaitAtRestart = 10;

class EveryVehicle : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryVehicle, OfTheSimulatorKeepsEveryPoint) {
  EXPECT_THAT(broken(GetParam()), ::testing::IsEmpty());
  EXPECT_GE(Bench(GetParam(), {}).run().size(), 21U);
}

INSTANTIATE_TEST_SUITE_P(Conformance, EveryVehicle, ::testing::Values("marvin", "heliv", "karma"),
                         [](const auto& one) { return one.param; });

TEST(Conformance, ALayerThatNeverAnswersKeepsNothingButItsTelemetry) {
  Spoilt deaf;
  deaf.in = [](const Request&) { return std::vector<Request>(); };

  const auto points = broken("marvin", deaf);

  EXPECT_THAT(points, Contains("an unknown type is refused with a reason: no answer"));
  EXPECT_THAT(points, Contains("a takeoff runs, ends, and leaves it in the air: no answer"));
  EXPECT_THAT(points, Contains("a way is flown to its end: it is not in the air"));
}

// The vehicle goes on with what nobody knows of any more, and takes nothing else.
TEST(Conformance, ALayerWhoseVehicleIsStillHeldByAForgottenTaskIsSeen) {
  Spoilt held;
  held.forgets = false;
  std::set<functional::TaskId> waits;
  held.in = [&waits](Request it) {
    const bool again = it.type == "wait" && !waits.insert(it.id).second;
    if (again) it.id = functional::TaskId(9999);
    return std::vector<Request>{it};
  };
  held.out = [](Status it) {
    if (it.id == functional::TaskId(9999)) it.id = functional::TaskId(kWaitAtRestart);
    return std::vector<Status>{it};
  };

  EXPECT_THAT(broken("marvin", held),
              Contains(HasSubstr("may be asked for again, and begins: aborted")));
}

TEST(Conformance, ARefusalWithoutAReasonIsSeen) {
  Spoilt silent;
  silent.out = [](Status it) {
    it.reason.clear();
    return std::vector<Status>{it};
  };

  EXPECT_THAT(broken("marvin", silent),
              Contains("an unknown type is refused with a reason: aborted without a reason"));
}

TEST(Conformance, ALayerThatDoesATaskAgainIsSeen) {
  Spoilt forgetful;
  std::set<functional::TaskId> had;
  forgetful.in = [&had](Request it) {
    if (it.verb == Verb::kDispatch && !had.insert(it.id).second) {
      it.id = functional::TaskId(it.id.value() + 1000);
    }
    return std::vector<Request>{it};
  };
  forgetful.out = [](Status it) {
    if (it.id.value() > 1000) it.id = functional::TaskId(it.id.value() - 1000);
    return std::vector<Status>{it};
  };

  EXPECT_THAT(broken("marvin", forgetful),
              Contains(HasSubstr("a task that comes again is answered, not done again: aborted")));
}

TEST(Conformance, ALayerThatNeverTellsTheEndIsSeen) {
  Spoilt endless;
  endless.out = [](const Status& it) {
    return it.state == TaskState::kEnded ? std::vector<Status>() : std::vector<Status>{it};
  };

  EXPECT_THAT(broken("marvin", endless),
              Contains(HasSubstr("a takeoff runs, ends, and leaves it in the air: after running")));
}

TEST(Conformance, ALayerThatDoesNotStopIsSeen) {
  Spoilt stubborn;
  stubborn.in = [](const Request& it) {
    return it.verb == Verb::kInterrupt && it.id.value() > 4 ? std::vector<Request>()
                                                            : std::vector<Request>{it};
  };

  EXPECT_THAT(
      broken("marvin", stubborn),
      Contains(HasSubstr("an interrupted way is aborted, and it stays where it is: ended")));
}

TEST(Conformance, TwoMotionsAtOnceAreSeen) {
  Spoilt willing;
  willing.out = [](Status it) {
    if (it.reason.find("still active") != std::string::npos) it.state = TaskState::kRunning;
    return std::vector<Status>{it};
  };

  EXPECT_THAT(broken("marvin", willing),
              Contains("a second motion is refused while one is active: running"));
}

TEST(Conformance, RareTelemetryIsSeen) {
  Spoilt rare;
  rare.tells = [](const world::Telemetry& it) { return it.at.count() % 3'000'000'000 == 0; };

  EXPECT_THAT(broken("marvin", rare), Contains(HasSubstr("s without telemetry")));
}

TEST(Conformance, AnEnergyThatIsNoneIsSeen) {
  // The sample is judged as it came: here the model's capacity is not asked for.
  Config config;
  Conformance check(config);
  world::Telemetry wrong;
  wrong.state.energy = 55;
  for (int second = 0; second < 3; ++second) {
    wrong.at = MissionTime::seconds(second);
    check.handle(wrong, wrong.at);
  }

  ASSERT_EQ(check.verdicts().size(), 1U);
  EXPECT_EQ(check.verdicts()[0].seen, "an energy that is not within 0 and 1");
}

}  // namespace
}  // namespace skein::conformance
