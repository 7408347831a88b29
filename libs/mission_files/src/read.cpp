// SPDX-License-Identifier: Apache-2.0
#include "skein/mission_files/read.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "readers.hpp"

namespace skein::mission_files {
namespace {

tl::unexpected<Diagnostics> refuse(const std::string& file, std::string why,
                                   std::string expected = "") {
  Diagnostics problems;
  problems.add({file, 0, 0, "", std::move(why), std::move(expected), ""});
  return tl::make_unexpected(std::move(problems));
}

bool has_nothing(const Contents& contents) {
  return contents.items.empty() && contents.fences.empty() && contents.areas.empty() &&
         contents.ways.empty() && contents.places.empty() && contents.left_out.empty();
}

}  // namespace

bool check(const LatLon& at, const Mark& mark, Findings& findings) {
  if (std::abs(at.latitude) <= 90 && std::abs(at.longitude) <= 180) return true;
  findings.wrong(
      mark,
      "latitude " + std::to_string(at.latitude) + ", longitude " + std::to_string(at.longitude),
      "a place on Earth: -90 to 90, -180 to 180 degrees");
  return false;
}

std::optional<Format> format_of(const std::string& file, std::string_view text) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".plan") return Format::kPlan;
  if (ending == ".waypoints") return Format::kWaypoints;
  if (ending == ".kml") return Format::kKml;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return std::nullopt;
  text.remove_prefix(begin);
  if (text.starts_with("QGC WPL")) return Format::kWaypoints;
  if (text.front() == '{') return Format::kPlan;
  if (text.front() == '<') return Format::kKml;
  return std::nullopt;
}

Result<Contents, Diagnostics> read_text(std::string_view text, const std::string& file) {
  if (text.size() > kMostBytes) return refuse(file, "larger than 16 MiB");
  const auto format = format_of(file, text);
  if (!format)
    return refuse(file, "its format is not known",
                  "a plan of QGroundControl (.plan), a way-point file (QGC WPL 110) or KML; "
                  "of .kmz the doc.kml in it");
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  Contents contents;
  Findings findings(file);
  if (*format == Format::kPlan) read_plan(text, contents, findings);
  if (*format == Format::kWaypoints) read_waypoints(text, contents, findings);
  if (*format == Format::kKml) read_kml(text, contents, findings);
  if (!findings.none_wrong()) return tl::make_unexpected(std::move(findings.errors()));
  contents.left_out = findings.take_left_out();
  if (has_nothing(contents)) return refuse(file, "there is nothing in it");
  return contents;
}

Result<Contents, Diagnostics> read_file(const std::string& path) {
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, error) || !in) return refuse(path, "cannot be read");
  if (std::filesystem::file_size(path, error) > kMostBytes)
    return refuse(path, "larger than 16 MiB");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  return read_text(text, path);
}

}  // namespace skein::mission_files
