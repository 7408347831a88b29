// SPDX-License-Identifier: Apache-2.0
#include "refine_commands.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <ctime>
#include <memory>

#include "argument_checks.hpp"
#include "live_commands.hpp"
#include "skein/refine_tool/refine.hpp"

namespace skein::cli {

namespace {

constexpr const char* kExamples = R"(
Services: path, tour, coverage, partition, patrol, viewpoint, relay, evaluate, insertion.
Examples:
  skein refine --example path > query.json      a query that runs as it is, to start from
  skein refine query.json                       the answer, for people
  skein refine query.json --svg way.svg         and as a picture: ground, zones, way
  skein refine query.json --json | jq .path.way
  skein refine --example coverage | skein refine - --svg sweep.svg
Queries and results by example: docs/refiners.md. Exit codes: 0 there is a solution, 1 there is none (and
why), 2 wrong query or files, 3 a file cannot be written, 4 the time budget ended first.)";

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

void add_refine(CLI::App& app, std::function<int()>& action, const LiveActions& live) {
  auto options = std::make_shared<refine_tool::RefineOptions>();
  CLI::App* refine = app.add_subcommand(
      "refine", "Ask a specialised refiner: ways, tours, sweeps, patrols, viewpoints, relays");
  CLI::Option* query =
      refine->add_option("query", options->query, "Query file (JSON); \"-\": standard input");
  CLI::Option* example =
      refine->add_option("--example", options->example, "Print an example query of this service");
  example->excludes(query);
  refine->add_option("--svg", options->svg, "Picture to write");
  refine->add_option("--out", options->out,
                     "Ways, areas and places of the answer as .geojson, .kml or .wkt");
  refine->add_flag("--json", options->json, "The answer as JSON");
  refine
      ->add_option("--seconds", options->seconds,
                   "Time budget [s of the processor], before that of the query")
      ->check(positive_problem);
  refine->add_option("--seed", options->seed, "Seed, before that of the query");
  refine->footer(kExamples);
  refine->callback([options, query, example, &action, &live] {
    if (query->count() + example->count() == 0)
      throw CLI::RequiredError("a query file, or --example SERVICE");
    options->now = processor_seconds;
    options->colour = colour_on();
    action = [options, &live] { return live.refine(*options); };
  });
}

}  // namespace skein::cli
