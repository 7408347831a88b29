// SPDX-License-Identifier: Apache-2.0
// The commands that meet daemons and DDS: run, report, replay, operate, status, spy, functional,
// state, storm.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}
namespace skein::run_tool {
struct RunOptions;
struct ReportOptions;
}  // namespace skein::run_tool
namespace skein::functional_tool {
struct FunctionalOptions;
}
namespace skein::refine_tool {
struct RefineOptions;
}
namespace skein::terrain_tool {
struct MakeOptions;
struct ShowOptions;
}  // namespace skein::terrain_tool
namespace skein::spy_tool {
struct SpyOptions;
struct RecordOptions;
struct PlayOptions;
}  // namespace skein::spy_tool

namespace skein::export_tool {
struct ExportOptions;
}

namespace skein::designer {
struct EditOptions;
}

namespace skein::import_tool {
struct ImportOptions;
}

namespace skein::operate_tool {
struct OperateOptions;
struct StatusOptions;
}  // namespace skein::operate_tool

namespace skein::state_tool {
struct StateOptions;
}

namespace skein::replay_tool {
struct ReplayOptions;
}

namespace skein::storm_tool {
struct StormOptions;
}

namespace skein::batch_tool {
struct BatchOptions;
}

namespace skein::compare_tool {
struct CompareOptions;
}

namespace skein::series_tool {
struct SeriesOptions;
}

namespace skein::cli {

/// What the commands that other programs carry out do with their options; each returns an exit
/// code.
struct LiveActions {
  std::function<int(const run_tool::RunOptions&)> run;
  std::function<int(const run_tool::ReportOptions&)> report;
  std::function<int(const spy_tool::SpyOptions&)> spy;
  std::function<int(const spy_tool::RecordOptions&)> record;
  std::function<int(const spy_tool::PlayOptions&)> play;
  std::function<int(const refine_tool::RefineOptions&)> refine;
  std::function<int(const terrain_tool::MakeOptions&)> make_terrain;
  std::function<int(const terrain_tool::ShowOptions&)> show_terrain;
  std::function<int(const functional_tool::FunctionalOptions&)> functional;
  std::function<int(const operate_tool::OperateOptions&)> operate;
  std::function<int(const operate_tool::StatusOptions&)> status;
  std::function<int(const state_tool::StateOptions&)> state;
  std::function<int(const replay_tool::ReplayOptions&)> replay;
  std::function<int(const storm_tool::StormOptions&)> storm;
  std::function<int(const batch_tool::BatchOptions&)> batch;
  std::function<int(const compare_tool::CompareOptions&)> compare;
  std::function<int(const series_tool::SeriesOptions&)> series;
  std::function<int(const export_tool::ExportOptions&)> export_run;
  std::function<int(const import_tool::ImportOptions&)> import_mission;
  std::function<int(const designer::EditOptions&)> edit_models;
};

/// Adds the commands. `action` and `live` must outlive the parsing and the action.
void add_live(CLI::App& app, std::function<int()>& action, const LiveActions& live);

}  // namespace skein::cli
