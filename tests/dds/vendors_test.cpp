// SPDX-License-Identifier: Apache-2.0
// Missions over Cyclone DDS, and with nodes on both vendors: everything is met as it is over Fast
// DDS.
#include <gmock/gmock.h>

#include <array>
#include <fstream>

#include "skein/blackboard/domain_lease.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Options = std::vector<std::string>;

const Options kAllOnCyclone{"--dds", "cyclonedds"};
// The ground on the one, the UAVs half and half, the simulator on the other.
const Options kGroundOnCyclone{"--dds", "ground=cyclonedds", "--dds", "heliv=cyclonedds"};
const Options kGroundOnFastDds{"--dds",          "cyclonedds", "--dds",
                               "ground=fastdds", "--dds",      "heliv=fastdds"};

void expect_comets_confirmed(DdsRun& run) {
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_THAT(run.output(), HasSubstr("20 of 20 expectations met"));
  EXPECT_EQ(run.count("process", "state", "ready"), 5U);
  EXPECT_EQ(run.count("process", "state", "exited"), 5U);
  EXPECT_EQ(run.count("dropped", "kind", "dropped"), 0U);
  EXPECT_TRUE(run.nothing_runs());
  EXPECT_THAT(run.left_in_shared_memory(), IsEmpty());
}

void expect_comets_confirmed_on(const Options& vendors) {
  DdsRun run;
  run.take_scenario("confirmed");
  Options options = vendors;
  options.insert(options.end(), {"--rate", "40"});

  run.start(options);

  expect_comets_confirmed(run);
}

TEST(DdsVendors, CometsWithEverybodyOnCyclone) { expect_comets_confirmed_on(kAllOnCyclone); }

TEST(DdsVendors, CometsWithTheGroundOnCycloneAndUavsHalfAndHalf) {
  expect_comets_confirmed_on(kGroundOnCyclone);
}

TEST(DdsVendors, CometsWithTheGroundOnFastDdsAndUavsHalfAndHalf) {
  expect_comets_confirmed_on(kGroundOnFastDds);
}

// Three cuts of the radio, in which orders and reports wait.
class CutRadio : public ::testing::TestWithParam<Options> {};

TEST_P(CutRadio, OrdersAndReportsArriveAfterIt) {
  DdsRun run;
  run.take_scenario_of("handover/cut");

  run.start(GetParam());
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_TRUE(run.nothing_runs());
}
std::string name_of_mix(const ::testing::TestParamInfo<Options>& mix) {
  constexpr std::array kNames{"AllOnCyclone", "GroundOnCyclone", "GroundOnFastDds"};
  return kNames.at(mix.index);
}
INSTANTIATE_TEST_SUITE_P(DdsVendors, CutRadio,
                         ::testing::Values(kAllOnCyclone, Options{"--dds", "ground=cyclonedds"},
                                           Options{"--dds", "cyclonedds", "--dds",
                                                   "ground=fastdds"}),
                         name_of_mix);

// Who of two vendors is there first is discovered by announcements, who comes second by answers.
class Discovery : public ::testing::TestWithParam<const char*> {
 protected:
  std::string domain() const { return std::to_string(lease_.domain()); }
  run_tool::Process start_marvin() {
    return run_tool::Process::start({kPrograms + "/skein-ddn", "--uav", "marvin", "--scenario",
                                     run.file("scenario.yaml").string(), "--domain", domain(),
                                     "--rate", "40", "--dds", GetParam()},
                                    run.file("marvin").string())
        .value();
  }
  /// How many programs listen in the domain, by the ports that its participants have.
  std::size_t listeners() const {
    const unsigned first = 7400 + 250 * lease_.domain() + 10;
    std::size_t found = 0;
    std::ifstream in("/proc/net/udp");
    for (std::string line; std::getline(in, line);) {
      const std::size_t colon = line.find(':', line.find(':') + 1);
      if (colon == std::string::npos) continue;
      const auto port = static_cast<unsigned>(std::strtoul(line.c_str() + colon + 1, nullptr, 16));
      found += port >= first && port < first + 64 && (port - first) % 2 == 0 ? 1 : 0;
    }
    return found;
  }
  /// The other four daemons and the runner; on the other vendor's, whoever marvin's is.
  void start_others() {
    const std::string other = GetParam() == std::string("fastdds") ? "cyclonedds" : "fastdds";
    run.start({"--rate", "40", "--domain", domain(), "--without", "marvin", "--dds", other});
  }

  DdsRun run;

 private:
  blackboard::DomainLease lease_ = blackboard::claim_domain().value();
};

TEST_P(Discovery, OneThatIsThereFirstIsFound) {
  run.take_scenario("confirmed");
  auto marvin = start_marvin();
  ASSERT_TRUE(holds_within(30, [&] { return listeners() == 1; }));

  start_others();
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
}

TEST_P(Discovery, OneThatComesLastIsFound) {
  run.take_scenario("confirmed");
  start_others();
  run.wait_until("four daemons and a runner", [&] { return listeners() == 5; });

  auto marvin = start_marvin();
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
}
std::string name_of_vendor(const ::testing::TestParamInfo<const char*>& vendor) {
  return vendor.param;
}
INSTANTIATE_TEST_SUITE_P(DdsVendors, Discovery, ::testing::Values("fastdds", "cyclonedds"),
                         name_of_vendor);

TEST(DdsVendors, AScenarioSaysWhoIsOnWhichAndSpyAndOperatorsMayBeOnEither) {
  DdsRun run;
  run.take_scenario("confirmed", "dds: {karma: cyclonedds}\n");
  run.start({"--rate", "10"});

  const Answered spied = run.skein({"spy", "--dds", "cyclonedds", "--duration", "2"});
  const Answered status = run.skein({"status", "--dds", "cyclonedds"});

  EXPECT_EQ(spied.code, 0) << spied.text;
  for (const char* node : {"ground", "karma", "marvin", "heliv", "sim"})
    EXPECT_THAT(spied.text, HasSubstr(node));
  EXPECT_EQ(status.code, 0) << status.text;
  EXPECT_THAT(status.text, HasSubstr("karma"));
  run.send(SIGINT);
  EXPECT_EQ(run.wait(30)->code, 130);
}

TEST(DdsVendors, KeysGoWithFastDdsOnly) {
  DdsRun run;
  run.take_scenario("confirmed");

  run.start({"--security", "keys", "--dds", "heliv=cyclonedds"});
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 2);
  EXPECT_THAT(run.output(),
              HasSubstr("--security needs Fast DDS in all nodes, and these are to use "
                        "another: heliv"));
}

TEST(DdsVendors, TypesAreAnnouncedByCycloneOnly) {
  DdsRun run;
  run.take_scenario("confirmed");

  run.start({"--types"});
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 2);
  EXPECT_THAT(run.output(), HasSubstr("--types needs a node on Cyclone DDS"));
}

TEST(DdsVendors, AVendorThatThereIsNotIsRefusedWithThoseThatThereAre) {
  DdsRun run;
  run.take_scenario("confirmed");

  run.start({"--dds", "marvin=cyclone"});
  const auto status = run.wait(30);

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 2);
  EXPECT_THAT(run.output(), HasSubstr("fastdds or cyclonedds, or NODE=WORD"));
}

}  // namespace
}  // namespace skein::testing
