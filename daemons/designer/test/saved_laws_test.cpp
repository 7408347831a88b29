// SPDX-License-Identifier: Apache-2.0
// Whatever is changed in the models of the thesis: what the page was told is what `skein model
// check` says of the files that it saved.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/designer/workbench.hpp"
#include "skein/foundation/random.hpp"
#include "skein/model_tool/model_files.hpp"

namespace skein::designer {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The models of the repository in a folder of their own.
class Copied {
 public:
  Copied() {
    fs::remove_all(folder_);
    fs::copy(SKEIN_MODELS, folder_, fs::copy_options::recursive);
  }
  ~Copied() { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "monitoring-with-relay.yaml").string(); }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("skein-designer-" + std::to_string(getpid()));
};

struct Spot {
  std::string file;
  Json path;
  Json value;
};

void collect(const std::string& file, const Json& value, const Json& path,
             std::vector<Spot>& spots) {
  if (!path.empty()) spots.push_back({file, path, value});
  const auto below = [&](const Json& step, const Json& one) {
    Json next = path;
    next.push_back(step);
    collect(file, one, next, spots);
  };
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) below(i, value[i]);
  } else if (value.is_object()) {
    for (const auto& [key, one] : value.items()) {
      if (key != "\"") below(key, one);
    }
  }
}

/// What somebody may do with the mouse, sensible or not.
Json any_edit(Random& random, const Json& files) {
  std::vector<Spot> spots;
  for (const Json& file : files) {
    collect(file["name"].get<std::string>(), file["tree"], Json::array(), spots);
  }
  if (spots.empty()) return Json{{"file", ""}};
  const Spot& spot = spots[random.below(spots.size())];
  const Spot& other = spots[random.below(spots.size())];
  Json edit{{"file", spot.file}};
  switch (random.below(5)) {
    case 0:
      edit["remove"] = spot.path;
      break;
    case 1:
      edit["set"] = spot.path;
      edit["value"] = random.chance(0.5) ? other.value : Json("b12");
      break;
    case 2:
      edit["insert"] = spot.path;
      edit["index"] = random.below(4);
      if (spot.value.is_object()) edit["key"] = random.chance(0.5) ? "exit" : "anew";
      edit["value"] = other.value;
      break;
    case 3:
      edit["rename"] = spot.path;
      edit["key"] = "renamed";
      break;
    default:
      edit["move"] = spot.path;
      edit["into"] = other.path;
      edit["index"] = random.below(3);
  }
  return edit;
}

/// A page: the texts that it has, and what they were made of.
class Page {
 public:
  explicit Page(Workbench& bench) : bench_(bench) { look(Json::array()); }

  void look(const Json& edits) {
    said = ask("look", {{"texts", texts_}, {"edits", edits}}).second;
    for (const Json& file : said["files"]) {
      const std::string name = file["name"].get<std::string>();
      bases_.try_emplace(name, file["disk"].get<std::string>());
      texts_[name] = file["text"];
    }
  }
  unsigned save() {
    Json files = Json::array();
    for (const auto& [name, text] : texts_.items()) {
      files.push_back({{"name", name}, {"text", text}, {"base", bases_[name]}});
    }
    return ask("save", {{"files", files}}).first;
  }

  Json said;

 private:
  std::pair<unsigned, Json> ask(const std::string& what, const Json& body) {
    const auto answer = bench_.answer("POST", "/api/designer/" + what, body.dump());
    return {answer.status, Json::parse(answer.json)};
  }

  Workbench& bench_;
  Json texts_ = Json::object();
  std::map<std::string, std::string> bases_;
};

RC_GTEST_PROP(DesignerLaw, WhatItSaysOfTextsTheCheckSaysOfTheFiles, (std::uint32_t seed)) {
  Random random(seed);
  const Copied models;
  Workbench bench({models.file()});
  Page page(bench);
  RC_ASSERT(page.said["check"]["right"] == true);

  for (std::uint64_t left = random.below(8); left > 0; --left) {
    page.look(Json::array({any_edit(random, page.said["files"])}));
  }
  RC_ASSERT(page.save() == 200U);

  std::ostringstream out, err;
  (void)model_tool::check_models({{models.file()}, true}, out, err);
  const Json on_disk = Json::parse(out.str());
  RC_CLASSIFY(on_disk["right"] == true, "right");
  RC_ASSERT(on_disk == page.said["check"]);
}

}  // namespace
}  // namespace skein::designer
