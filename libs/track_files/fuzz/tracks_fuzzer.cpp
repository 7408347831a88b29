// SPDX-License-Identifier: Apache-2.0
// Any event log and run that can be read can be exported as tracks, and what is written is XML.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "skein/track_files/tracks.hpp"
#include "skein/xml/element.hpp"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

/// A line that is a run's description is that; the others are its event log.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  skein::report::RunInfo info;
  info.origin = {37.3, -6, 150};
  std::vector<skein::journal::Record> records;
  for (std::string line; std::getline(in, line);) {
    if (auto record = skein::journal::parse_record(line)) {
      records.push_back(std::move(*record));
    } else if (auto run = skein::report::run_info_from_json(line, "fuzz")) {
      if (run->origin) info = std::move(*run);
    }
  }
  std::stable_sort(records.begin(), records.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  for (const std::string& file :
       {skein::track_files::to_kml(info, records), skein::track_files::to_gpx(info, records)})
    require(skein::xml::parse(file, "written").has_value());
  return 0;
}
