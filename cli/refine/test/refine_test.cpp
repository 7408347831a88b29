// SPDX-License-Identifier: Apache-2.0
#include "skein/refine_tool/refine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "examples.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/geodata/raster_reader.hpp"
#include "testing/queries.hpp"

namespace skein::refine_tool {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Done {
  int code;
  std::string out, err;
};

/// `query` on standard input.
Done refine(const std::string& query, RefineOptions options = {}) {
  std::istringstream in(query);
  std::ostringstream out, err;
  if (options.query.empty() && options.example.empty()) options.query = "-";
  const int code = run_refine(options, in, out, err);
  return {code, out.str(), err.str()};
}

RefineOptions as_json() {
  RefineOptions options;
  options.json = true;
  return options;
}

class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("skein-refine-test-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return *this / name;
  }

 private:
  std::filesystem::path path_;
};

class Example : public ::testing::TestWithParam<std::string> {};

TEST_P(Example, RunsAsItIs) {
  RefineOptions options;
  options.example = GetParam();
  const Done printed = refine("", options);
  ASSERT_EQ(printed.code, kExitOk);

  const Done done = refine(printed.out, as_json());

  EXPECT_EQ(done.code, kExitOk) << done.out << done.err;
  const json answer = json::parse(done.out);
  EXPECT_EQ(answer["service"], GetParam());
  EXPECT_EQ(answer["feasible"], true);
  EXPECT_GE(answer["cost"].get<double>(), 0);
  EXPECT_TRUE(answer[GetParam()].is_object());
}

