// SPDX-License-Identifier: Apache-2.0
// Way-point files: a first line "QGC WPL 110", then twelve columns a line.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "mission_item.hpp"
#include "readers.hpp"

namespace skein::mission_files {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr const char* kColumns =
    "12 columns: index, current, frame, command, 4 parameters, latitude, longitude, height, "
    "autocontinue";

std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> columns;
  while (true) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return columns;
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    columns.push_back(line.substr(begin, end - begin));
    line.remove_prefix(end);
  }
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || std::isinf(value))
    return std::nullopt;
  return value;
}

bool is_whole(double value) { return std::abs(value) < 1e9 && value == std::floor(value); }

/// All twelve; nothing, and an error for each that is none.
std::optional<std::array<double, 12>> numbers(std::string_view line, const Mark& mark,
                                              Findings& findings) {
  const auto columns = columns_of(line);
  if (columns.size() != 12) {
    findings.wrong(mark, std::to_string(columns.size()) + " columns", kColumns);
    return std::nullopt;
  }
  std::array<double, 12> row{};
  bool right = true;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto value = number(columns[i]);
    const bool must_be_whole = i < 4 || i == 11;
    if (value && (!must_be_whole || is_whole(*value))) {
      row.at(i) = *value;
      continue;
    }
    right = false;
    findings.wrong(
        mark,
        "column " + std::to_string(i + 1) + ": '" + std::string(columns[i].substr(0, 40)) + "'",
        must_be_whole ? "a whole number" : "a number");
  }
  return right ? std::optional(row) : std::nullopt;
}

void take_row(const std::array<double, 12>& row, const Mark& mark, Contents& contents,
              Findings& findings) {
  MissionItem item;
  item.frame = static_cast<std::int64_t>(row[2]);
  item.command = static_cast<std::int64_t>(row[3]);
  for (std::size_t i = 0; i < 7; ++i) item.params.at(i) = row.at(i + 4);
  item.goes_on = row[11] != 0;
  item.mark = mark;
  // Home, as ArduPilot's stations write it: item 0 is no item of the mission.
  if (row[0] == 0 && item.frame == 0 && item.command == 16) {
    const LatLon at{row[8], row[9]};
    if ((at.latitude != 0 || at.longitude != 0) && check(at, mark, findings))
      contents.home = Home{at, row[10], mark};
    return;
  }
  take(item, contents, findings);
}

}  // namespace

void read_waypoints(std::string_view text, Contents& contents, Findings& findings) {
  int line_number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const Mark mark{++line_number, ""};
    const auto columns = columns_of(line);
    if (line_number == 1) {
      if (columns != std::vector<std::string_view>{"QGC", "WPL", "110"})
        return findings.wrong(mark, "'" + std::string(line.substr(0, 40)) + "'", "QGC WPL 110");
    } else if (!columns.empty() && columns[0].front() != '#') {
      if (const auto row = numbers(line, mark, findings)) take_row(*row, mark, contents, findings);
    }
  }
}

}  // namespace skein::mission_files
