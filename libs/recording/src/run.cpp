// SPDX-License-Identifier: Apache-2.0
#include "skein/recording/run.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

namespace skein::recording {

namespace {

namespace fs = std::filesystem;

/// The text of a file of the folder, or why there is none.
std::optional<std::string> text_of(const fs::path& file, Diagnostics& wrong) {
  std::error_code error;
  const auto say = [&](const std::string& what) {
    wrong.add({file.string(), 0, 0, "", what, "the folder of a run: run.json, events.jsonl", ""});
    return std::nullopt;
  };
  if (!fs::exists(file, error)) return say("it is not there");
  if (!fs::is_regular_file(file, error)) return say("it is no file");
  if (fs::file_size(file, error) > kMostBytes || error) return say("it is greater than a gigabyte");
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return say("it cannot be read");
  return text;
}

}  // namespace

std::vector<journal::Record> read_events(const std::string& text, const std::string& file,
                                         Diagnostics& damaged) {
  std::vector<journal::Record> records;
  std::istringstream in(text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty()) continue;
    auto record = journal::parse_record(line);
    if (record) {
      records.push_back(std::move(*record));
    } else {
      damaged.add({file, number, 0, "", record.error().why, "", ""});
    }
  }
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  return records;
}

Result<Run, Diagnostics> read_run(const std::string& folder) {
  Run run;
  run.folder = folder;
  Diagnostics wrong;
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    wrong.add({folder, 0, 0, "", "no such folder", "the folder of a run (out/NAME)", ""});
    return tl::unexpected(std::move(wrong));
  }
  const fs::path info_file = fs::path(folder) / "run.json";
  const fs::path events_file = fs::path(folder) / "events.jsonl";
  if (const auto text = text_of(info_file, wrong)) {
    auto info = report::run_info_from_json(*text, info_file.string());
    if (info) {
      run.info = std::move(*info);
    } else {
      wrong.append(info.error());
    }
  }
  if (auto text = text_of(events_file, wrong)) {
    run.events = std::move(*text);
    run.records = read_events(run.events, events_file.string(), run.damaged);
    if (run.records.empty()) {
      wrong.append(run.damaged);
      wrong.add(
          {events_file.string(), 0, 0, "", "no line can be read", "the event log of a run", ""});
    }
  }
  if (!wrong.empty()) return tl::unexpected(std::move(wrong));
  return run;
}

}  // namespace skein::recording
