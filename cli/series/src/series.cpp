// SPDX-License-Identifier: Apache-2.0
#include "skein/series_tool/series.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>
#include <sstream>

#include "quantities.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/foundation/shortest_text.hpp"
#include "skein/recording/run.hpp"
#include "skein/scenario/measures.hpp"

namespace skein::series_tool {

namespace {

using recording::Run;

constexpr double kMostLines = 50'000'000;

/// Empty for what is not known.
std::string number(double value) { return std::isfinite(value) ? shortest_text(value) : ""; }

std::vector<std::string> parted(const std::vector<std::string>& texts) {
  std::vector<std::string> parts;
  for (const std::string& text : texts) {
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  }
  return parts;
}

std::vector<std::string> uavs_of(const Run& run, const SeriesOptions& options, Diagnostics& wrong) {
  std::vector<std::string> known;
  for (const report::UavInfo& uav : run.info.uavs) known.push_back(uav.name);
  if (options.uavs.empty()) return known;
  const std::vector<std::string> wanted = parted(options.uavs);
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      wrong.add(
          {"", 0, 0, "--uav", "no UAV '" + name + "' in the run", "", nearest_name(name, known)});
  }
  return wanted;
}

void write_series(const Run& run, const std::vector<Column>& columns, double every,
                  std::ostream& out) {
  out << "time";
  for (const Column& column : columns) out << ',' << column.name;
  out << '\n';
  State state;
  auto next = run.records.begin();
  const double until = run.until().to_seconds();
  for (std::uint64_t i = 0;; ++i) {
    const double at = static_cast<double>(i) * every;
    if (at > until) return;
    const MissionTime instant = MissionTime::seconds(at);
    for (; next != run.records.end() && next->at() <= instant; ++next) state.see(*next);
    out << number(at);
    for (const Column& column : columns) out << ',' << number(column.value(state));
    out << '\n';
  }
}

void write_measures(const Run& run, std::ostream& out) {
  out << "measure,value,unit\n";
  for (const scenario::NamedMeasure& one : scenario::measures_of_any_run()) {
    const auto measured = scenario::measure(one.what, run.records);
    out << one.name << ',' << (measured ? number(measured->value) : "") << ','
        << scenario::unit_of(one.what.quantity) << '\n';
  }
}

int write(const Run& run, const SeriesOptions& options, const std::vector<Column>& columns,
          std::ostream& out) {
  if (options.measures) {
    write_measures(run, out);
  } else {
    write_series(run, columns, options.every, out);
  }
  return out.flush() ? kExitOk : kExitSystem;
}

}  // namespace

int series(const SeriesOptions& options, std::ostream& out, std::ostream& err) {
  if (options.list) {
    out << list_of_quantities();
    return kExitOk;
  }
  const auto run = recording::read_run(options.folder);
  if (!run) {
    err << to_text(run.error());
    return kExitBadInput;
  }
  err << to_text(run->damaged);  // the rest is still worth a series
  Diagnostics wrong;
  const auto uavs = uavs_of(*run, options, wrong);
  auto names = parted(options.of);
  if (names.empty()) names = {"x", "y", "z", "energy"};
  const auto columns = columns_of(names, uavs);
  if (!columns) wrong.append(columns.error());
  if (run->until().to_seconds() / options.every > kMostLines)
    wrong.add({"", 0, 0, "--every", "more than 50 million lines", "", ""});
  if (!wrong.empty()) {
    err << to_text(wrong);
    return kExitBadInput;
  }
  if (options.csv.empty()) return write(*run, options, *columns, out);
  std::ofstream file(options.csv, std::ios::binary | std::ios::trunc);
  const int code = write(*run, options, *columns, file);
  if (code != kExitOk) err << options.csv << ": cannot be written\n";
  return code;
}

}  // namespace skein::series_tool
