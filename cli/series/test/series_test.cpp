// SPDX-License-Identifier: Apache-2.0
// `skein series` from its options to its CSV.
#include "skein/series_tool/series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/journal/record.hpp"
#include "skein/report/run_info.hpp"
#include "temporary_folder.hpp"

namespace skein::series_tool {
namespace {

using journal::Record;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Record telemetry(double at, const std::string& uav, double x, double z = 30) {
  return Record(MissionTime::seconds(at), "sim", "telemetry")
      .with("uav", uav)
      .with("position", std::vector<double>{x, 0, z})
      .with("velocity", std::vector<double>{0, 0, 0})
      .with("energy", 1 - at / 100)
      .with("airborne", z > 1);
}

/// The folder of a run of two UAVs.
class Kept {
 public:
  explicit Kept(const std::vector<Record>& records) {
    std::ofstream events(folder_.path() / "events.jsonl");
    for (const Record& record : records) events << journal::to_json(record) << '\n';
    report::RunInfo info;
    info.scenario = "search";
    info.epoch = "2026-01-01T00:00:00Z";
    info.uavs = {{"marvin", "m", 3}, {"heliv", "h", 3}};
    std::ofstream(folder_.path() / "run.json") << report::to_json(info);
  }
  std::string path() const { return folder_.path().string(); }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

 private:
  skein::testing::TemporaryFolder folder_;
};

class Series : public ::testing::Test {
 protected:
  Series() { options_.folder = kept_.path(); }
  int run() {
    out_.str("");
    err_.str("");
    return series(options_, out_, err_);
  }

  Kept kept_{{telemetry(1, "marvin", 10), telemetry(1, "heliv", 40), telemetry(2, "marvin", 20),
              telemetry(3, "marvin", 30, 0)}};
  SeriesOptions options_;
  std::ostringstream out_, err_;
};

TEST_F(Series, HoldsWhatWasSaidLastAndLeavesOutWhatIsNotKnownYet) {
  options_.of = {"x,energy"};
  options_.uavs = {"marvin"};

  EXPECT_EQ(run(), kExitOk) << err_.str();

  EXPECT_EQ(out_.str(), "time,x marvin,energy marvin\n0,,\n1,10,0.99\n2,20,0.98\n3,30,0.97\n");
}

TEST_F(Series, HasALineForEachInstantAskedFor) {
  options_.of = {"x"};
  options_.every = 0.5;

  run();

  EXPECT_THAT(out_.str(), StartsWith("time,x marvin,x heliv\n0,,\n0.5,,\n1,10,40\n1.5,10,40\n"));
}

TEST_F(Series, TellsDistancesOfTwoAndTheLeastInTheAir) {
  options_.of = {"distance", "least-distance"};

  run();

  EXPECT_EQ(out_.str(),
            "time,distance marvin heliv,least-distance\n0,,\n1,30,30\n2,20,20\n"
            "3,31.622776601683796,\n");
}

TEST_F(Series, WithoutQuantitiesTellsPlacesAndEnergy) {
  run();

  EXPECT_THAT(out_.str(), StartsWith("time,x marvin,x heliv,y marvin,y heliv,z marvin,"));
}

TEST_F(Series, WritesAFileOrSaysThatItCannot) {
  options_.csv = kept_.file("x.csv");
  EXPECT_EQ(run(), kExitOk);
  EXPECT_EQ(out_.str(), "");

  options_.csv = "/no/such/folder/x.csv";
  EXPECT_EQ(run(), kExitSystem);
  EXPECT_THAT(err_.str(), HasSubstr("cannot be written"));
}

TEST_F(Series, RefusesWrongNamesAllAtOnceWithTheNearest) {
  options_.of = {"enrgy", "distanc"};
  options_.uavs = {"marvn"};

  EXPECT_EQ(run(), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("did you mean 'energy'?"));
  EXPECT_THAT(err_.str(), HasSubstr("did you mean 'distance'?"));
  EXPECT_THAT(err_.str(), HasSubstr("did you mean 'marvin'?"));
}

TEST_F(Series, RefusesWhatWouldNotEnd) {
  options_.every = 1e-12;

  EXPECT_EQ(run(), kExitBadInput);
}

TEST_F(Series, ListsEveryQuantityItHas) {
  options_.list = true;
  run();
  std::istringstream lines(out_.str());
  options_.list = false;
  for (std::string line; std::getline(lines, line);) {
    options_.of = {line.substr(0, line.find_first_of(" :"))};
    EXPECT_EQ(run(), kExitOk) << line << err_.str();
  }
}

TEST_F(Series, TellsMeasuresOfTheWholeRun) {
  options_.measures = true;

  EXPECT_EQ(run(), kExitOk);

  EXPECT_THAT(out_.str(), HasSubstr("minimum-separation,30,m\n"));
  EXPECT_THAT(out_.str(), HasSubstr("mission-duration,,s\n"));
}

TEST_F(Series, OfALogThatWasCutOffTellsWhatThereIs) {
  std::ofstream(kept_.file("events.jsonl"), std::ios::app) << "{\"at\": 4, \"no";

  EXPECT_EQ(run(), kExitOk);
  EXPECT_THAT(err_.str(), HasSubstr("events.jsonl:5"));
}

// Whatever the step, a line holds what the last record at or before it said.
RC_GTEST_PROP(SeriesOfAnyStep, HoldsTheLastRecord, ()) {
  const auto steps =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 40)));
  std::vector<Record> records;
  double at = 0;
  for (const int step : steps) {
    at += step * 0.25;
    records.push_back(telemetry(at, "marvin", at));
  }
  const Kept kept(records);
  SeriesOptions options;
  options.folder = kept.path();
  options.of = {"x"};
  options.uavs = {"marvin"};
  options.every = *rc::gen::inRange(1, 30) * 0.25;
  std::ostringstream out, err;

  RC_ASSERT(series(options, out, err) == kExitOk);

  std::istringstream lines(out.str());
  std::string text;
  std::getline(lines, text);
  while (std::getline(lines, text)) {
    const std::size_t comma = text.find(',');
    const double time = std::stod(text.substr(0, comma));
    double expected = -1;
    for (const Record& record : records)
      if (record.numbers("position")[0] <= time) expected = record.numbers("position")[0];
    const std::string seen = text.substr(comma + 1);
    RC_ASSERT((seen.empty() ? -1 : std::stod(seen)) == expected);
  }
}

}  // namespace
}  // namespace skein::series_tool
