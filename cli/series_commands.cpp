// SPDX-License-Identifier: Apache-2.0
#include "series_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "argument_checks.hpp"
#include "choice_option.hpp"
#include "skein/batch_tool/batch.hpp"
#include "skein/compare_tool/compare.hpp"
#include "skein/export_tool/export.hpp"
#include "skein/series_tool/series.hpp"
#include "skein/storm_tool/recorded.hpp"
#include "skein/storm_tool/storm.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

constexpr const char* kBatchExamples = R"(
Examples:
  skein batch scenarios/comets/confirmed.yaml --seeds 1..100 --jobs 2    a table; out/batch/runs.csv, summary.svg
  skein batch scenarios/team/two.yaml --seeds 1..50 --set radio.loss=0,0.1,0.3    a sweep: 150 runs
  skein batch scenarios/team/two.yaml scenarios/karma/detection.yaml --seeds 1..20 --csv runs.csv --out out/ab --keep
Exit codes: 0 all runs passed, 1 some did not or broke a law, 2 wrong input, 3 it cannot be written, 130 Ctrl-C.)";

void add_batch(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<batch_tool::BatchOptions>();
  CLI::App* batch =
      app.add_subcommand("batch", "Scenarios by seeds, in virtual time: table, CSV and picture");
  batch->add_option("scenarios", options->scenarios, "Scenario files (YAML)")->required();
  batch->add_option("--seeds", options->seeds, "A..B: so many runs of each scenario")
      ->capture_default_str();
  batch->add_option("--jobs", options->limits.jobs, "How many at once")->check(CLI::Range(1, 256));
  batch
      ->add_option("--set", options->sets,
                   "PATH=VALUE[,VALUE...]: a key of the scenario, and what it is in turn; may be "
                   "repeated: every combination is played")
      ->allow_extra_args(false);
  batch->add_option("--degree", options->degrees, "As of `skein run`; may be repeated")
      ->allow_extra_args(false);
  batch->add_option("--out", options->out, "Folder of runs.csv, summary.json and summary.svg")
      ->capture_default_str();
  batch->add_option("--csv", options->csv, "File for the CSV (default: runs.csv in that folder)");
  batch->add_flag("--keep", options->keep, "Also the folder of each run, as `skein run` leaves it");
  batch->add_option("--patience", options->limits.patience, "Seconds of processor time for one run")
      ->check(CLI::Range(1, 3600))
      ->capture_default_str();
  batch->add_flag("--json", options->json, "One JSON document, no progress");
  batch->add_flag("--quiet", options->quiet, "No progress");
  batch->footer(kBatchExamples);
  when_chosen(batch, options, action, actions);
}

constexpr const char* kCompareExamples = R"(
Examples:
  skein run scenarios/comets/confirmed.yaml --virtual --seed 1 --out out/a
  skein run scenarios/comets/confirmed.yaml --virtual --seed 2 --out out/b
  skein compare out/a out/b                 what differs, and where the event logs part
  skein compare out/a out/b --within 2      runs over DDS: times that differ by less than 2 s do not count
Exit codes: 0 the same, 1 something differs, 2 a folder cannot be read.)";

void add_compare(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<compare_tool::CompareOptions>();
  CLI::App* compare = app.add_subcommand("compare", "What differs between two recorded runs");
  compare->add_option("first", options->first, "Folder of a run (out/NAME)")->required();
  compare->add_option("second", options->second, "Folder of another")->required();
  compare->add_option("--within", options->within, "Seconds: times that are nearer are the same")
      ->check(positive_problem);
  compare->add_flag("--all", options->all, "Every difference, not the first of each section");
  compare->add_flag("--json", options->json, "One JSON document");
  compare->footer(kCompareExamples);
  when_chosen(compare, options, action, actions);
}

constexpr const char* kSeriesExamples = R"(
Examples:
  skein series out/comets-confirmed --of x,y,z,energy --uav marvin --every 0.5 --csv marvin.csv
  skein series out/comets-confirmed --of distance,least-distance > apart.csv
  skein series out/comets-confirmed --measures
Exit codes: 0, 2 wrong options or a folder that cannot be read, 3 the file cannot be written.)";

void add_time_series(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<series_tool::SeriesOptions>();
  CLI::App* series = app.add_subcommand("series", "Quantities of a recorded run over time, as CSV");
  series->add_option("folder", options->folder, "Folder of a run (out/NAME)");
  series
      ->add_option("--of", options->of,
                   "Quantities, parted by commas (default: x,y,z,energy); --list tells all")
      ->allow_extra_args(false);
  series->add_option("--uav", options->uavs, "Only of these UAVs; may be repeated")
      ->allow_extra_args(false);
  series->add_option("--every", options->every, "Seconds between two lines")
      ->check(positive_problem)
      ->capture_default_str();
  series->add_option("--csv", options->csv, "File (default: standard output)");
  series->add_flag("--measures", options->measures, "Instead: figures of the whole run");
  series->add_flag("--list", options->list, "Say what quantities there are");
  series->footer(kSeriesExamples);
  when_chosen(series, options, action, actions);
}

constexpr const char* kExportExamples = R"(
Examples:
  skein export out/comets-confirmed --mcap comets.mcap      Foxglove, PlotJuggler: docs/recordings.md
  skein export out/comets-confirmed --kml comets.kml --gpx comets.gpx --geoid 54
  skein run scenarios/action/patrol.yaml --virtual && skein export out/action-patrol --figures figures    as SVG
