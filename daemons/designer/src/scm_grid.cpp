// SPDX-License-Identifier: Apache-2.0
#include "scm_grid.hpp"

#include <cmath>

#include "skein/interaction/scm_monitor.hpp"
#include "skein/model_tool/load_models.hpp"

namespace skein::designer {

namespace {

using interaction::Position;

double number_in(const Json& json, const char* key) {
  const double value = json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0;
  return std::isfinite(value) ? value : 0;
}

struct Grid {
  double west, south, step, altitude;
  std::size_t columns, rows;
};

Result<Grid, Failure> grid_in(const Json& asked) {
  Grid grid{number_in(asked, "west"),
            number_in(asked, "south"),
            number_in(asked, "step"),
            number_in(asked, "altitude"),
            0,
            0};
  const double columns = number_in(asked, "columns"), rows = number_in(asked, "rows");
  const bool fits = columns >= 1 && rows >= 1 && columns * rows <= static_cast<double>(kMostCells);
  if (!fits || grid.step <= 0) return failure("expected a grid of at most 40000 cells");
  grid.columns = static_cast<std::size_t>(columns);
  grid.rows = static_cast<std::size_t>(rows);
  return grid;
}

struct Bound {
  interaction::ScmBinding binding;
  std::map<std::string, Position> where;
};

/// Each position of a place gets a name of its own.
Result<Bound, Failure> bound(const interaction::Scm& scm, const Json& asked) {
  Bound bound;
  const Json places = asked.value("places", Json::object());
  const Json numbers = asked.value("numbers", Json::object());
  for (const auto& [name, is_place] : scm.parameters) {
    const Json& all = is_place ? places : numbers;
    if (!all.is_object() || !all.contains(name)) return failure("'" + name + "' is missing");
    if (!is_place) {
      bound.binding.numbers[name] = number_in(all, name.c_str());
      continue;
    }
    for (const Json& at : all[name]) {
      const bool whole = at.is_array() && at.size() == 3 && at[0].is_number() &&
                         at[1].is_number() && at[2].is_number();
      if (!whole) return failure("'" + name + "': expected positions");
      const std::string one = name + " " + std::to_string(bound.where.size());
      bound.where[one] = {at[0].get<double>(), at[1].get<double>(), at[2].get<double>()};
      bound.binding.places[name].push_back(one);
    }
  }
  return bound;
}

}  // namespace

Result<std::vector<std::string>, Failure> scm_grid(const Json& asked,
                                                   const std::vector<std::string>& files,
                                                   const interaction::ReadFile& read) {
  const auto grid = grid_in(asked);
  if (!grid) return tl::unexpected(grid.error());
  const auto loaded = model_tool::load_models(files, read);
  if (!loaded) return failure("the models are not right yet");
  const auto& scms = loaded->library.scms;
  const auto scm = scms.find(
      asked.contains("scm") && asked["scm"].is_string() ? asked["scm"].get<std::string>() : "");
  if (scm == scms.end()) return failure("there is no such SCM");
  const auto known = bound(scm->second, asked);
  if (!known) return tl::unexpected(known.error());
  const interaction::Observer observer =
      [&](const std::string& name) -> std::optional<interaction::Sighting> {
    return interaction::Sighting{known->where.at(name), {}};
  };
  std::vector<std::string> rows;
  for (std::size_t y = 0; y < grid->rows; ++y) {
    std::string row(grid->columns, '0');
    for (std::size_t x = 0; x < grid->columns; ++x) {
      interaction::ScmMonitor monitor(scm->first, scm->second, known->binding, {0, 0, {}});
      monitor.update({grid->west + grid->step * (static_cast<double>(x) + 0.5),
                      grid->south + grid->step * (static_cast<double>(y) + 0.5), grid->altitude},
                     observer, {});
      if (monitor.finding() == interaction::ScmReport::Finding::kSatisfied) row[x] = '1';
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace skein::designer
