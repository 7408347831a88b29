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

/// A command that writes its data to stdout and its messages to stderr.
template <class Options>
auto on_streams(int (*command)(const Options&, std::ostream&, std::ostream&)) {
  return [command](const Options& options) { return command(options, std::cout, std::cerr); };
}

/// One that also shows how far it is, to people.
template <class Options>
auto with_progress(int (*command)(const Options&, std::ostream&, std::ostream&)) {
  return [command](Options options) {
    options.on_terminal = isatty(STDERR_FILENO) != 0;
    return command(options, std::cout, std::cerr);
  };
}

}  // namespace

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::LiveActions live;
  live.run = on_streams(run_tool::run);
  live.report = on_streams(run_tool::report);
  live.functional = on_streams(functional_tool::check);
  live.state = on_streams(state_tool::state);
  live.operate = on_streams(operate_tool::operate);
  live.status = on_streams(operate_tool::status);
  live.replay = on_streams(replay_tool::replay);
  live.storm = with_progress(storm_tool::storm);
  live.batch = with_progress(batch_tool::batch);
  live.compare = on_streams(compare_tool::compare);
  live.series = on_streams(series_tool::series);
  live.export_run = on_streams(export_tool::export_run);
  live.import_mission = on_streams(import_tool::import_mission);
  live.record = on_streams(spy_tool::record);
  live.play = on_streams(spy_tool::play);
  live.spy = [](const spy_tool::SpyOptions& options, bool echo) {
    return on_streams(echo ? spy_tool::echo : spy_tool::list)(options);
  };
  return cli::run_command_line(argc, argv, live);
}
