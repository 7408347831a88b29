// SPDX-License-Identifier: Apache-2.0
#include "skein/export_tool/export.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/foxglove/export.hpp"
#include "skein/mcap/writer.hpp"
#include "skein/recording/run.hpp"
#include "skein/report/figures.hpp"
#include "skein/track_files/tracks.hpp"

namespace skein::export_tool {

Result<std::uint64_t, Failure> write_mcap(const report::RunInfo& info,
                                          const std::vector<journal::Record>& records,
                                          const std::string& file, mcap::Compression compression) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  mcap::WriterOptions options;
  options.library = "skein " + info.version;
  options.compression = compression;
  mcap::Writer writer(options, [&](std::string_view bytes) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
  foxglove::export_run(info, records, writer);
  writer.close();
  out.close();
  if (!out) return failure("cannot write " + file);
  return writer.messages();
}

namespace {

/// As an exit code.
int write_file(const std::string& file, const std::string& text, std::ostream& out,
               std::ostream& err) {
  std::ofstream to(file, std::ios::binary | std::ios::trunc);
  to << text;
  to.close();
  if (to) {
    out << file << ": " << text.size() << " bytes\n";
    return kExitOk;
  }
  err << "cannot write " << file << '\n';
  return kExitSystem;
}

int write_mcap_file(const ExportOptions& options, const recording::Run& run, std::ostream& out,
                    std::ostream& err) {
  if (options.mcap.empty()) return kExitOk;
  if (!run.info.origin)
    err << options.folder << ": of a version that did not say where on Earth it was: no map\n";
  const auto written = write_mcap(run.info, run.records, options.mcap, options.compression);
  if (!written) {
    err << written.error().why << '\n';
    return kExitSystem;
  }
  out << options.mcap << ": " << *written << " messages\n";
  return kExitOk;
}

int write_tracks(const ExportOptions& options, const recording::Run& run, std::ostream& out,
                 std::ostream& err) {
  if (options.kml.empty() && options.gpx.empty()) return kExitOk;
  if (!run.info.origin) {
    err << options.folder << ": of a version that did not say where on Earth it was: no tracks\n";
    return kExitBadInput;
  }
  const track_files::TrackOptions how{options.geoid};
  int code = kExitOk;
  if (!options.kml.empty())
    code = write_file(options.kml, track_files::to_kml(run.info, run.records, how), out, err);
  if (!options.gpx.empty())
    code = std::max(
        code, write_file(options.gpx, track_files::to_gpx(run.info, run.records, how), out, err));
  return code;
}

/// Two SVG files, for a paper.
int write_figures(const ExportOptions& options, const recording::Run& run, std::ostream& out,
                  std::ostream& err) {
  if (options.figures.empty()) return kExitOk;
  std::istringstream events(run.events);
  const report::Journal journal = report::salvage_journal(events, "events.jsonl").journal;
  std::error_code failed;
  std::filesystem::create_directories(options.figures, failed);
  const auto file = [&](const char* name) {
    return (std::filesystem::path(options.figures) / name).string();
  };
  const int map =
      write_file(file("trajectories.svg"), report::trajectories_svg(run.info, journal), out, err);
  return std::max(
      map, write_file(file("chronology.svg"), report::chronology_svg(run.info, journal), out, err));
}

}  // namespace

int export_run(const ExportOptions& options, std::ostream& out, std::ostream& err) {
  if (options.mcap.empty() && options.kml.empty() && options.gpx.empty() &&
      options.figures.empty()) {
    err << "no file to write; expected: --mcap, --kml, --gpx or --figures\n";
    return kExitBadInput;
  }
  const auto run = recording::read_run(options.folder);
  if (!run) {
    err << to_text(run.error());
    return kExitBadInput;
  }
  err << to_text(run->damaged);  // the rest is still worth a file
  const int mcap = write_mcap_file(options, *run, out, err);
  const int tracks = write_tracks(options, *run, out, err);
  return std::max({mcap, tracks, write_figures(options, *run, out, err)});
}

}  // namespace skein::export_tool
