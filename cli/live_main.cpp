// SPDX-License-Identifier: Apache-2.0
// skein-live: the commands of `skein` that need DDS. `skein` starts it, so that all others start
// without.
#include "commands.hpp"
#include "live_commands.hpp"
#include "on_streams.hpp"
#include "skein/batch_tool/batch.hpp"
#include "skein/compare_tool/compare.hpp"
#include "skein/designer/edit_models.hpp"
#include "skein/export_tool/export.hpp"
#include "skein/functional_tool/functional.hpp"
#include "skein/import_tool/import.hpp"
#include "skein/operate_tool/operate.hpp"
#include "skein/replay_tool/replay.hpp"
#include "skein/run_tool/run.hpp"
#include "skein/series_tool/series.hpp"
#include "skein/spy_tool/record.hpp"
#include "skein/spy_tool/spy.hpp"
#include "skein/state_tool/state.hpp"
#include "skein/storm_tool/storm.hpp"

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::LiveActions live;
  live.run = cli::on_streams(run_tool::run);
  live.report = cli::on_streams(run_tool::report);
  live.functional = cli::on_streams(functional_tool::check);
  live.state = cli::on_streams(state_tool::state);
  live.operate = cli::on_streams(operate_tool::operate);
  live.status = cli::on_streams(operate_tool::status);
  live.replay = cli::on_streams(replay_tool::replay);
  live.storm = cli::with_progress(storm_tool::storm);
  live.batch = cli::with_progress(batch_tool::batch);
  live.compare = cli::on_streams(compare_tool::compare);
  live.series = cli::on_streams(series_tool::series);
  live.export_run = cli::on_streams(export_tool::export_run);
  live.import_mission = cli::on_streams(import_tool::import_mission);
  live.edit_models = cli::on_streams(designer::edit_models);
  live.record = cli::on_streams(spy_tool::record);
  live.play = cli::on_streams(spy_tool::play);
  live.spy = cli::on_streams(spy_tool::spy);
  return cli::run_command_line(argc, argv, live);
}
