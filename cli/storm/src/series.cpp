// SPDX-License-Identifier: Apache-2.0
#include "skein/storm_tool/series.hpp"

#include <algorithm>
#include <set>

namespace skein::storm_tool {

void Series::add(const Case& what, const Verdict& verdict) {
  ++missions;
  broken += verdict.violations.empty() ? 0 : 1;
  goals += verdict.goals;
  achieved += verdict.achieved;
  failed += verdict.failed;
  flown += verdict.flown;
  if (verdict.nearest >= 0 && (nearest < 0 || verdict.nearest < nearest)) nearest = verdict.nearest;
  std::set<std::string> seen;
  for (const laws::Violation& one : verdict.violations) {
    Row& row = rows[one.law];
    ++row.violations;
    if (!seen.insert(one.law).second) continue;
    ++row.missions;
    row.examples.push_back(what.name);
  }
}

void print(std::ostream& out, const Series& series, std::size_t examples) {
  out << series.missions << " missions, " << static_cast<long>(series.flown / 3600) << " h; "
      << series.goals << " goals, " << series.achieved << " achieved, " << series.failed
      << " failed; ";
  if (series.nearest >= 0) out << "least distance in the air " << series.nearest << " m; ";
  out << series.broken << " missions break a law\n";
  for (const auto& [law, row] : series.rows) {
    out << law << std::string(law.size() < 16 ? 16 - law.size() : 1, ' ') << row.missions
        << " missions, " << row.violations << " times:";
    for (std::size_t i = 0; i < std::min(examples, row.examples.size()); ++i)
      out << ' ' << row.examples[i];
    out << '\n';
  }
}

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

}  // namespace

void print_json(std::ostream& out, const Case& what, const Verdict& verdict) {
  for (const laws::Violation& one : verdict.violations) {
    out << "{\"mission\":" << quoted(what.name) << ",\"law\":" << quoted(one.law)
        << ",\"at\":" << one.at << ",\"uav\":" << quoted(one.uav) << ",\"goal\":" << one.goal
        << ",\"sentence\":" << quoted(one.sentence) << "}\n";
  }
}

}  // namespace skein::storm_tool
