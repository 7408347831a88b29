// SPDX-License-Identifier: Apache-2.0
#include "skein/world/terrain_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/foundation/shortest_text.hpp"
#include "skein/world/environment_reader.hpp"

namespace skein::world {
namespace {

constexpr std::string_view kRule = "---\n";
constexpr std::int64_t kVersion = 1;
constexpr std::size_t kMostErrors = 20;
constexpr double kGreatestElevation = 1e5;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

void append_head(const MeasuredTerrain& measured, std::string& text) {
  const TerrainSpec& terrain = measured.terrain;
  text +=
      "# Elevations at the corners of square cells [m over the origin's level]; local frame: x "
      "east, y north.\n";
  text += "skein_terrain: " + std::to_string(kVersion) + '\n';
  text += "source: " + quoted(measured.source) + '\n';
  text += "origin: {latitude: " + shortest_text(measured.origin.latitude_degrees) +
          ", longitude: " + shortest_text(measured.origin.longitude_degrees) +
          ", altitude: " + shortest_text(measured.origin.altitude) + "}\n";
  const std::pair<const char*, double> lengths[] = {{"west", terrain.west},
                                                    {"south", terrain.south},
                                                    {"east", terrain.east},
                                                    {"north", terrain.north},
                                                    {"cell", terrain.cell}};
  for (const auto& [key, length] : lengths)
    text += std::string(key) + ": " + shortest_text(length) + '\n';
  text += kRule;
}

/// Up to the next centimetre, without digits that say nothing.
void append_elevation(double elevation, std::string& text) {
  const double centimetres = std::ceil(elevation * 100 - 1e-6);
  text += shortest_text(centimetres / 100);
}

/// Complains about the rows below the head, but not without end.
class RowErrors {
 public:
  RowErrors(const std::string& file, Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}
  void add(int line, std::string message, std::string expected) {
    if (++count_ <= kMostErrors)
      diagnostics_.add({file_, line, 0, "", std::move(message), std::move(expected), ""});
  }

 private:
  const std::string& file_;
  Diagnostics& diagnostics_;
  std::size_t count_ = 0;
};

/// The numbers of a row; what is none is reported and left out.
std::vector<double> numbers_of(std::string_view row, int line, RowErrors& errors) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t begin = row.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return numbers;
    row.remove_prefix(begin);
    const std::string_view word = row.substr(0, row.find_first_of(" \t\r"));
    double number = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (problem == std::errc() && end == word.data() + word.size() &&
        std::abs(number) <= kGreatestElevation)
      numbers.push_back(number);
    else
      errors.add(line, "'" + std::string(word.substr(0, 40)) + "'", "an elevation in metres");
    row.remove_prefix(word.size());
  }
}

struct Head {
  std::string_view text, rows;
  int lines = 0;  ///< of the head, with the rule below it
};

std::optional<Head> head_of(std::string_view text) {
  const std::size_t rule = text.find("\n---\n");
  if (rule == std::string_view::npos) return std::nullopt;
  Head head{text.substr(0, rule + 1), text.substr(rule + 1 + kRule.size()), 0};
  head.lines = static_cast<int>(std::count(head.text.begin(), head.text.end(), '\n')) + 1;
  return head;
}

void read_head(const config::Reader& reader, MeasuredTerrain& measured) {
  if (!reader.keys({"skein_terrain", "source", "origin", "west", "south", "east", "north", "cell"}))
    return;
  reader.required("skein_terrain").integer(kVersion, kVersion, kVersion);
  measured.source = reader.optional("source").text();
  measured.origin = read_geodetic(reader.required("origin"));
  TerrainSpec& terrain = measured.terrain;
  terrain.west = reader.required("west").number(-1000, kCoordinate);
  terrain.south = reader.required("south").number(-1000, kCoordinate);
  terrain.east = reader.required("east").number(1000, kCoordinate);
  terrain.north = reader.required("north").number(1000, kCoordinate);
  terrain.cell = reader.required("cell").number(20, {0.1, 10'000, "m"});
  for (const std::string& problem : problems_of(terrain)) reader.error(problem);
}

/// Precondition: the head was right.
void read_rows(const Head& head, RowErrors& errors, TerrainSpec& terrain) {
  const TerrainCorners corners = corners_of(terrain);
  terrain.elevations.assign(corners.count(), 0);
  std::string_view rest = head.rows;
  std::size_t row = 0;
  for (int line = head.lines + 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const auto numbers = numbers_of(rest.substr(0, end), line, errors);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (numbers.empty()) continue;
    if (++row > corners.rows) continue;
    if (numbers.size() != corners.columns) {
      errors.add(line, std::to_string(numbers.size()) + " elevations in a row",
                 std::to_string(corners.columns));
      continue;
    }
    const std::size_t from_south = corners.rows - row;
    std::copy(
        numbers.begin(), numbers.end(),
        terrain.elevations.begin() + static_cast<std::ptrdiff_t>(from_south * corners.columns));
  }
  if (row != corners.rows)
    errors.add(0, std::to_string(row) + " rows of elevations", std::to_string(corners.rows));
}

}  // namespace

std::string terrain_file_text(const MeasuredTerrain& measured) {
  const TerrainSpec& terrain = measured.terrain;
  SKEIN_EXPECTS(!terrain.elevations.empty() && terrain.hills.empty());
  SKEIN_EXPECTS(problems_of(terrain).empty());
  const TerrainCorners corners = corners_of(terrain);
  std::string text;
  text.reserve(corners.count() * 7 + 500);
  append_head(measured, text);
  for (std::size_t row = corners.rows; row-- > 0;) {
    for (std::size_t column = 0; column < corners.columns; ++column) {
      if (column > 0) text += ' ';
      append_elevation(terrain.elevations[row * corners.columns + column], text);
    }
    text += '\n';
  }
  return text;
}

Result<MeasuredTerrain, Diagnostics> read_terrain_file(std::string_view text,
                                                       const std::string& file) {
  Diagnostics diagnostics;
  const auto head = head_of(text);
  if (!head) {
    diagnostics.add({file, 0, 0, "", "this is not a terrain file",
                     "one that skein terrain made: a head, ---, elevations", ""});
    return tl::unexpected(std::move(diagnostics));
  }
  const auto document = config::parse_yaml(head->text, file);
  if (!document) return tl::unexpected(document.error());
  MeasuredTerrain measured;
  read_head(config::Reader(*document, file, diagnostics), measured);
  if (diagnostics.empty()) {
    RowErrors errors(file, diagnostics);
    read_rows(*head, errors, measured.terrain);
  }
  if (!diagnostics.empty()) return tl::unexpected(std::move(diagnostics));
  return measured;
}

}  // namespace skein::world
