// SPDX-License-Identifier: Apache-2.0
// skein: everything that is not a daemon. Commands that need DDS are passed on to skein-live beside
// it, that which needs maps and motion planning to skein-refine: loading those libraries costs more
// than most plans.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "commands.hpp"
#include "live_commands.hpp"
#include "skein/foundation/exit_code.hpp"

namespace {

// Becomes that program, with the same arguments; returns only if that cannot be.
int become(const char* program, char** argv) {
  std::error_code none;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::string other = (self.parent_path() / program).string();
  execv(other.c_str(), argv);
  std::cerr << "skein: " << other << " cannot be started: " << std::strerror(errno) << '\n';
  if (errno == ENOENT) std::cerr << "skein: to build it: scripts/build release " << program << '\n';
  return skein::kExitSystem;
}

}  // namespace

int main(int argc, char** argv) {
  skein::cli::LiveActions live;
  live.run = [argv](const auto&) { return become("skein-live", argv); };
  live.report = [argv](const auto&) { return become("skein-live", argv); };
  live.state = [argv](const auto&) { return become("skein-live", argv); };
  live.replay = [argv](const auto&) { return become("skein-live", argv); };
  live.batch = [argv](const auto&) { return become("skein-live", argv); };
  live.compare = [argv](const auto&) { return become("skein-live", argv); };
  live.series = [argv](const auto&) { return become("skein-live", argv); };
  live.storm = [argv](const auto&) { return become("skein-live", argv); };
  live.functional = [argv](const auto&) { return become("skein-live", argv); };
  live.operate = [argv](const auto&) { return become("skein-live", argv); };
  live.status = [argv](const auto&) { return become("skein-live", argv); };
  live.spy = [argv](const auto&) { return become("skein-live", argv); };
  live.record = [argv](const auto&) { return become("skein-live", argv); };
  live.play = [argv](const auto&) { return become("skein-live", argv); };
  live.export_run = [argv](const auto&) { return become("skein-live", argv); };
  live.import_mission = [argv](const auto&) { return become("skein-live", argv); };
  live.edit_models = [argv](const auto&) { return become("skein-live", argv); };
  live.refine = [argv](const auto&) { return become("skein-refine", argv); };
  live.make_terrain = [argv](const auto&) { return become("skein-refine", argv); };
  live.show_terrain = [argv](const auto&) { return become("skein-refine", argv); };
  return skein::cli::run_command_line(argc, argv, live);
}