TEST_P(Example, GivesTheSameAnswerAndPictureAgain) {
  const Folder folder;
  RefineOptions first = as_json(), second = as_json();
  first.svg = folder / "a.svg";
  second.svg = folder / "b.svg";

  const Done a = refine(example_of(GetParam()), first), b = refine(example_of(GetParam()), second);

  const auto text = [](const std::string& file) {
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_EQ(a.out, b.out);
  EXPECT_EQ(text(first.svg), text(second.svg));
  EXPECT_THAT(text(first.svg), HasSubstr("</svg>"));
}

TEST_P(Example, IsToldToPeopleInText) {
  const Done done = refine(example_of(GetParam()));

  EXPECT_THAT(done.out, AllOf(HasSubstr(GetParam() + ": feasible"), HasSubstr("duration")));
}

INSTANTIATE_TEST_SUITE_P(Services, Example, ::testing::ValuesIn(service_names()));

TEST(Refine, HasTheTenServices) {
  EXPECT_THAT(service_names(),
              ElementsAre("path", "tour", "coverage", "partition", "patrol", "viewpoint",
                          "viewshed", "relay", "evaluate", "insertion"));
}

TEST(Refine, NoExampleOfAnUnknownService) {
  RefineOptions options;
  options.example = "patrl";

  const Done done = refine("", options);

  EXPECT_EQ(done.code, kExitBadInput);
  EXPECT_THAT(done.err, HasSubstr("did you mean 'patrol'"));
}

TEST(Refine, NoSolutionIsAnAnswerWithItsReason) {
  const std::string query =
      testing::query_text("path", R"("from": "pad", "to": [0, 0, 10])");  // inside the hill

  const Done text = refine(query), machine = refine(query, as_json());

  EXPECT_EQ(text.code, kExitNegative);
  EXPECT_THAT(text.out, AllOf(HasSubstr("path: no solution (blocked)"), HasSubstr("ground")));
  const json answer = json::parse(machine.out);
  EXPECT_EQ(answer["feasible"], false);
  EXPECT_EQ(answer["refusal"]["kind"], "blocked");
  EXPECT_EQ(answer["refusal"]["field"], "to");
}

TEST(Refine, ARefusalHasItsPictureToo) {
  const Folder folder;
  RefineOptions options;
  options.svg = folder / "no.svg";

  const Done done =
      refine(testing::query_text("path", R"("from": "pad", "to": [0, 0, 10])"), options);

  EXPECT_EQ(done.code, kExitNegative);
  EXPECT_TRUE(std::filesystem::exists(options.svg));
}

TEST(Refine, AQueryThatMakesNoSenseIsWrongInput) {
  const Done done =
      refine(testing::query_text("coverage", R"("area": "field", "swath": -5, "altitude": 60)"));

  EXPECT_EQ(done.code, kExitBadInput);
  EXPECT_THAT(done.out, AllOf(HasSubstr("bad-query"), HasSubstr("swath")));
}

TEST(Refine, APolygonThatCrossesItselfIsRefusedByItsCorners) {
  const Done done = refine(testing::query_text(
      "coverage",
      R"("area": [[0, 0], [100, 100], [100, 0], [0, 100]], "swath": 5, "altitude": 60)"));

  EXPECT_EQ(done.code, kExitBadInput);
  EXPECT_THAT(done.out, AllOf(HasSubstr("area"), HasSubstr("cross")));
}

TEST(Refine, WhatWasDoneToAQueryIsSaidInTextAndJson) {
  const std::string text = testing::query_text(
      "coverage",
      R"("area": [[0, 0], [800, 0], [800, 100], [0, 100]], "swath": 50, "altitude": 60)");

  EXPECT_THAT(refine(text).out, HasSubstr("300 m beyond the ground"));
  EXPECT_THAT(refine(text, as_json()).out,
              AllOf(HasSubstr("\"notes\""), HasSubstr("300 m beyond")));
}

TEST(Refine, AreasOfOtherProgramsAreReadAndAnswersWrittenForThem) {
  const Folder folder;
  folder.write("fields.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "north"}, "geometry": {"type": "Polygon",
     "coordinates": [[[-8, 40], [-7.998, 40], [-7.998, 40.002], [-8, 40.002], [-8, 40]],
       [[-7.9995, 40.0005], [-7.999, 40.0005], [-7.999, 40.001], [-7.9995, 40.0005]]]}},
    {"type": "Feature", "properties": {"name": "south"}, "geometry": {"type": "Polygon",
     "coordinates": [[[-8, 39.999], [-7.999, 39.999], [-7.999, 39.9995], [-8, 39.999]]]}}]})");
  const auto ask = [&](const std::string& area, const std::string& out) {
    RefineOptions options = as_json();
    options.query = folder.write("query.json", testing::query_text("coverage", R"("swath": 30,
      "altitude": 60, "area": )" + area));
    options.out = out.empty() ? "" : folder / out;
    return refine("", options);
  };

  const Done swept = ask(R"({"file": "fields.geojson", "name": "north"})", "way.geojson");
  const Done again = ask(R"({"file": "way.geojson"})", "way.wkt");
  const Done local = ask(R"({"file": "way.wkt"})", "");

  ASSERT_EQ(swept.code, kExitOk) << swept.err;
  ASSERT_EQ(again.code, kExitOk) << again.err;
  ASSERT_EQ(local.code, kExitOk) << local.err;
  EXPECT_NEAR(json::parse(again.out)["cost"].get<double>(),
              json::parse(local.out)["cost"].get<double>(), 0.1);
  EXPECT_THAT(ask(R"({"file": "fields.geojson"})", "").err,
              AllOf(HasSubstr("2 polygons"), HasSubstr("name: which")));
  EXPECT_THAT(ask(R"({"file": "fields.geojson", "name": "nort"})", "").err,
              HasSubstr("did you mean"));
  EXPECT_THAT(ask(R"({"file": "none.kml"})", "").err, HasSubstr("there is no such file"));
  EXPECT_EQ(ask(R"({"file": "way.wkt"})", "way.shp").code, kExitSystem);
}

TEST(Refine, AViewshedIsWrittenAsARasterThatIsReadAsGround) {
  const Folder folder;
  for (const char* ending : {"seen.tif", "seen.asc"}) {
    RefineOptions options = as_json();
    options.out = folder / ending;
    const Done done = refine(example_of("viewshed"), options);
    ASSERT_EQ(done.code, kExitOk) << done.err;
    const json view = json::parse(done.out)["viewshed"];
    std::size_t seen = 0;
    for (const std::string row : view["rows"])
      seen += static_cast<std::size_t>(std::count(row.begin(), row.end(), '#'));
    EXPECT_EQ(seen, view["seen"].get<std::size_t>());
    const world::Grid grid{view["west"], view["south"], view["cell"],
                           view["rows"][0].get<std::string>().size(), view["rows"].size()};

    const auto raster =
        geodata::read_risk(options.out, grid, {40.1094, -8.2361, 200}, {.no_data = 0, .crs = ""});

    ASSERT_TRUE(raster) << to_text(raster.error());
    const auto ones =
        std::count_if(raster->begin(), raster->end(), [](double v) { return v > 0.5; });
    EXPECT_EQ(static_cast<std::size_t>(ones), seen) << ending;
  }
  RefineOptions elsewhere;
  elsewhere.out = folder / "seen.png";
  EXPECT_EQ(refine(example_of("viewshed"), elsewhere).code, kExitSystem);
}

