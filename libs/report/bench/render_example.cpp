// SPDX-License-Identifier: Apache-2.0
// Writes the three documents of the invented missions, and of run folders, to look at:
// report_render_example DIRECTORY [RUN_FOLDER…].
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "skein/report/report.hpp"
#include "synthetic_mission.hpp"

namespace {

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string slurp(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void render(const std::string& directory, const skein::report::RunInfo& info,
            const std::string& log) {
  std::istringstream in(log);
  const auto begin = std::chrono::steady_clock::now();
  const skein::report::SalvagedJournal read = skein::report::salvage_journal(in, "events.jsonl");
  const auto middle = std::chrono::steady_clock::now();
  const std::string html = skein::report::html_report(info, read.journal);
  const auto end = std::chrono::steady_clock::now();
  const std::string stem = directory + "/" + info.scenario;
  write(stem + ".html", html);
  write(stem + ".xml", skein::report::junit(info, read.journal));
  write(stem + ".json", skein::report::summary_json(info, read.journal));
  write(stem + ".jsonl", log);
  const auto ms = [](auto d) { return std::chrono::duration<double, std::milli>(d).count(); };
  std::printf("%s: log %.1f MB, %zu wrong lines; read %.0f ms, page %.0f ms, %.2f MB\n",
              info.scenario.c_str(), static_cast<double>(log.size()) / 1e6, read.errors.size(),
              ms(middle - begin), ms(end - middle), static_cast<double>(html.size()) / 1e6);
}

}  // namespace

int main(int argc, char** argv) {
  namespace testing = skein::report::testing;
  const std::string directory = argc > 1 ? argv[1] : ".";
  render(directory, testing::comets_info(), testing::comets_journal());
  render(directory, testing::swarm_info(20), testing::swarm_journal(20, 100'000, 1));
  render(directory, skein::report::RunInfo{}, "");
  for (int i = 2; i < argc; ++i) {
    const std::string folder = argv[i];
    const auto info = skein::report::run_info_from_json(slurp(folder + "/run.json"), "run.json");
    if (info) render(directory, *info, slurp(folder + "/events.jsonl"));
  }
  return 0;
}
