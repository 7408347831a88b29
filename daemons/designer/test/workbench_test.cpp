// SPDX-License-Identifier: Apache-2.0
#include "skein/designer/workbench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace skein::designer {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

constexpr const char* kModel = R"(# two of them
uses: [roles/look.yaml]
models:
  watch:
    variants:
      pair:
        parameters: {where: Point}
        roles: [look]
        coordination:
          arity: {look: 2}   # both
          scms:
            apart: {scm: apart, from: R*, least: 20}
          blocks:
            apart: {look: [b1]}
          parameters:
            look: {place: where}
)";
constexpr const char* kRole = R"(tasks:
  goto: {to: Point}
scms:
  apart:
    parameters: {from: Place, least: Number}
    constraints:
      - {distance-to: from, is: ">", than: least}
roles:
  look:
    needs: [hovering]
    parameters: {place: Point}
    automaton:
      block: b1
      content:
        # There at once.
        - {task: t1, type: goto, params: {to: place}}
)";

class AWorkbench : public ::testing::Test {
 protected:
  AWorkbench() {
    fs::create_directories(folder_ / "roles");
    write("watch.yaml", kModel);
    write("roles/look.yaml", kRole);
  }
  ~AWorkbench() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  static std::string content(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), {});
  }
  std::string read(const std::string& name) const { return content(path(name)); }

  /// What is said, with the status.
  std::pair<unsigned, Json> ask(const std::string& what, const Json& body) {
    const auto answer = bench().answer("POST", "/api/designer/" + what, body.dump());
    return {answer.status, Json::parse(answer.json)};
  }
  /// As the page does: what differs from the disk goes along the next time.
  Json look(const std::vector<Json>& edits = {}) {
    auto [status, said] = ask("look", {{"texts", texts}, {"edits", Json(edits)}});
    EXPECT_EQ(status, 200U) << said;
    for (const Json& file : said["files"]) {
      const std::string name = file["name"].get<std::string>();
      if (file["text"] != content(name)) texts[name] = file["text"];
    }
    return said;
  }
  Workbench& bench() {
    if (!bench_) bench_.emplace(std::vector<std::string>{path("watch.yaml")});
    return *bench_;
  }
  Json edit(const std::string& name, Json what) const {
    what["file"] = path(name);
    return what;
  }
  static Json file(const std::string& name, const Json& text, const Json& base) {
    return {{"name", name}, {"text", text}, {"base", base}};
  }

  Json texts = Json::object();

 private:
  fs::path folder_ = fs::temp_directory_path() / ("skein-workbench-" + std::to_string(getpid()));
  std::optional<Workbench> bench_;
};

const Json kPair = {"models", "watch", "variants", "pair"};

Json below(Json path, std::initializer_list<Json> steps) {
  for (const Json& step : steps) path.push_back(step);
  return path;
}

TEST_F(AWorkbench, ShowsAllThatIsUsedAndWhatTheCheckSays) {
  const Json said = look();

  ASSERT_EQ(said["files"].size(), 2U);
  EXPECT_EQ(said["files"][0]["name"], path("watch.yaml"));
  EXPECT_EQ(said["files"][1]["tree"]["roles"]["look"]["automaton"]["content"][0]["task"], "t1");
  EXPECT_EQ(said["check"]["right"], true) << said["check"];
}

TEST_F(AWorkbench, AnEditChangesTheTextAndTheCheckAndNotTheDisk) {
  const Json type{"roles", "look", "automaton", "content", 0, "type"};

  const Json said = look({edit("roles/look.yaml", {{"set", type}, {"value", "gotoo"}})});

  EXPECT_THAT(said["files"][1]["text"].get<std::string>(),
              HasSubstr("        # There at once.\n        - {task: t1, type: gotoo, "));
  EXPECT_EQ(said["check"]["right"], false);
  EXPECT_EQ(said["check"]["errors"][0]["nearest"], "goto");
  EXPECT_EQ(read("roles/look.yaml"), kRole);
}

