// SPDX-License-Identifier: Apache-2.0
#include "fleet.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

namespace skein::run_tool {

namespace {

namespace fs = std::filesystem;

std::string own_folder() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  return error ? "." : self.parent_path().string();
}

}  // namespace

Fleet::Fleet(const scenario::Scenario& scenario, const DdsOptions& options, std::uint32_t domain)
    : scenario_(scenario),
      options_(options),
      domain_(domain),
      folder_(options.daemons.empty() ? own_folder() : options.daemons) {
  std::error_code ignored;
  fs::remove_all(state(), ignored);  // of a run before
}

std::vector<std::string> Fleet::names() const {
  std::vector<std::string> names{"sim", "ground"};
  for (const scenario::UavSpec& uav : scenario_.uavs) names.push_back(uav.name);
  for (const auto& [uav, layer] : scenario_.functional_layers()) {
    if (std::find(names.begin(), names.end(), layer) == names.end()) names.push_back(layer);
  }
  std::erase_if(names, [&](const std::string& name) {
    const auto& without = options_.without;
    return std::find(without.begin(), without.end(), name) != without.end();
  });
  return names;
}

std::string Fleet::program_of(const std::string& name) const {
  if (name == "ground") return "skein-ground";
  return scenario_.find_uav(name) == nullptr ? "skein-sim" : "skein-ddn";
}

std::string Fleet::log_of(const std::string& name) const {
  return (fs::path(options_.folder) / "logs" / (name + ".log")).string();
}

Result<void, Failure> Fleet::start(const std::string& name) {
  const std::string program = program_of(name);
  std::vector<std::string> command{(fs::path(folder_) / program).string(),
                                   "--scenario",
                                   scenario_.file,
                                   "--domain",
                                   std::to_string(domain_),
                                   "--dds",
                                   scenario_.dds_of(name),
                                   "--state",
                                   state(),
                                   "--exit-with-parent",
                                   std::to_string(getpid())};
  if (program == "skein-ddn") command.insert(command.end(), {"--uav", name});
  if (program == "skein-sim") command.insert(command.end(), {"--node", name});
  if (program == "skein-ground" && !options_.console.empty()) {
    command.insert(command.end(), {"--console", options_.console});
  }
  if (program == "skein-ground" && !options_.mavlink_out.empty()) {
    command.insert(command.end(), {"--mavlink-out", options_.mavlink_out});
  }
  if (program == "skein-ground" && options_.ros2) {
    command.insert(command.end(), {"--ros2", std::to_string(*options_.ros2)});
  }
  if (forgetful_.erase(name) > 0) command.emplace_back("--forgets");
  if (!options_.keys.empty()) command.insert(command.end(), {"--security", options_.keys});
  if (options_.types && announces_types(scenario_, name)) command.emplace_back("--types");
  command.insert(command.end(), options_.daemon_options.begin(), options_.daemon_options.end());
  auto process = Process::start(command, log_of(name));
  if (!process) return tl::unexpected(process.error());
  killed_.erase(name);
  running_.erase(name);
  running_.emplace(name, std::move(*process));
  return {};
}

std::string Fleet::state() const { return (fs::path(options_.folder) / "state").string(); }

void Fleet::forget(const std::string& name) {
  if (program_of(name) == "skein-sim") {
    forgetful_.insert(name);
    return;
  }
  std::error_code ignored;
  for (const char* file : {".state", ".state-wal", ".state-shm", ".complete"})
    fs::remove(fs::path(state()) / (name + file), ignored);
}

void Fleet::kill(const std::string& name) {
  const auto found = running_.find(name);
  if (found == running_.end()) return;
  killed_.insert(name);
  found->second.send(SIGKILL);
}

Deaths::Stage Fleet::stage_of(const std::string& name) const {
  if (running_.count(name) == 0) return Deaths::Stage::kDead;
  return killed_.count(name) > 0 ? Deaths::Stage::kDies : Deaths::Stage::kLives;
}

std::string Fleet::running_names() const {
  std::string names;
  for (const auto& [name, process] : running_) names += (names.empty() ? "" : ", ") + name;
  return names;
}

std::string Fleet::console_url() const {
  if (options_.console.empty()) return "";
  const std::string said = "console at ";
  std::ifstream log(log_of("ground"));
  for (std::string line; std::getline(log, line);) {
    const std::size_t at = line.find(said);
    if (at != std::string::npos)
      return line.substr(at + said.size(),
                         line.find_first_of(" \"", at + said.size()) - at - said.size());
  }
  return "";
}

void Fleet::signal_all(int signal) {
  for (const auto& [name, process] : running_) process.send(signal);
}

void Fleet::kill_all() { running_.clear(); }

std::vector<Fleet::Ended> Fleet::take_ended() {
  std::vector<Ended> ended;
  for (auto one = running_.begin(); one != running_.end();) {
    const auto status = one->second.poll();
    if (!status) {
      ++one;
      continue;
    }
    ended.push_back({one->first, program_of(one->first), log_of(one->first), *status,
                     killed_.count(one->first) > 0});
    one = running_.erase(one);
  }
  return ended;
}

}  // namespace skein::run_tool
