// SPDX-License-Identifier: Apache-2.0
// Whatever the designer's page or another program posts is answered, with JSON; and no file changes
// outside the folder that is edited. The first byte says which question is asked; @ stands for the
// folder.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "skein/designer/workbench.hpp"
#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;

void require(bool condition) {
  if (!condition) std::abort();
}

constexpr const char* kModel = R"(uses: [roles/look.yaml]
models:
  watch:
    variants:
      pair:
        parameters: {where: Point}
        roles: [look]
        coordination:
          arity: {look: 2}
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
        - {task: t1, type: goto, params: {to: place}}
)";

/// A folder with two models, inside another that is not edited.
class Disk {
 public:
  Disk() {
    fs::create_directories(here() / "roles");
    restore();
  }
  void restore() const {
    std::ofstream(here() / "watch.yaml", std::ios::trunc) << kModel;
    std::ofstream(here() / "roles/look.yaml", std::ios::trunc) << kRole;
  }
  bool is_alone() const {
    const fs::directory_iterator all(folder_.path());
    return std::distance(begin(all), end(all)) == 1;
  }

  fs::path here() const { return folder_.path() / "models"; }

 private:
  skein::testing::TemporaryFolder folder_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Disk kDisk;
  if (size == 0) return 0;
  constexpr const char* kPaths[] = {"/api/designer/look", "/api/designer/scm", "/api/designer/save",
                                    "/api/designer/disk"};
  const std::string path = kPaths[data[0] % 4U];
  std::string body;
  for (std::size_t i = 1; i < size; ++i) {
    if (data[i] == '@')
      body += kDisk.here().string();
    else
      body += static_cast<char>(data[i]);
  }
  skein::designer::Workbench workbench({(kDisk.here() / "watch.yaml").string()});
  const auto answer = workbench.answer(path.ends_with("disk") ? "GET" : "POST", path, body);
  require(answer.status >= 200 && answer.status < 600);
  require(!nlohmann::json::parse(answer.json, nullptr, false).is_discarded());
  if (path.ends_with("save")) {
    require(kDisk.is_alone());
    if (answer.status == 200) kDisk.restore();
  }
  return 0;
}
