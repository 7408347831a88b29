// SPDX-License-Identifier: Apache-2.0
#include "series.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "skein/report/distributions.hpp"
#include "skein/scenario/measures.hpp"

namespace skein::batch_tool {

namespace {

using Json = nlohmann::ordered_json;
using report::Spread;

Series::Share& share_of(Series& series, const std::string& name) {
  for (Series::Share& one : series.expectations)
    if (one.name == name) return one;
  return series.expectations.emplace_back(Series::Share{name});
}

std::vector<double>& figures_of(Series& series, const std::string& name) {
  for (auto& [known, figures] : series.measures)
    if (known == name) return figures;
  return series.measures.emplace_back(name, std::vector<double>()).second;
}

void add(Series& series, const Row& row) {
  ++series.runs;
  series.passed += row.outcome == "passed" ? 1 : 0;
  series.lawless += row.laws.empty() ? 0 : 1;
  for (const auto& [name, met] : row.expectations) {
    Series::Share& share = share_of(series, name);
    ++share.judged;
    share.met += met ? 1 : 0;
  }
  for (const auto& [name, value] : row.measures) {
    auto& figures = figures_of(series, name);
    if (value) figures.push_back(*value);
  }
  if (!row.good()) series.bad.push_back(row);
}

std::string number(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(std::abs(value) < 10 ? 3 : 1) << value;
  return text.str();
}

void print_measures(std::ostream& out, const Series& series) {
  std::size_t width = 20;
  for (const auto& [name, figures] : series.measures)
    width = std::max(width, name.size() + scenario::unit_of(name).size() + 5);
  out << "  " << std::left << std::setw(static_cast<int>(width)) << "MEASURE" << std::right;
  for (const char* head : {"RUNS", "MEAN", "SD", "MIN", "MEDIAN", "P95", "MAX"})
    out << std::setw(11) << head;
  out << '\n';
  for (const auto& [name, figures] : series.measures) {
    const std::string unit(scenario::unit_of(name));
    const Spread of = report::spread_of(figures);
    out << "  " << std::left << std::setw(static_cast<int>(width))
        << name + (unit.empty() ? "" : " [" + unit + "]") << std::right << std::setw(11)
        << of.count;
    if (of.count > 0) {
      for (const double value : {of.mean, of.deviation, of.minimum, of.median, of.p95, of.maximum})
        out << std::setw(11) << number(value);
    }
    out << '\n';
  }
}

void print_bad(std::ostream& out, const Series& series, std::size_t examples) {
  for (std::size_t i = 0; i < std::min(examples, series.bad.size()); ++i) {
    const Row& row = series.bad[i];
    out << "  seed " << row.seed << ": " << row.outcome;
    if (!row.reason.empty()) out << ": " << row.reason;
    for (const std::string& law : row.laws) out << "; breaks the law " << law;
    out << '\n';
    for (const std::string& seen : row.breaks) out << "    " << seen << '\n';
  }
  if (series.bad.size() > examples)
    out << "  and " << series.bad.size() - examples << " more: the CSV has them all\n";
}

Json json_of(const Spread& spread) {
  Json json{{"runs", spread.count}};
  if (spread.count == 0) return json;
  json.update({{"mean", spread.mean},
               {"sd", spread.deviation},
               {"min", spread.minimum},
               {"q1", spread.lower_quartile},
               {"median", spread.median},
               {"q3", spread.upper_quartile},
               {"p95", spread.p95},
               {"max", spread.maximum}});
  return json;
}

Json json_of(const Series& series) {
  Json set = Json::object(), expectations = Json::array(), measures = Json::object(),
       bad = Json::array();
  for (const auto& [path, value] : series.combination) set[path] = value;
  for (const Series::Share& one : series.expectations)
    expectations.push_back({{"name", one.name}, {"met", one.met}, {"runs", one.judged}});
  for (const auto& [name, figures] : series.measures)
    measures[name] = json_of(report::spread_of(figures));
  for (const Row& row : series.bad)
    bad.push_back({{"seed", row.seed},
                   {"outcome", row.outcome},
                   {"reason", row.reason},
                   {"laws", row.laws},
                   {"breaks", row.breaks}});
  return {{"scenario", series.scenario}, {"set", set},
          {"runs", series.runs},         {"passed", series.passed},
          {"lawless", series.lawless},   {"expectations", expectations},
          {"measures", measures},        {"bad", bad}};
}

}  // namespace

std::string Series::label() const {
  const std::string changed = to_text(combination);
  return scenario + (changed.empty() ? "" : ", " + changed);
}

std::vector<Series> series_of(const std::vector<Row>& rows) {
  std::vector<Series> all;
  for (const Row& row : rows) {
    if (row.outcome == "interrupted") continue;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Series& one) {
      return one.scenario == row.scenario && one.combination == row.combination;
    });
    if (found != all.end()) {
      add(*found, row);
      continue;
    }
    Series& fresh = all.emplace_back();
    fresh.scenario = row.scenario;
    fresh.combination = row.combination;
    add(fresh, row);
  }
  return all;
}

void print(std::ostream& out, const std::vector<Series>& all, std::size_t examples) {
  for (const Series& series : all) {
    out << series.label() << ": " << series.passed << " of " << series.runs << " runs passed, "
        << series.lawless << " break a law\n";
    for (const Series::Share& one : series.expectations)
      out << "  " << std::right << std::setw(5) << one.met << " of " << std::left << std::setw(5)
          << one.judged << ' ' << one.name << '\n';
    print_measures(out, series);
    print_bad(out, series, examples);
  }
}

std::string summary_json(const std::vector<Series>& all) {
  Json json{{"series", Json::array()}};
  for (const Series& series : all) json["series"].push_back(json_of(series));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_svg(const std::vector<Series>& all) {
  std::vector<report::DistributionPanel> panels;
  std::size_t runs = 0;
  for (const Series& series : all) {
    runs += series.runs;
    for (const auto& [name, figures] : series.measures) {
      auto panel = std::find_if(panels.begin(), panels.end(),
                                [&](const auto& one) { return one.name == name; });
      if (panel == panels.end())
        panel = panels.insert(panels.end(), {name, std::string(scenario::unit_of(name)), {}});
      panel->rows.push_back({series.label(), figures});
    }
  }
  return report::distributions_svg(std::to_string(runs) + " runs", panels);
}

}  // namespace skein::batch_tool
