// SPDX-License-Identifier: Apache-2.0
#include "testing/reasons.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace skein::testing {

using journal::Record;

bool says_why(const std::vector<Record>& records) {
  return std::any_of(records.begin(), records.end(), [](const Record& record) {
    const std::string& kind = record.kind();
    if (kind == "contact") return true;
    if (kind == "command") return record.text("state") == "expired";
    if (kind == "task") return !record.text("reason").empty();
    return kind == "goal" && !record.text("why").empty();
  });
}

bool is_explained(const std::vector<Record>& records) {
  return std::any_of(records.begin(), records.end(), [](const Record& record) {
    const bool finished = record.kind() == "mission" && record.text("state") == "finished";
    return finished || (record.kind() == "waiting" && !record.text("why").empty());
  });
}

std::string left_under_way(const std::vector<Record>& records) {
  std::map<std::pair<std::string, double>, std::string> told, carried;
  for (const Record& record : records) {
    const std::pair key{std::string(record.text("uav")), record.number("task")};
    if (record.kind() == "task") told[key] = record.text("state");
    if (record.kind() == "functional") carried[key] = record.text("state");
  }
  std::string left;
  for (const auto& [key, state] : told) {
    const auto there = carried.find(key);
    if (state == "running" && there != carried.end() && there->second != "running")
      left += key.first + " " + std::to_string(key.second) + "\n";
  }
  return left;
}

}  // namespace skein::testing
