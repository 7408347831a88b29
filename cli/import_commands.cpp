// SPDX-License-Identifier: Apache-2.0
#include "import_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "argument_checks.hpp"
#include "skein/import_tool/import.hpp"
#include "when_chosen.hpp"

namespace skein::cli {

namespace {

constexpr const char* kImportExamples = R"(
Examples:
  skein import survey.plan --out survey.yaml && skein run survey.yaml --virtual
  skein import copter.waypoints --world fell.yaml --uav marvin --model models/marvin.yaml --out copter.yaml
  skein import map.kml --altitude 60 --closed "Danger area" --home 47.5 8.25
What becomes of what: docs/mavlink.md. Exit codes: 0, 2 wrong input, or something in it has no counterpart
(--leave-out), 3 the file cannot be written.)";

}  // namespace

void add_import(CLI::App& app, std::function<int()>& action, const Actions& actions) {
  auto options = std::make_shared<import_tool::ImportOptions>();
  CLI::App* command =
      app.add_subcommand("import", "A mission of QGroundControl, way-points or KML as a scenario");
  command->add_option("file", options->file, "Plan (.plan), way-point file (QGC WPL 110) or KML")
      ->required();
  command->add_option("--world", options->world,
                      "World file of the scenario (default: level ground around the mission)");
  command->add_option("--uav", options->uav, "Name of the UAV that flies it")
      ->capture_default_str();
  command->add_option("--model", options->model,
                      "Its vehicle model (default: Skein's helicopter marvin)");
  command->add_option("--out", options->out, "Scenario file to write (default: standard output)");
  command->add_option("--name", options->name, "Of the scenario (default: as the file)");
  command
      ->add_option("--home", options->home,
                   "Latitude and longitude of the start [degrees] (default: as the file says)")
      ->expected(2)
      ->check(finite_problem);
  command
      ->add_option("--altitude", options->altitude,
                   "Of ways of which the file says no height, over the ground [m]")
      ->check(positive_problem)
      ->capture_default_str();
  command
      ->add_option("--geoid", options->geoid,
                   "Height of the sea over the ellipsoid there [m], for heights over sea level")
      ->check(finite_problem);
  command
      ->add_option("--closed", options->closed,
                   "Areas of this name, or in folders of this name, are closed air; may be "
                   "repeated")
      ->allow_extra_args(false);
  command->add_option("--camera", options->camera, "Device of the model that takes the pictures");
  command->add_flag("--leave-out", options->leave_out,
                    "Leave out what Skein has no counterpart of, and say it");
  command->footer(kImportExamples);
  when_chosen(command, options, action, actions);
}

}  // namespace skein::cli
