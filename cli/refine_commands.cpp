// SPDX-License-Identifier: Apache-2.0
#include "refine_commands.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <ctime>
#include <memory>

#include "actions.hpp"
#include "argument_checks.hpp"
#include "skein/refine_tool/refine.hpp"
#include "skein/terrain_tool/terrain.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

constexpr const char* kExamples = R"(
Services: path, tour, coverage, partition, patrol, viewpoint, viewshed, relay, evaluate, insertion.
Examples:
  skein refine --example path > query.json      a query that runs as it is, to start from
  skein refine query.json                       the answer, for people
  skein refine query.json --svg way.svg         and as a picture: ground, zones, way
  skein refine query.json --json | jq .path.way
  skein refine --example coverage | skein refine - --svg sweep.svg
Queries and results by example: docs/refiners.md. Exit codes: 0 there is a solution, 1 there is none (and
why), 2 wrong query or files, 3 a file cannot be written, 4 the time budget ended first.)";

constexpr const char* kTerrainExamples = R"(
Examples:
  skein terrain make dem.tif --out fell.terrain                          all of it, as fine as it is
  skein terrain make n36w085.hgt --cell 30 --origin 36.59 -84.25 300 \
    --extent -3000 -3000 3000 3000 --out valley.terrain                  six kilometres around a place
  skein terrain show valley.terrain --svg valley.svg
In a scenario: world: {terrain: {grid: valley.terrain}} (docs/scenario-format.md).
Exit codes: 0 done, 2 wrong options or files, 3 a file cannot be written.)";

void add_make(CLI::App& terrain, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<terrain_tool::MakeOptions>();
  CLI::App* make = terrain.add_subcommand("make", "Of a raster, the file that scenarios name");
  make->add_option("raster", options->raster, "GeoTIFF, ESRI ASCII grid or SRTM tile")->required();
  make->add_option("--out", options->out, "The terrain file to write")->required();
  make->add_option("--cell", options->cell, "Distance of its points [m] (default: as the raster)")
      ->check(positive_problem);
  make->add_option("--extent", options->extent,
                   "West, south, east, north from the origin [m] (default: all)")
      ->expected(4)
      ->check(finite_problem);
  make->add_option("--origin", options->origin,
                   "Latitude, longitude [degrees], altitude [m] (default: middle, lowest)")
      ->expected(3)
      ->check(finite_problem);
  make->add_option("--crs", options->crs, "Coordinates of a raster that does not say: EPSG:4326");
  make->add_option("--nodata", options->no_data, "Elevation of cells without data [m]")
      ->check(finite_problem);
  when_chosen(make, options, action, actions);
}

void add_show(CLI::App& terrain, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<terrain_tool::ShowOptions>();
  CLI::App* show = terrain.add_subcommand("show", "What is in a terrain file");
  show->add_option("file", options->file, "Terrain file")->required();
  show->add_option("--svg", options->svg, "Picture to write");
  when_chosen(show, options, action, actions);
}

/// Of the whole process: what others do on the machine does not count.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool colour_on() {
  const char* refused = std::getenv("NO_COLOR");  // no-color.org: set and not empty
  return isatty(STDOUT_FILENO) != 0 && (refused == nullptr || *refused == '\0');
}

}  // namespace

void add_terrain(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  CLI::App* terrain = app.add_subcommand("terrain", "Measured ground for scenarios, from a raster");
  terrain->require_subcommand(1);
  terrain->footer(kTerrainExamples);
  add_make(*terrain, action, actions);
  add_show(*terrain, action, actions);
}

void add_refine(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<refine_tool::RefineOptions>();
  CLI::App* refine = app.add_subcommand(
      "refine",
      "Ask a specialised refiner: ways, tours, sweeps, patrols, viewpoints, view-sheds, relays");
  CLI::Option* query =
      refine->add_option("query", options->query, "Query file (JSON); \"-\": standard input");
  CLI::Option* example =
      refine->add_option("--example", options->example, "Print an example query of this service");
  example->excludes(query);
  refine->add_option("--svg", options->svg, "Picture to write");
  refine->add_option(
      "--out", options->out,
      "Ways, areas and places of the answer as .geojson, .kml or .wkt; a viewshed as .tif "
      "or .asc");
  refine->add_flag("--json", options->json, "The answer as JSON");
  CLI::Option* seconds =
      refine
          ->add_option("--seconds", options->seconds,
                       "Time budget [s of the processor], before that of the query (default: "
                       "none; of a patrol 20)")
          ->check(positive_problem);
  refine->add_flag("--no-budget", options->no_budget, "No budget, of a patrol either")
      ->excludes(seconds);
  refine->add_option("--seed", options->seed, "Seed, before that of the query");
  refine->footer(kExamples);
  refine->callback([options, query, example, &action, &actions] {
    if (query->count() + example->count() == 0)
      throw CLI::RequiredError("a query file, or --example SERVICE");
    options->now = processor_seconds;
    options->colour = colour_on();
    action = [options, &actions] { return actions.carry_out(*options); };
  });
}

}  // namespace skein::cli