TEST_P(Example, CanBeWrittenForOtherPrograms) {
  const Folder folder;
  RefineOptions options;
  for (const char* ending : {".geojson", ".kml", ".wkt"}) {
    options.out = folder / (GetParam() + ending);
    EXPECT_EQ(refine(example_of(GetParam()), options).code, kExitOk);
    EXPECT_GT(std::filesystem::file_size(options.out), 50U) << options.out;
  }
}

TEST(Refine, TextThatIsNoQueryIsWrongInput) {
  const Done done = refine("{\"service\": \"path\"");

  EXPECT_EQ(done.code, kExitBadInput);
  EXPECT_THAT(done.err, HasSubstr("standard input:"));
  EXPECT_EQ(done.out, "");
}

TEST(Refine, AMissingQueryFileIsNamed) {
  RefineOptions options;
  options.query = "/nowhere/q.json";

  const Done done = refine("", options);

  EXPECT_EQ(done.code, kExitBadInput);
  EXPECT_THAT(done.err, HasSubstr("/nowhere/q.json: there is no such file"));
}

TEST(Refine, FilesOfAQueryAreNamedFromItsFolder) {
  const Folder folder;
  folder.write("world.yaml",
               "origin: {latitude: 40, longitude: -8, altitude: 0}\n"
               "terrain: {west: -500, south: -500, east: 500, north: 500}\n"
               "airspace: {floor: 0, ceiling: 100, voxel: 20}\n");
  RefineOptions options = as_json();
  options.query = folder.write(
      "q.json", R"({"service": "path", "world": "world.yaml", "vehicle": ")" +
                    std::string(SKEIN_SOURCE_DIR "/scenarios/comets/models/marvin.yaml") +
                    R"(", "from": [0, 0, 50], "to": [300, 400, 50]})");

  const Done done = refine("", options);

  // The folder of the query is put before an absolute name as well: std::filesystem keeps those.
  ASSERT_EQ(done.code, kExitOk) << done.err << done.out;
  EXPECT_NEAR(json::parse(done.out)["path"]["length"].get<double>(), 500, 0.01);
}

TEST(Refine, AMissingRasterIsNamedWithTheWorld) {
  const Folder folder;
  folder.write("world.yaml", "terrain: {raster: hills.tif}\n");
  RefineOptions options;
  options.query =
      folder.write("q.json", R"({"service": "relay", "world": "world.yaml", "a": [0, 0, 9]})");

  const Done done = refine("", options);

  EXPECT_EQ(done.code, kExitBadInput);
  EXPECT_THAT(done.err, AllOf(HasSubstr("world.yaml"), HasSubstr("hills.tif")));
}

TEST(Refine, ThePictureThatCannotBeWrittenIsAFailureOfTheSystem) {
  RefineOptions options;
  options.svg = "/nowhere/at/all.svg";

  const Done done = refine(example_of("relay"), options);

  EXPECT_EQ(done.code, kExitSystem);
  EXPECT_THAT(done.err, HasSubstr("/nowhere/at/all.svg: cannot be written"));
}

TEST(Refine, ATimeBudgetThatIsOverAtOnceIsToldAsSuch) {
  RefineOptions options;
  options.seconds = 1;
  double clock = 0;
  options.now = [&clock] { return clock += 10; };

  const Done done = refine(example_of("path"), options);

  EXPECT_EQ(done.code, kExitTimeout);
  EXPECT_THAT(done.out, HasSubstr("budget-exhausted"));
}

/// How often a query asks what time it is.
double looks_at_the_clock(const std::string& query) {
  RefineOptions options;
  double looks = 0;
  options.now = [&looks] { return ++looks * 1e-9; };
  EXPECT_EQ(refine(query, options).code, kExitOk);
  return looks;
}

/// A clock that goes on by so much whenever it is looked at.
std::function<double()> ticking(double seconds) {
  return [now = std::make_shared<double>(0), seconds] { return *now += seconds; };
}

nlohmann::json with_budget(const std::string& service, const nlohmann::json& budget) {
  nlohmann::json query = nlohmann::json::parse(example_of(service));
  query["budget"] = budget;
  return query;
}

