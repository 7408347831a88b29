// SPDX-License-Identifier: Apache-2.0
#include "memory.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "skein/foundation/fingerprint.hpp"
#include "skein/scenario/scenario_print.hpp"
#include "skein/store/incarnation.hpp"

namespace skein::daemon_main {

Memory open_memory(const std::string& folder, const store::Identity& identity) {
  Memory memory;
  auto opened = store::SqliteInputLog::open(folder, identity);
  if (!opened && opened.error().in_use) {
    memory.in_use = opened.error().why + ": " + identity.node +
                    " runs already, and two of one name disturb each other (of another system? "
                    "then give --state a folder of its own)";
    return memory;
  }
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto clock = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  const auto next = store::next_incarnation(
      folder, identity.node, static_cast<std::uint64_t>(std::max<std::int64_t>(clock, 0)));
  if (next) {
    memory.incarnation = next->number;
    memory.first_life = next->first;
  } else {
    memory.notices.push_back("its incarnation is of the clock: " + next.error().why);
  }
  if (!opened) {
    memory.notices.push_back("nothing outlives this process: " + opened.error().why +
                             "; give --state a folder that it alone writes");
    return memory;
  }
  if (!opened->set_aside.empty()) memory.notices.push_back(opened->set_aside);
  memory.log = std::move(opened->log);
  return memory;
}

Refused refuse(store::SqliteInputLog& log, const std::string& node, const std::string& why) {
  const auto aside = log.start_anew();
  Refused refused{
      {"what was kept of " + node + " is not gone on from: " + why + (aside ? "; " + *aside : "")},
      aside.has_value()};
  if (!aside) refused.notices.push_back("nothing outlives this process: " + aside.error().why);
  return refused;
}

// What nodes need not agree on counts too: the node would else not do what it has done.
std::string identity_of_mission(const scenario::Scenario& scenario) {
  return std::filesystem::path(scenario.file).stem().string() + " " +
         scenario::print_of(scenario).text() + " " +
         fingerprint_text(scenario::print_of_own(scenario));
}

}  // namespace skein::daemon_main
