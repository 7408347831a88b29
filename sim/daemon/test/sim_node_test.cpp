// SPDX-License-Identifier: Apache-2.0
#include "skein/sim_node/sim_node.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "skein/world/vehicle_model_reader.hpp"

namespace skein::sim {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

world::VehicleModel model_of(const std::string& name) {
  const std::string path = SKEIN_SOURCE_DIR "/scenarios/comets/models/" + name + ".yaml";
  std::ifstream in(path);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto model = world::read_vehicle_model(text, path);
  if (!model) ADD_FAILURE() << to_text(model.error());
  return model ? *model : world::VehicleModel();
}

SimulatorConfig a_config() {
  SimulatorConfig config{world::Terrain({-1000, -1000, 2000, 2000, 20, 0, {}, {}})};
  config.radio = {5000, true, Duration::milliseconds(20), 0.01, 0.05};
  config.vehicles.push_back({"marvin", model_of("marvin"), {0, 0}, 0, 1});
  config.vehicles.push_back({"heliv", model_of("heliv"), {50, 0}, 0, 1});
  return config;
}

/// The node of two helicopters on level ground.
class Rig {
 public:
  explicit Rig(std::vector<ScheduledFault> faults = {}, SimulatorConfig config = a_config())
      : node_("sim", std::move(config), roster_, std::move(faults)) {}

  void give(const node::Input& input, double seconds) {
    effects_ = node_.handle(input, at(seconds));
  }
  void from(const std::string& name, wire::Sample sample, double seconds) {
    give(node::Received{roster_.find(name)->number, std::move(sample)}, seconds);
  }
  void run_until(double seconds) { give(node::Wakeup{}, seconds); }
  /// Takes off and leaves the vehicle in the air.
  void take_off(const std::string& uav, double seconds) {
    wire::FunctionalRequest request;
    request.id = 1;
    request.type = "takeoff";
    request.parameters = {{"altitude", "", {30}}};
    from(uav, request, seconds);
  }

  /// "marvin 1 running", … of the last input.
  std::vector<std::string> statuses() const {
    std::vector<std::string> words;
    for (const auto& [to, status] : sent<wire::FunctionalStatus>()) {
      words.push_back(to + " " + std::to_string(status.id) + " " +
                      std::string(wire::name_of(status.state)));
    }
    return words;
  }
  template <class Sample>
  std::vector<std::pair<std::string, Sample>> sent() const {
    std::vector<std::pair<std::string, Sample>> sent;
    for (const node::Effect& effect : effects_) {
      const auto* send = std::get_if<node::Send>(&effect);
      if (send == nullptr) continue;
      if (const auto* sample = std::get_if<Sample>(&send->sample)) {
        sent.emplace_back(roster_.name_of(send->to), *sample);
      }
    }
    return sent;
  }
  template <class Sample>
  std::vector<Sample> published() const {
    std::vector<Sample> published;
    for (const node::Effect& effect : effects_) {
      const auto* publish = std::get_if<node::Publish>(&effect);
      if (publish == nullptr) continue;
      if (const auto* sample = std::get_if<Sample>(&publish->sample)) published.push_back(*sample);
    }
    return published;
  }
  std::vector<journal::Record> records(const std::string& kind) const {
    std::vector<journal::Record> found;
    for (const node::Effect& effect : effects_) {
      const auto* log = std::get_if<node::Log>(&effect);
      if (log != nullptr && log->record.kind() == kind) found.push_back(log->record);
    }
    return found;
  }
  SimNode& node() { return node_; }
  const node::Roster& roster() const { return roster_; }