TEST_F(AWorkbench, AnEditThatCannotBeMadeChangesNothingOfItsStep) {
  const Json said =
      look({edit("watch.yaml", {{"set", below(kPair, {"roles", 0})}, {"value", "see"}}),
            edit("watch.yaml", {{"remove", {"nothing"}}})});

  EXPECT_THAT(said["refused"].get<std::string>(), HasSubstr("there is no nothing"));
  EXPECT_EQ(said["files"][0]["text"], kModel);
}

TEST_F(AWorkbench, WhatIsTypedIsYaml) {
  const Json needs{"roles", "look", "needs"};

  const Json right =
      look({edit("roles/look.yaml", {{"insert", needs}, {"yaml", "{camera: visible}"}})});
  const Json wrong = look({edit("roles/look.yaml", {{"insert", needs}, {"yaml", "{camera"}})});

  EXPECT_THAT(right["files"][1]["text"].get<std::string>(),
              HasSubstr("needs: [hovering, {camera: visible}]\n"));
  EXPECT_THAT(wrong["refused"].get<std::string>(), HasSubstr("that is no YAML"));
}

TEST_F(AWorkbench, BrokenTextIsToldWithItsLineAndKept) {
  texts[path("watch.yaml")] = "uses: [roles/look.yaml]\nmodels: [\n";

  const Json said = look();

  EXPECT_EQ(said["files"][0]["tree"], nullptr);
  EXPECT_EQ(said["files"][0]["text"], texts[path("watch.yaml")]);
  EXPECT_EQ(said["check"]["right"], false);
  EXPECT_GE(said["check"]["errors"][0]["line"], 2);
}

TEST_F(AWorkbench, SavesWhatIsOnThePageAndKeepsTheOtherLines) {
  const Json arity = below(kPair, {"coordination", "arity", "look"});
  const Json said = look({edit("watch.yaml", {{"set", arity}, {"value", 3}})});
  const Json& now = said["files"][0];

  const auto [status, saved] =
      ask("save", {{"files", {file(path("watch.yaml"), now["text"], now["disk"])}}});

  EXPECT_EQ(status, 200U);
  std::string wanted = kModel;
  wanted.replace(wanted.find("look: 2"), 7, "look: 3");
  EXPECT_EQ(read("watch.yaml"), wanted);
  EXPECT_NE(saved["files"][path("watch.yaml")], now["disk"]);
}

TEST_F(AWorkbench, AFileThatSomebodyElseHasSavedIsNotWrittenOver) {
  const Json mine = look();
  write("watch.yaml", std::string(kModel) + "# theirs\n");

  const auto [status, said] =
      ask("save", {{"files",
                    {file(path("watch.yaml"), "mine", mine["files"][0]["disk"]),
                     file(path("roles/look.yaml"), "mine", mine["files"][1]["disk"])}}});

  EXPECT_EQ(status, 409U);
  EXPECT_EQ(said["conflicts"], Json::array({path("watch.yaml")}));
  EXPECT_EQ(read("watch.yaml"), std::string(kModel) + "# theirs\n");
  EXPECT_EQ(read("roles/look.yaml"), kRole) << "all or none";
}

TEST_F(AWorkbench, AFileThatIsNotThereYetIsMade) {
  texts[path("watch.yaml")] = "uses: [roles/look.yaml, new.yaml]\n";
  const Json said = look();
  ASSERT_EQ(said["files"].size(), 3U);

  const auto [status, saved] =
      ask("save", {{"files", {file(path("new.yaml"), "tasks: {}\n", "")}}});

  EXPECT_EQ(status, 200U);
  EXPECT_EQ(read("new.yaml"), "tasks: {}\n");
}

