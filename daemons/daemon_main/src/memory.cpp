// SPDX-License-Identifier: Apache-2.0
#include "memory.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "skein/foundation/fingerprint.hpp"
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

std::string identity_of_mission(const std::string& scenario_file,
                                const scenario_setup::Overrides& overrides) {
  std::ifstream file(scenario_file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Fingerprint print;
  print.put(text).put(overrides.seed.value_or(0)).put(std::uint64_t{overrides.seed.has_value()});
  for (const std::string& degree : overrides.degrees) print.put(degree);
  return std::filesystem::path(scenario_file).stem().string() + " " + std::to_string(print.value());
}

}  // namespace skein::daemon_main
