// SPDX-License-Identifier: Apache-2.0
// `skein model check` and `skein model draw`, on the models that are shipped and on wrong ones.
#include "skein/model_tool/model_files.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace skein::model_tool {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

const fs::path kModels = fs::path(SKEIN_SOURCE_DIR) / "scenarios/models/interaction";

struct Ran {
  int code = 0;
  std::string out, err;
};

Ran check(const std::vector<std::string>& files, bool json = false) {
  std::ostringstream out, err;
  const int code = check_models({files, json}, out, err);
  return {code, out.str(), err.str()};
}

/// Files in a folder of their own.
class ModelFiles : public ::testing::Test {
 protected:
  ModelFiles()
      : folder_(fs::path(::testing::TempDir()) /
                ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::create_directories(folder_);
  }
  ~ModelFiles() override { fs::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  fs::path folder_;
};

class ShippedModels : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedModels, AreRightByThemselves) {
  const Ran ran = check({(kModels / GetParam()).string()});

  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.code, 0);
}

TEST_P(ShippedModels, AreDrawn) {
  std::ostringstream out, err;

  EXPECT_EQ(draw_models({(kModels / GetParam()).string(), ""}, out, err), 0) << err.str();
  EXPECT_THAT(out.str(), AllOf(HasSubstr("<svg"), HasSubstr("</svg>")));
}

INSTANTIATE_TEST_SUITE_P(Files, ShippedModels,
                         ::testing::Values("monitoring-with-relay.yaml", "monitoring-around.yaml",
                                           "monitoring-by-chain.yaml",
                                           "monitoring-with-ground.yaml", "vehicle-pursuit.yaml",
                                           "cooperative-mapping.yaml", "roles/perceive.yaml",
                                           "roles/relay.yaml", "roles/pursue.yaml",
                                           "roles/observe.yaml", "roles/map.yaml",
                                           "roles/watch.yaml", "roles/link.yaml", "escorting.yaml",
                                           "roles/escort.yaml"));

/// Files that give the monitoring of the reference model another form, under the same name: a
/// scenario takes one of them.
const std::set<std::string> kOtherForms = {"monitoring-around.yaml", "monitoring-by-chain.yaml",
                                           "monitoring-with-ground.yaml", "escorting.yaml"};

TEST_F(ModelFiles, AllShippedFilesGoTogetherButForOtherFormsOfOneModelAndShareTheirRoles) {
  std::vector<std::string> files;
  for (const auto& one : fs::recursive_directory_iterator(kModels)) {
    if (one.path().extension() != ".yaml") continue;
    if (kOtherForms.count(one.path().filename()) == 0) files.push_back(one.path().string());
  }
  std::sort(files.begin(), files.end());

  const Ran ran = check(files, true);

  ASSERT_EQ(ran.code, 0) << ran.out;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json.at("roles").size(), 9U);
  EXPECT_EQ(json.at("models").size(), 3U);
  EXPECT_EQ(json.at("models").at("cooperative-mapping").size(), 2U);
}

TEST_F(ModelFiles, WhatIsUsedIsFoundBesideTheFileAndReadOnce) {
  write("b.yaml",
        "uses: [a.yaml]\nroles: {r: {automaton: {block: b, content: [{task: t, type: go}]}}}");
  const std::string a = write("a.yaml", "uses: [b.yaml, ./b.yaml]\ntasks: {go: {}}");

  EXPECT_EQ(check({a}).out, "1 roles, 0 SCMs, 0 models: right\n");
}

TEST_F(ModelFiles, ErrorsAreToldWithTheirFileAndPlace) {
  write("roles.yaml", "roles: {r: {automaton: {block: b, content: [{task: t, type: go}]}}}");
  const std::string file = write("model.yaml", "uses: [roles.yaml]\nmodel: {}\n");

  const Ran text = check({file});
  const Ran json = check({file}, true);

  EXPECT_EQ(text.code, 2);
  EXPECT_EQ(text.out, "");
  EXPECT_THAT(text.err,
              AllOf(HasSubstr("model.yaml:2:8: model: unknown key 'model'"),
                    HasSubstr("roles.yaml:1:61: roles.r.automaton.content[0].type: unknown "
                              "type of tasks 'go'")));
  EXPECT_EQ(json.code, 2);
  const auto errors = nlohmann::json::parse(json.out).at("errors");
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].at("line"), 2);
  EXPECT_EQ(errors[0].at("nearest"), "models");
}

TEST_F(ModelFiles, AFileThatIsNotThereIsTheOnlyErrorToldOfIt) {
  const std::string file = write(
      "m.yaml",
      "uses: [gone.yaml]\nroles: {r: {automaton: {block: b, content: [{task: t, type: go}]}}}");

  EXPECT_EQ(check({file}).err, (folder_ / "gone.yaml").string() + ": cannot be read\n");
}

TEST_F(ModelFiles, AnAutomatonIsCheckedAndDrawnByItself) {
  const std::string right =
      write("right.json", R"({"block":"b","content":[{"task":"t","type":"go"}]})");
  const std::string wrong =
      write("wrong.yaml", "{block: b, type: loop, content: [{task: t, type: go}]}");
  std::ostringstream out, err;

  EXPECT_THAT(check({right}).out, HasSubstr("right.json: 2 componels"));
  EXPECT_THAT(check({wrong}).err, HasSubstr("the loop 'b' has no way out"));
  EXPECT_EQ(draw_models({right, ""}, out, err), 0);
  EXPECT_EQ(draw_models({wrong, ""}, out, err), 2);
  EXPECT_EQ(draw_models({right, (folder_ / "no/where.svg").string()}, out, err), 3);
}

TEST_F(ModelFiles, WithoutModelsAndRolesThereIsNothingToDraw) {
  std::ostringstream out, err;

  EXPECT_EQ(draw_models({write("words.yaml", "tasks: {go: {}}"), ""}, out, err), 2);
  EXPECT_THAT(err.str(),
              HasSubstr("words.yaml: nothing to draw: no models, roles or automaton in it"));
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace skein::model_tool