TEST_F(AWorkbench, TouchesNothingElseOnTheDisk) {
  for (const std::string& other :
       {std::string("/etc/passwd"), path("../other.yaml"), path("note.txt")}) {
    const auto [status, said] = ask("save", {{"files", {file(other, "x", "")}}});
    EXPECT_EQ(status, 403U) << other;
  }
  texts[path("watch.yaml")] = "uses: [/etc/hostname]\n";
  EXPECT_EQ(look()["files"].size(), 1U) << "what is elsewhere is not shown";
}

TEST_F(AWorkbench, ShowsWhereAnScmHolds) {
  Json grid{{"texts", Json::object()}, {"scm", "apart"}, {"numbers", {{"least", 15}}}};
  grid["places"]["from"] = Json::array({Json::array({0, 0, 0})});
  grid.update({{"west", -30}, {"south", -30}, {"step", 20}, {"columns", 3}, {"rows", 3}});

  const auto [status, said] = ask("scm", grid);

  EXPECT_EQ(status, 200U) << said;
  EXPECT_EQ(said["rows"], Json::array({"111", "101", "111"}));
}

TEST_F(AWorkbench, KnowsTheModelsOfAScenario) {
  write("scenario.yaml", "scenario: x\ninteraction: ../models/watch.yaml\n");
  write("none.yaml", "scenario: x\n");

  EXPECT_THAT(models_of(path("scenario.yaml")),
              ::testing::ElementsAre(HasSubstr("/models/watch.yaml")));
  EXPECT_THAT(models_of(path("none.yaml")), ::testing::IsEmpty());
}

struct Bad {
  const char* name;
  const char* what;
  std::string body;
};
class BadRequest : public AWorkbench, public ::testing::WithParamInterface<Bad> {};

TEST_P(BadRequest, IsRefusedAndHurtsNobody) {
  const auto answer =
      bench().answer("POST", std::string("/api/designer/") + GetParam().what, GetParam().body);

  EXPECT_EQ(answer.status, 400U) << answer.json;
  EXPECT_TRUE(Json::parse(answer.json).contains("problems"));
}

INSTANTIATE_TEST_SUITE_P(
    Workbench, BadRequest,
    ::testing::Values(Bad{"NoJson", "look", "{"}, Bad{"NoObject", "look", "[]"},
                      Bad{"Deep", "look", "{\"edits\":" + std::string(100'000, '[')},
                      Bad{"HalfAFile", "save", R"({"files":[{"name":"x"}]})"},
                      Bad{"HugeGrid", "scm", R"({"columns":1e9,"rows":1e9,"step":1})"},
                      Bad{"NoGrid", "scm", "{}"}),
    [](const auto& one) { return one.param.name; });

TEST_F(AWorkbench, RefusesWhatIsNestedTooDeeplyWhateverStandsBefore) {
  const std::string deep = std::string(300'000, '[') + std::string(300'000, ']');
  const std::string edit = R"({"file":")" + path("watch.yaml") + R"(","set":["x"],"value":)" + deep;
  for (const char* before : {"", R"("note":"\"",)", R"("note":"\\",)"}) {
    const std::string body = "{" + std::string(before) + R"("edits":[)" + edit + "}]}";
    EXPECT_EQ(bench().answer("POST", "/api/designer/look", body).status, 400U) << before;
  }
}

TEST_F(AWorkbench, WhatIsNoEditIsToldSo) {
  const std::string here = path("watch.yaml");
  for (const char* edit : {"3", R"({"file": 1, "set": []})", R"({"set": ["a"]})"}) {
    EXPECT_TRUE(look({Json::parse(edit)}).contains("refused")) << edit;
  }
  EXPECT_TRUE(look({Json{{"file", here}, {"set", "x"}}}).contains("refused"));
  const Json one{{"file", here}, {"remove", {"models"}}};
  EXPECT_TRUE(ask("look", {{"edits", one}}).second.contains("refused")) << "edits are a list";
}

}  // namespace
}  // namespace skein::designer