Exit codes: 0, 2 the folder cannot be read, 3 the file cannot be written.)";

void add_export(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<export_tool::ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "A recorded run for other programs");
  command->add_option("folder", options->folder, "Folder of a run (out/NAME)")->required();
  command->add_option("--mcap", options->mcap, "MCAP file, for Foxglove and PlotJuggler");
  command->add_option("--kml", options->kml, "KML file, for Google Earth and maps");
  command->add_option("--gpx", options->gpx, "GPX file, for GPS programs");
  command->add_option("--figures", options->figures,
                      "Folder for trajectories.svg and chronology.svg, for a paper");
  command
      ->add_option("--geoid", options->geoid,
                   "Height of the sea over the ellipsoid there [m], for heights of KML and GPX")
      ->check(finite_problem)
      ->capture_default_str();
  add_choice(*command, "--compression", options->compression,
             {{"none", mcap::Compression::kNone},
              {"lz4", mcap::Compression::kLz4},
              {"zstd", mcap::Compression::kZstd}},
             "Of its chunks");
  command->footer(kExportExamples);
  when_chosen(command, options, action, actions);
}

constexpr const char* kStormExamples = R"(
Examples:
  skein storm scenarios/comets/confirmed.yaml --seeds 1..100 --jobs 2    troubles in a mission of yours
  skein storm --seeds 1..300                                             missions drawn at random
  skein storm scenarios/team/two.yaml --seeds 17 --save out/17 --log out/17    one run, and its event log
  skein storm scenarios/team/two.yaml scenarios/karma/detection.yaml --seeds 1..1000 --law energy --law crash --json
  skein storm scenarios/team/two.yaml --seeds 1..20 --over-dds 10        by daemons, at ten times real time
The scenario of a seed that breaks a law is kept, small: skein run out/storm/energy-two-17.yaml --virtual
Exit codes: 0 no law was broken, 1 some, 2 wrong input.)";

void add_storm(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<storm_tool::StormOptions>();
  CLI::App* storm = app.add_subcommand(
      "storm", "Missions in which things go wrong, by seed, judged by laws that know no plan");
  storm->add_option("scenarios", options->scenarios,
                    "Scenario files (YAML); without any, missions are drawn at random");
  storm->add_option("--seeds", options->seeds, "A..B: so many runs of each scenario")
      ->capture_default_str();
  storm->add_option("--jobs", options->judge.jobs, "How many at once")->check(CLI::Range(1, 256));
  storm->add_option("--law", options->judge.only, "Only this law; may be repeated")
      ->allow_extra_args(false);
  storm->add_flag("--laws", options->list_laws, "List the laws");
  storm->add_option("--save", options->save, "Folder for scenarios that break a law; '' keeps none")
      ->capture_default_str();
  storm->add_flag("!--no-shrink", options->shrink, "Keep them as they are, not made small");
  storm->add_option("--log", options->judge.log, "Folder for the event log of each run");
  storm->add_flag("--twice", options->judge.twice,
                  "Each run twice: the event logs must be the same");
  storm->add_option("--patience", options->judge.patience, "Seconds of processor time for one run")
      ->check(CLI::Range(1, 3600))
      ->capture_default_str();
  storm
      ->add_option(
          "--over-dds", options->judge.over_dds_at,
          "By daemons over DDS, at so many mission seconds a second, instead of in virtual "
          "time; nothing is made small")
      ->check(CLI::Range(0.1, 100.0));
  storm->add_option("--models", options->models,
                    "Folder scenarios/ of Skein, for missions drawn (default: found)");
  storm->add_flag("--json", options->json, "One JSON document, no progress");
  storm->add_flag("--quiet", options->quiet, "No progress");
  storm->footer(kStormExamples);
  when_chosen(storm, options, action, actions);
}

constexpr const char* kJudgeExamples = R"(
Examples:
  skein judge out/comets-confirmed
  skein judge out/a out/b --law separation --law energy --json
  skein judge --laws                                        what is judged
Exit codes: 0 no law was broken, 1 some, 2 a folder cannot be read.)";

void add_judge(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<storm_tool::JudgeRunsOptions>();
  CLI::App* judge = app.add_subcommand("judge", "Recorded runs judged by laws that know no plan");
  judge->add_option("folders", options->folders, "Folders of runs (out/NAME)");
  judge->add_option("--law", options->only, "Only this law; may be repeated")
      ->allow_extra_args(false);
  judge
      ->add_option(
          "--allow-late", options->late,
          "Of runs over DDS: seconds of the clock on the wall by which what passes between "
          "nodes may be late, and clocks differ")
      ->check(CLI::Range(0.0, 60.0))
      ->capture_default_str();
  judge->add_flag("--laws", options->list_laws, "List the laws");
  judge->add_flag("--json", options->json, "One JSON document");
  judge->footer(kJudgeExamples);
  when_chosen(judge, options, action, actions);
}

}  // namespace

void add_series(CLI::App& app, Action& action, const Actions& actions) {
  add_batch(app, action, actions);
  add_compare(app, action, actions);
  add_time_series(app, action, actions);
  add_export(app, action, actions);
  add_storm(app, action, actions);
  add_judge(app, action, actions);
}

}  // namespace skein::cli