 private:
  node::Roster roster_{{"marvin", "heliv"}};
  SimNode node_;
  node::Effects effects_;
};

// ---- what it says by itself ----

TEST(SimNode, TellsEachUavItsOwnTelemetryOnly) {
  Rig rig;

  rig.run_until(0);

  const auto telemetry = rig.sent<wire::Telemetry>();
  ASSERT_EQ(telemetry.size(), 2U);
  EXPECT_EQ(telemetry[0].first, "marvin");
  EXPECT_EQ(telemetry[0].second.uav, "marvin");
  EXPECT_EQ(telemetry[1].first, "heliv");
  EXPECT_EQ(telemetry[1].second.uav, "heliv");
  EXPECT_EQ(telemetry[1].second.position.x, 50);
}

TEST(SimNode, PublishesTheStateOfEveryDirectedLinkUnderAnInstanceOfItsOwn) {
  Rig rig;

  rig.run_until(0);

  const auto links = rig.published<wire::LinkState>();
  std::set<std::uint32_t> instances;
  for (const wire::LinkState& link : links) {
    EXPECT_TRUE(link.up);
    EXPECT_EQ(link.latency, 20'000'000);
    EXPECT_EQ(link.loss, 0.01);
    EXPECT_EQ(link.header.instance, link.from * 65536 + link.to);
    instances.insert(link.header.instance);
  }
  EXPECT_EQ(links.size(), 6U);  // three nodes on the radio, both ways
  EXPECT_EQ(instances.size(), 6U);
  EXPECT_EQ(rig.records("link").size(), 6U);
}

TEST(SimNode, PublishesGroundTruthAndLogsIt) {
  SimulatorConfig config = a_config();
  world::WorldObject fire;
  fire.name = "fire";
  fire.kind = "fire";
  fire.position = {100, 200};
  fire.radius = 5;
  config.objects.push_back(fire);
  Rig rig({}, config);

  rig.run_until(0);

  const auto truths = rig.published<wire::Truth>();
  std::set<std::uint32_t> instances;
  for (const wire::Truth& truth : truths) instances.insert(truth.header.instance);
  EXPECT_EQ(truths.size(), 3U);
  EXPECT_EQ(instances.size(), 3U);
  EXPECT_EQ(rig.records("telemetry").size(), 2U);
  ASSERT_EQ(rig.records("object").size(), 1U);
  EXPECT_EQ(rig.records("object")[0].numbers("position"), (std::vector<double>{100, 200, 0}));
  EXPECT_TRUE(rig.records("object")[0].truth("active"));
}

TEST(SimNode, AScriptedCutIsPublishedBothWaysAndHasNoLoss) {
  SimulatorConfig config = a_config();
  config.cuts.push_back({"ground", "heliv", at(5), at(8)});
  Rig rig({}, config);
  rig.run_until(0);

  rig.run_until(5);

  const auto links = rig.published<wire::LinkState>();
  ASSERT_EQ(links.size(), 2U);
  EXPECT_FALSE(links[0].up);
  EXPECT_FALSE(links[1].up);
  EXPECT_EQ(links[0].loss, 0);
  EXPECT_EQ(links[0].from, links[1].to);
  rig.run_until(8);
  ASSERT_EQ(rig.published<wire::LinkState>().size(), 2U);
  EXPECT_TRUE(rig.published<wire::LinkState>()[0].up);
}

TEST(SimNode, WantsToBeWokenForItsNextStep) {
  Rig rig;
  rig.run_until(0);

  ASSERT_TRUE(rig.node().next_wakeup().has_value());
  EXPECT_GT(*rig.node().next_wakeup(), at(0));
  EXPECT_LE(*rig.node().next_wakeup(), at(0.1));
}

// ---- requests ----

TEST(SimNode, CarriesOutARequestForTheVehicleOfItsSender) {
  Rig rig;
  rig.run_until(0);

  rig.take_off("heliv", 1);
  rig.run_until(60);

  EXPECT_THAT(rig.statuses(), ElementsAre("heliv 1 running", "heliv 1 ended"));
  EXPECT_TRUE(rig.sent<wire::Telemetry>().back().second.airborne);
  EXPECT_FALSE(rig.sent<wire::Telemetry>()[0].second.airborne);  // Marvin stays
}

// The name in the request is what its sender says; the vehicle is the sender's all the same.
TEST(SimNode, MovesNobodyElsesVehicle) {
  Rig rig;
  rig.run_until(0);
  wire::FunctionalRequest request;
  request.uav = "marvin";
  request.id = 1;
  request.type = "takeoff";
  request.parameters = {{"altitude", "", {30}}};

  rig.from("heliv", request, 1);
  rig.run_until(10);

  EXPECT_THAT(rig.statuses(), ElementsAre("heliv 1 running"));
}

TEST(SimNode, RejectsAnImpossibleRequestWithAReason) {
  Rig rig;
  rig.run_until(0);
  wire::FunctionalRequest request;
  request.id = 3;
  request.type = "teleport";

  rig.from("marvin", request, 1);

  EXPECT_THAT(rig.statuses(), ElementsAre("marvin 3 aborted"));
  EXPECT_FALSE(rig.sent<wire::FunctionalStatus>()[0].second.reason.empty());
}

TEST(SimNode, InterruptsWhatItIsToldTo) {
  Rig rig;
  rig.run_until(0);
  rig.take_off("marvin", 1);
  wire::FunctionalRequest interrupt;
  interrupt.kind = wire::FunctionalRequestKind::kInterrupt;
  interrupt.id = 1;

  rig.from("marvin", interrupt, 3);
  rig.run_until(60);

  EXPECT_THAT(rig.statuses(), Contains("marvin 1 aborted"));
}

// The second may be the ground's, through the decision node, after a change of degree.
TEST(SimNode, AnswersARequestThatItHasAlreadyWithoutDoingItTwice) {
  Rig rig;
  rig.run_until(0);
  rig.take_off("marvin", 1);

  rig.take_off("marvin", 20);
  EXPECT_THAT(rig.statuses(), Contains("marvin 1 ended"));
  rig.take_off("marvin", 30);

  EXPECT_THAT(rig.statuses(), ElementsAre("marvin 1 ended"));
}

TEST(SimNode, LogsOnceWhatTheFunctionalLayerBeganAndFinished) {
  Rig rig;
  rig.run_until(0);
  rig.take_off("marvin", 1);
  rig.run_until(20);
  wire::FunctionalRequest look;
  look.id = 2;
  look.type = "takeshot";
  look.parameters = {{"device", "visible", {}}, {"target", "", {30, 0, 0}}};
  rig.from("marvin", look, 20.1);
  ASSERT_EQ(rig.records("functional").size(), 1U);
  const journal::Record began = rig.records("functional")[0];
  rig.from("marvin", look, 20.2);
  EXPECT_THAT(rig.records("functional"), IsEmpty());

  EXPECT_EQ(began.text("uav"), "marvin");
  EXPECT_EQ(began.number("task"), 2);
  EXPECT_EQ(began.text("type"), "takeshot");
  EXPECT_EQ(began.text("state"), "running");
  EXPECT_EQ(began.text("device"), "visible");
  EXPECT_THAT(began.numbers("target"), ElementsAre(30, 0, 0));
}

TEST(SimNode, LogsWhyTheFunctionalLayerRefused) {
  Rig rig;
  rig.run_until(0);
  wire::FunctionalRequest request;
  request.id = 3;
  request.type = "teleport";

  rig.from("marvin", request, 1);

  ASSERT_EQ(rig.records("functional").size(), 1U);
  EXPECT_EQ(rig.records("functional")[0].text("state"), "aborted");
  EXPECT_FALSE(rig.records("functional")[0].text("reason").empty());
}

class Unrelated : public ::testing::TestWithParam<wire::Sample> {};

TEST_P(Unrelated, SamplesChangeNothing) {
  Rig rig;
  rig.run_until(0);

  rig.from("marvin", GetParam(), 0.01);

  EXPECT_THAT(rig.statuses(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(SimNode, Unrelated,
                         ::testing::Values(wire::TaskRequest{}, wire::SyncMessage{},
                                           wire::Telemetry{}, wire::Alarm{}),
                         [](const auto& one) {
                           return std::string(wire::slot_name(wire::slot_of(one.param)));
                         });

TEST(SimNode, ARequestOfAStrangerMovesNothing) {
  Rig rig;
  rig.run_until(0);
  wire::FunctionalRequest request;
  request.id = 1;
  request.type = "takeoff";

  rig.give(node::Received{node::NodeNumber(77), request}, 1);
  EXPECT_THAT(rig.statuses(), IsEmpty());
  rig.from("ground", request, 2);
  EXPECT_THAT(rig.statuses(), IsEmpty());
}

// ---- the silence of a decision node ----

TEST(SimNode, AVehicleWhoseDecisionNodeForgotItsTasksGivesThemUp) {
  Rig rig;
  rig.run_until(0);
  rig.take_off("marvin", 1);
  rig.run_until(3);

  rig.give(node::Reachability{rig.roster().find("marvin")->number, true, true}, 3.05);
  std::vector<std::string> words = rig.statuses();
  rig.run_until(60);
  const std::vector<std::string> later = rig.statuses();
  words.insert(words.end(), later.begin(), later.end());

  EXPECT_THAT(words, Contains("marvin 1 aborted"));
}

TEST(SimNode, AVehicleWhoseDecisionNodeIsSilentForAWhileGoesOn) {
  Rig rig;
  rig.run_until(0);
  rig.take_off("marvin", 1);
  rig.run_until(3);

  rig.give(node::Reachability{rig.roster().find("marvin")->number, false, false}, 3.05);
  rig.run_until(60);

  EXPECT_THAT(rig.statuses(), Contains("marvin 1 ended"));
}

TEST(SimNode, TheSilenceOfAStrangerIsHarmless) {
  Rig rig;
  rig.run_until(0);

  rig.give(node::Reachability{node::NodeNumber(77), false, false}, 1);

  EXPECT_THAT(rig.statuses(), IsEmpty());
}

// ---- faults on board ----

TEST(SimNode, PlaysFaultsAtTheirInstantAndLogsThem) {
  Rig rig({{at(20), {"marvin", FaultKind::kEngine, ""}},
           {at(30), {"heliv", FaultKind::kSensor, "visible"}}});
  rig.run_until(0);
  rig.take_off("marvin", 1);
  rig.run_until(19.9);
  EXPECT_THAT(rig.records("fault"), IsEmpty());
  EXPECT_LE(*rig.node().next_wakeup(), at(20));

  rig.run_until(20);
  ASSERT_EQ(rig.records("fault").size(), 1U);
  EXPECT_EQ(rig.records("fault")[0].text("what"), "engine");
  EXPECT_EQ(rig.records("fault")[0].text("target"), "marvin");
  EXPECT_EQ(rig.records("fault")[0].at(), at(20));

  rig.run_until(40);
  ASSERT_EQ(rig.records("fault").size(), 1U);
  EXPECT_EQ(rig.records("fault")[0].text("what"), "sensor visible");
  EXPECT_EQ(rig.records("fault")[0].at(), at(30));
}

TEST(SimNode, EveryFaultHasANameInTheLog) {
  Fault abort{"marvin", FaultKind::kAbort};
  abort.type = "takeshot";
  Fault energy{"marvin", FaultKind::kEnergy};
  energy.left = 0.5;
  Rig rig({{at(1), {"marvin", FaultKind::kSlow}}, {at(2), abort}, {at(3), energy}});

  rig.run_until(4);

  std::vector<std::string> names;
  for (const journal::Record& record : rig.records("fault")) {
    names.emplace_back(record.text("what"));
  }
  EXPECT_THAT(names, ElementsAre("slow", "abort takeshot", "energy"));
}

TEST(SimNode, TellsADecisionNodeWhatDoesNotWork) {
  Rig rig({{at(1), {"heliv", FaultKind::kSensor, "visible"}}});

  rig.run_until(1);
  rig.run_until(2);

  const auto telemetry = rig.sent<wire::Telemetry>();
  EXPECT_THAT(telemetry[telemetry.size() - 2].second.failed, IsEmpty());
  EXPECT_THAT(telemetry.back().second.failed, ElementsAre("visible"));
}

// ---- a life that forgot ----

TEST(SimNode, BornAgainItsVehiclesAreWhereTheyAreAndItKnowsNoTask) {
  Rig rig;
  rig.give(node::Started{1, true}, 0);
  rig.take_off("marvin", 1);
  rig.run_until(4);
  const double height = rig.sent<wire::Telemetry>().front().second.position.z;
  ASSERT_GT(height, 0.5);

  rig.give(node::Started{2}, 4.5);

  EXPECT_THAT(rig.statuses(), IsEmpty());
  const auto told = rig.records("functional");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].text("state"), "aborted");
  EXPECT_EQ(told[0].text("reason"), "the functional layer has forgotten it");
  rig.run_until(20);
  const auto told_of_both = rig.sent<wire::Telemetry>();
  EXPECT_GT(told_of_both.at(told_of_both.size() - 2).second.position.z, 0.5);
  wire::FunctionalRequest request;
  request.kind = wire::FunctionalRequestKind::kInterrupt;
  request.id = 1;
  rig.from("marvin", request, 21);
  EXPECT_THAT(rig.statuses(), ElementsAre("marvin 1 aborted"));
}

TEST(SimNode, WhatEndedWhileItWasDeadNobodyIsTold) {
  Rig rig;
  rig.give(node::Started{1, true}, 0);
  rig.take_off("marvin", 1);

  rig.give(node::Started{2}, 60);

  EXPECT_THAT(rig.statuses(), IsEmpty());
  EXPECT_EQ(rig.records("functional").back().text("state"), "ended");
}

}  // namespace
}  // namespace skein::sim
