// SPDX-License-Identifier: Apache-2.0
// `skein export` from its options to its file.
#include "skein/export_tool/export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/mcap/scan.hpp"
#include "temporary_folder.hpp"

namespace skein::export_tool {
namespace {

using ::testing::HasSubstr;

class Export : public ::testing::Test {
 protected:
  Export() {
    info_.scenario = "search";
    info_.epoch = "2026-01-01T00:00:00Z";
    info_.uavs = {{"marvin", "m", 3}};
    info_.origin = report::Origin{40, -8, 100};
    options_.folder = folder_.path().string();
    options_.mcap = (folder_.path() / "run.mcap").string();
  }
  void keep(const std::string& events) const {
    std::ofstream(folder_.path() / "events.jsonl") << events;
    std::ofstream(folder_.path() / "run.json") << report::to_json(info_);
  }
  int run() { return export_run(options_, out_, err_); }
  std::set<std::string> topics() const {
    std::ifstream in(options_.mcap, std::ios::binary);
    const std::string file{std::istreambuf_iterator<char>(in), {}};
    std::set<std::string> topics;
    const auto contents = mcap::scan(file, [&](const mcap::Channel& channel, const mcap::Message&) {
      topics.insert(channel.topic);
    });
    EXPECT_TRUE(contents.complete);
    return topics;
  }

  skein::testing::TemporaryFolder folder_;
  report::RunInfo info_;
  ExportOptions options_;
  std::ostringstream out_, err_;
};

const std::string kTelemetry =
    "{\"at\":1,\"node\":\"sim\",\"kind\":\"telemetry\",\"uav\":\"marvin\",\"position\":[10,20,30],"
    "\"velocity\":[1,0,0],\"heading\":0,\"energy\":0.9,\"airborne\":true}\n";

TEST_F(Export, WritesAFileWithMapAndRecords) {
  keep(kTelemetry);

  EXPECT_EQ(run(), kExitOk) << err_.str();

  EXPECT_THAT(topics(),
              ::testing::IsSupersetOf({"/marvin/location", "/marvin/telemetry", "/map/zones"}));
  EXPECT_THAT(out_.str(), HasSubstr("run.mcap: 3 messages"));
}

TEST_F(Export, OfARunThatIsNowhereOnEarthHasNoMapAndSaysSo) {
  info_.origin.reset();
  keep(kTelemetry);

  EXPECT_EQ(run(), kExitOk);

  EXPECT_EQ(topics(), std::set<std::string>{"/marvin/telemetry"});
  EXPECT_THAT(err_.str(), HasSubstr("no map"));
}

TEST_F(Export, OfALogThatWasCutOffWritesWhatThereIs) {
  keep(kTelemetry + "{\"at\":2,\"no");

  EXPECT_EQ(run(), kExitOk);
  EXPECT_THAT(err_.str(), HasSubstr("events.jsonl:2"));
}

TEST_F(Export, WritesTracksForMapsAndGpsPrograms) {
  keep(kTelemetry +
       "{\"at\":2,\"node\":\"sim\",\"kind\":\"telemetry\",\"uav\":\"marvin\","
       "\"position\":[20,20,30]}\n");
  options_.mcap.clear();
  options_.kml = (folder_.path() / "run.kml").string();
  options_.gpx = (folder_.path() / "run.gpx").string();
  options_.geoid = 50;

  EXPECT_EQ(run(), kExitOk) << err_.str();

  const auto text = [](const std::string& file) {
    std::ifstream in(file);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  EXPECT_THAT(text(options_.kml), HasSubstr("<name>marvin</name>"));
  EXPECT_THAT(text(options_.gpx), HasSubstr("<ele>80.000</ele><time>2026-01-01T00:00:01Z</time>"));
}

TEST_F(Export, OfARunThatIsNowhereOnEarthThereAreNoTracks) {
  info_.origin.reset();
  keep(kTelemetry);
  options_.gpx = (folder_.path() / "run.gpx").string();

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("no tracks"));
}

TEST_F(Export, WithoutAFileToWriteSaysWhichThereAre) {
  keep(kTelemetry);
  options_.mcap.clear();

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("--mcap, --kml, --gpx or --figures"));
}

TEST_F(Export, WritesTwoFiguresForAPaper) {
  keep(kTelemetry);
  options_.mcap.clear();
  options_.figures = (folder_.path() / "figures").string();

  EXPECT_EQ(run(), kExitOk) << err_.str();

  for (const char* name : {"trajectories.svg", "chronology.svg"}) {
    std::ifstream in(std::filesystem::path(options_.figures) / name);
    const std::string file{std::istreambuf_iterator<char>(in), {}};
    EXPECT_THAT(file, ::testing::StartsWith("<svg ")) << name;
    EXPECT_THAT(file, HasSubstr("marvin")) << name;
  }
}

TEST_F(Export, RefusesAFolderOfNoRun) {
  options_.folder = "/no/such/run";

  EXPECT_EQ(run(), kExitBadInput);
}

TEST_F(Export, SaysWhatItCannotWrite) {
  keep(kTelemetry);
  options_.mcap = "/no/such/folder/run.mcap";

  EXPECT_EQ(run(), kExitSystem);
  EXPECT_THAT(err_.str(), HasSubstr("cannot write"));
}

}  // namespace
}  // namespace skein::export_tool