TEST(Refine, APatrolWithoutABudgetHasOneAndSaysWhenThatEndedIt) {
  const std::string query = example_of("patrol");
  // The time is up shortly before it would have been done.
  const double tick = 20 / (0.9 * looks_at_the_clock(query));
  RefineOptions options;
  options.now = ticking(tick);

  const Done done = refine(query, options);

  ASSERT_EQ(done.code, kExitOk) << done.out;
  EXPECT_THAT(done.out, HasSubstr("the default budget of 20 s ended the search"));
  options.json = true;
  options.now = ticking(tick);
  const auto effort = nlohmann::json::parse(refine(query, options).out)["effort"];
  EXPECT_EQ(effort["cut_short"], true);
  EXPECT_EQ(effort["budget"], nlohmann::json({{"seconds", 20.0}, {"default", true}}));
}

TEST(Refine, APatrolThatAsksForNoBudgetOrForStepsHasNoClock) {
  RefineOptions options = as_json();
  for (const nlohmann::json& budget :
       {nlohmann::json("none"), nlohmann::json({{"steps", 1000000000}})}) {
    options.now = ticking(1000);
    const Done done = refine(with_budget("patrol", budget).dump(), options);
    ASSERT_EQ(done.code, kExitOk) << done.out;
    EXPECT_EQ(nlohmann::json::parse(done.out)["effort"]["cut_short"], false) << budget;
  }
  options.no_budget = true;
  options.now = ticking(1000);
  const Done done = refine(with_budget("patrol", {{"seconds", 1}}).dump(), options);
  ASSERT_EQ(done.code, kExitOk) << done.out;
  EXPECT_FALSE(nlohmann::json::parse(done.out)["effort"].contains("budget"));
}

TEST(Refine, OtherServicesHaveNoBudgetUnlessTheyAskForOne) {
  RefineOptions options = as_json();
  options.now = ticking(1000);

  EXPECT_EQ(refine(example_of("coverage"), options).code, kExitOk);
}

TEST(Refine, ABudgetIsAMapOrTheWordNone) {
  const Done done = refine(with_budget("path", "some").dump());

  EXPECT_EQ(done.code, kExitBadInput);
  EXPECT_THAT(done.err, AllOf(HasSubstr("budget"), HasSubstr("none")));
}

TEST(Refine, ColourOnlyWhereItIsAskedFor) {
  RefineOptions options;
  options.colour = true;

  EXPECT_THAT(refine(example_of("evaluate"), options).out, HasSubstr("\033[1;32mevaluate"));
  EXPECT_THAT(refine(example_of("evaluate")).out, ::testing::Not(HasSubstr("\033")));
}

// ---- shares as flown ----

/// Two alike that start beside each other share a square; parts take their area, twice as long to
/// the second.
json shared(const std::string& mode) {
  RefineOptions options = as_json();
  options.flown = [](const refiners::Member& member, double, const world::Polygon& part,
                     const std::shared_ptr<const world::World>&) {
    return std::optional(world::area(part) / 1000 * (member.uav == "second" ? 2 : 1));
  };
  const auto member = [](const std::string& name, const std::string& x) {
    return "\"" + name + "\": {" + testing::kVehicle + ", \"start\": [" + x +
           ", -300], \"altitude\": 80, \"swath\": 50}";
  };
  const std::string query = R"({"service": "partition", "area": "field", "apart": 0, "mode": ")" +
                            mode + "\", " + testing::kWorld + ", \"members\": {" +
                            member("first", "-200") + ", " + member("second", "200") + "}}";
  const Done done = refine(query, options);
  EXPECT_EQ(done.code, kExitOk) << done.err << done.out;
  return done.code == kExitOk ? json::parse(done.out) : json::object();
}

double share_of_first(const json& answer) {
  for (const json& part : answer.at("partition").at("parts"))
    if (part.at("uav") == "first") return part.at("share");
  return 0;
}

TEST(Partition, BalancedSharesAreAsTheyAreFlown) {
  EXPECT_NEAR(share_of_first(shared("balanced")), 2.0 / 3, 0.03);
}

TEST(Partition, SharesInProportionAreByArea) {
  EXPECT_NEAR(share_of_first(shared("proportional")), 0.5, 0.001);
}

}  // namespace
}  // namespace skein::refine_tool
