// SPDX-License-Identifier: Apache-2.0
// skein-lab: missions by the hundred in virtual time, and what recorded runs and other programs
// files are made into. `skein` starts it.
#include "actions.hpp"
#include "commands.hpp"
#include "on_streams.hpp"
#include "skein/batch_tool/batch.hpp"
#include "skein/compare_tool/compare.hpp"
#include "skein/designer/edit_models.hpp"
#include "skein/export_tool/export.hpp"
#include "skein/import_tool/import.hpp"
#include "skein/series_tool/series.hpp"
#include "skein/storm_tool/recorded.hpp"
#include "skein/storm_tool/storm.hpp"

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::Actions actions(cli::start_skein_instead);
  actions.add(cli::with_progress(storm_tool::storm));
  actions.add(cli::with_progress(batch_tool::batch));
  actions.add(cli::on_streams(compare_tool::compare));
  actions.add(cli::on_streams(series_tool::series));
  actions.add(cli::on_streams(storm_tool::judge_runs));
  actions.add(cli::on_streams(export_tool::export_run));
  actions.add(cli::on_streams(import_tool::import_mission));
  actions.add(cli::on_streams(designer::edit_models));
  return cli::run_command_line(argc, argv, actions);
}
