// SPDX-License-Identifier: Apache-2.0
// `skein export`: a recorded run for other programs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/journal/record.hpp"
#include "skein/mcap/format.hpp"
#include "skein/report/run_info.hpp"

namespace skein::export_tool {

struct ExportOptions {
  std::string folder;   ///< of a run
  std::string mcap;     ///< file for Foxglove and PlotJuggler; empty: none
  std::string kml;      ///< file for maps and Google Earth; empty: none
  std::string gpx;      ///< file for GPS programs; empty: none
  std::string figures;  ///< folder for trajectories.svg and chronology.svg; empty: none
  double geoid = 0;     ///< of the sea over the ellipsoid there [m], for heights of KML and GPX
  mcap::Compression compression = mcap::Compression::kZstd;
};

/// Exit codes: cli/export/README.md.
int export_run(const ExportOptions& options, std::ostream& out, std::ostream& err);

/// The records, which are in the order of time, as an MCAP file; how many messages it has.
Result<std::uint64_t, Failure> write_mcap(const report::RunInfo& info,
                                          const std::vector<journal::Record>& records,
                                          const std::string& file,
                                          mcap::Compression compression = mcap::Compression::kZstd);

}  // namespace skein::export_tool
