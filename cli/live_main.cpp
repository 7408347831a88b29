// SPDX-License-Identifier: Apache-2.0
// skein-live: the commands of `skein` that need DDS. `skein` starts it, so that all others start
// without.
#include <unistd.h>

#include <iostream>

#include "commands.hpp"
#include "live_commands.hpp"
#include "skein/batch_tool/batch.hpp"
#include "skein/compare_tool/compare.hpp"
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

namespace {

// The commands about many runs, and about what runs and slots left.
void add_recordings(skein::cli::LiveActions& live) {
  using namespace skein;  // NOLINT(google-build-using-namespace): as below
  live.batch = [](batch_tool::BatchOptions options) {
    options.on_terminal = isatty(STDERR_FILENO) != 0;
    return batch_tool::batch(options, std::cout, std::cerr);
  };
  live.compare = [](const compare_tool::CompareOptions& options) {
    return compare_tool::compare(options, std::cout, std::cerr);
  };
  live.series = [](const series_tool::SeriesOptions& options) {
    return series_tool::series(options, std::cout, std::cerr);
  };
  live.export_run = [](const export_tool::ExportOptions& options) {
    return export_tool::export_run(options, std::cout, std::cerr);
  };
  live.import_mission = [](const import_tool::ImportOptions& options) {
    return import_tool::import_mission(options, std::cout, std::cerr);
  };
  live.record = [](const spy_tool::RecordOptions& options) {
    return spy_tool::record(options, std::cout, std::cerr);
  };
  live.play = [](const spy_tool::PlayOptions& options) {
    return spy_tool::play(options, std::cout, std::cerr);
  };
}

}  // namespace

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::LiveActions live;
  live.run = [](const run_tool::RunOptions& options) {
    return run_tool::run(options, std::cout, std::cerr);
  };
  live.report = [](const run_tool::ReportOptions& options) {
    return run_tool::report(options, std::cout, std::cerr);
  };
  live.functional = [](const functional_tool::FunctionalOptions& options) {
    return functional_tool::check(options, std::cout, std::cerr);
  };
  live.state = [](const state_tool::StateOptions& options) {
    return state_tool::state(options, std::cout, std::cerr);
  };
  live.operate = [](const operate_tool::OperateOptions& options) {
    return operate_tool::operate(options, std::cout, std::cerr);
  };
  live.status = [](const operate_tool::StatusOptions& options) {
    return operate_tool::status(options, std::cout, std::cerr);
  };
  live.replay = [](const replay_tool::ReplayOptions& options) {
    return replay_tool::replay(options, std::cout, std::cerr);
  };
  live.storm = [](storm_tool::StormOptions options) {
    options.on_terminal = isatty(STDERR_FILENO) != 0;
    return storm_tool::storm(options, std::cout, std::cerr);
  };
  add_recordings(live);
  live.spy = [](const spy_tool::SpyOptions& options, bool echo) {
    return echo ? spy_tool::echo(options, std::cout, std::cerr)
                : spy_tool::list(options, std::cout, std::cerr);
  };
  return cli::run_command_line(argc, argv, live);
}
