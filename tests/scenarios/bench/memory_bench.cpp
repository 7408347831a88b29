// SPDX-License-Identifier: Apache-2.0
// What a long mission leaves on disk, and what it takes to come back to it: the patrol of the long
// runs in virtual time, each node with a state file. Arguments: hours (1), folder (out/memory),
// "again": what is in the folder already, of that many hours, is come back to.
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "skein/assembly/assembly.hpp"
#include "skein/blackboard/cdr.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "skein/store/sqlite_input_log.hpp"
#include "skein/store/state_file.hpp"
#include "testing/patrol.hpp"

namespace skein::testing {
namespace {

namespace fs = std::filesystem;
using Logs = std::map<std::string, std::unique_ptr<store::SqliteInputLog>>;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void fly(const scenario::Scenario& scenario, const fs::path& folder) {
  Logs logs;
  node::VirtualConfig config = assembly::virtual_config(scenario);
  config.memory_of = [&](const std::string& name) -> node::InputLog* {
    auto& log = logs[name];
    if (log == nullptr) log = std::move(store::SqliteInputLog::open(folder, {name, "patrol"})->log);
    return log.get();
  };
  const double begin = processor_seconds();
  node::run_virtual(
      scenario_setup::roster_of(scenario),
      [&](const std::string& name) { return assembly::make_node(scenario, name); }, config,
      [](const journal::Record&) {});
  std::printf("flown in %.1f s\n", processor_seconds() - begin);
}

void come_back(const scenario::Scenario& scenario, const fs::path& folder,
               const std::string& name) {
  const auto opened = store::SqliteInputLog::open(folder, {name, "patrol"});
  const double begin = processor_seconds();
  const auto read =
      opened->log->recall([](const node::LogEntry&) { return Result<void, Failure>(); });
  const double mid = processor_seconds();
  const auto right = node::explains(*opened->log, *assembly::make_node(scenario, name));
  const double end = processor_seconds();
  const auto found = store::examine(folder / (name + ".state"));
  std::printf("%s: %.2f MB, %lu inputs; read in %.2f s, lived again in %.2f s%s\n", name.c_str(),
              1e-6 * static_cast<double>(found->bytes), found->inputs, mid - begin, end - mid,
              read && right ? "" : ": NOT EXPLAINED");
  std::map<std::string, std::uint64_t> bytes;
  (void)store::for_each_input(
      folder / (name + ".state"), [&](std::uint64_t, const node::LogEntry& entry) {
        const auto* one = std::get_if<node::Received>(&entry.input);
        if (one == nullptr) return;
        bytes["received " + std::string(wire::slot_name(wire::slot_of(one->sample)))] +=
            blackboard::encoded_size(one->sample);
      });
  for (const auto& [kind, times] : found->by_kind)
    std::printf("    %-32s %8lu %8.1f kB\n", kind.c_str(), times,
                1e-3 * static_cast<double>(bytes[kind]));
}

}  // namespace
}  // namespace skein::testing

int main(int count, char** arguments) {
  const int hours = count > 1 ? std::atoi(arguments[1]) : 1;
  const std::filesystem::path folder = count > 2 ? arguments[2] : "out/memory";
  const bool again = count > 3 && arguments[3] == std::string("again");
  const auto scenario = skein::testing::patrol_of(hours);
  if (!again) {
    std::filesystem::remove_all(folder);
    skein::testing::fly(scenario, folder);
  }
  const auto roster = skein::scenario_setup::roster_of(scenario);
  for (const auto& member : roster.members()) {
    if (std::filesystem::exists(folder / (member.name + ".state")))
      skein::testing::come_back(scenario, folder, member.name);
  }
}
