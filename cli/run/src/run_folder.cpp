// SPDX-License-Identifier: Apache-2.0
#include "run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "skein/ground_setup/page_world.hpp"
#include "skein/report/report.hpp"
#include "skein/scenario/measures.hpp"
#include "skein/scenario_text/scenario_text.hpp"

namespace skein::run_tool {

namespace {

namespace fs = std::filesystem;

constexpr const char* kVersion = SKEIN_VERSION;

Result<void, Failure> write_file(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  if (!out) return failure("cannot write " + path.string());
  return {};
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

report::TerrainGrid terrain_grid(const world::TerrainSpec& spec) {
  const world::Terrain terrain(spec);
  report::TerrainGrid grid;
  grid.west = spec.west;
  grid.south = spec.south;
  grid.cell = spec.cell;
  grid.width = static_cast<std::size_t>((spec.east - spec.west) / spec.cell) + 1;
  grid.height = static_cast<std::size_t>((spec.north - spec.south) / spec.cell) + 1;
  for (std::size_t row = 0; row < grid.height; ++row) {
    for (std::size_t column = 0; column < grid.width; ++column) {
      grid.values.push_back(terrain.elevation(spec.west + static_cast<double>(column) * spec.cell,
                                              spec.south + static_cast<double>(row) * spec.cell));
    }
  }
  return grid;
}

std::vector<report::GroundPoint> corners_of(const world::Polygon& polygon) {
  std::vector<report::GroundPoint> corners;
  for (const auto& corner : polygon) corners.push_back({corner.x(), corner.y()});
  return corners;
}

report::ClosedAir closed_air(const scenario::Closure& closure) {
  report::ClosedAir air{closure.volume.name,
                        corners_of(closure.volume.polygon),
                        std::max(0.0, closure.when.from.to_seconds()),
                        {}};
  if (closure.when.until < MissionTime::max()) air.until = closure.when.until.to_seconds();
  return air;
}

}  // namespace

report::RunInfo run_info(const scenario::Scenario& scenario, bool virtual_time, double wall_seconds,
                         const std::vector<journal::Record>& records) {
  report::RunInfo info;
  info.scenario = scenario.name;
  info.epoch = scenario.epoch;
  info.runtime = virtual_time ? report::RuntimeKind::kVirtual : report::RuntimeKind::kDds;
  info.rate = virtual_time ? 0 : scenario.rate;
  info.seed = scenario.seed;
  info.wall_seconds = wall_seconds;
  info.version = kVersion;
  const world::GeodeticOrigin& origin = scenario.world.origin;
  info.origin = report::Origin{origin.latitude_degrees, origin.longitude_degrees, origin.altitude};
  const world::TerrainSpec& terrain = scenario.world.terrain;
  info.extents = report::Extents{terrain.west, terrain.south, terrain.east, terrain.north};
  info.terrain = terrain_grid(terrain);
  for (const world::Zone& zone : scenario.world.zones) {
    report::Zone& one = info.zones.emplace_back();
    one.name = zone.name;
    one.polygon = corners_of(zone.polygon);
  }
  for (const scenario::Closure& closure : scenario::closures_of(scenario, records))
    if (closure.when.from < MissionTime::max()) info.air.push_back(closed_air(closure));
  for (const auto& [name, place] : scenario.world.places) {
    info.places.push_back({name, {place.x(), place.y(), place.z()}});
  }
  for (const scenario::UavSpec& uav : scenario.uavs) {
    info.uavs.push_back({uav.name, uav.model.name, uav.degree});
  }
  return info;
}

std::optional<ClaimedFolder> ClaimedFolder::claim(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ClaimedFolder claimed(descriptor);
  if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return std::nullopt;
  return claimed;
}

ClaimedFolder::~ClaimedFolder() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<ClaimedFolder, Failure> prepare_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(fs::path(folder) / "logs", error);
  if (error) return failure("cannot create " + folder + ": " + error.message());
  auto claimed = ClaimedFolder::claim(folder);
  if (!claimed) return failure(folder + ": a run goes on there; --out names another folder");
  for (const char* name :
       {"events.jsonl", "run.json", "world.json", "report.html", "junit.xml", "result.json"}) {
    fs::remove(fs::path(folder) / name, error);
  }
  for (const auto& log : fs::directory_iterator(fs::path(folder) / "logs", error)) {
    if (log.path().extension() == ".log") fs::remove(log.path(), error);
  }
  return std::move(*claimed);
}

Result<std::string, Failure> write_folder(const std::string& folder,
                                          const scenario::Scenario& scenario,
                                          const report::RunInfo& info,
                                          const std::vector<journal::Record>& records,
                                          const std::optional<std::string>& text) {
  std::string events;
  for (const journal::Record& record : records) events += journal::to_json(record) + "\n";
  const fs::path to(folder);
  if (auto done = write_file(to / "events.jsonl", events); !done)
    return tl::unexpected(done.error());
  if (auto done = write_file(to / "run.json", report::to_json(info)); !done) {
    return tl::unexpected(done.error());
  }
  const std::string world = ground_setup::page_world(scenario);
  if (auto done = write_file(to / "world.json", world); !done) return tl::unexpected(done.error());
  if (auto done =
          write_file(to / "scenario.yaml",
                     scenario_text::moved(text.value_or(read_text(scenario.file)),
                                          fs::path(scenario.file).parent_path().string(), folder));
      !done) {
    return tl::unexpected(done.error());
  }
  return write_report(folder);
}

// A line that was cut off by a crash must not cost the report; the page tells how many there are.
Result<report::Journal, Failure> read_run_journal(const std::string& folder) {
  const fs::path file = fs::path(folder) / "events.jsonl";
  std::ifstream events(file);
  if (!events) return failure("cannot read " + file.string());
  return report::salvage_journal(events, file.string()).journal;
}

Result<std::string, Failure> write_report(const std::string& folder) {
  const fs::path from(folder);
  const auto info =
      report::run_info_from_json(read_text(from / "run.json"), (from / "run.json").string());
  if (!info) return failure(to_text(info.error()));
  const auto journal = read_run_journal(folder);
  if (!journal) return tl::unexpected(journal.error());
  const std::string summary = report::summary_json(*info, *journal);
  for (const auto& [name, text] : {std::pair{"report.html", report::html_report(*info, *journal)},
                                   std::pair{"junit.xml", report::junit(*info, *journal)},
                                   std::pair{"result.json", summary}}) {
    if (auto done = write_file(from / name, text); !done) return tl::unexpected(done.error());
  }
  return summary;
}

}  // namespace skein::run_tool
