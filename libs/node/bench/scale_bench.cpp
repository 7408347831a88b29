// SPDX-License-Identifier: Apache-2.0
// How a team of n decision nodes and a ground station meets over DDS, each in a process of its own with
// all the channels it has in flight: time until everybody has heard everybody, then memory and
// processor time of a node that only says that it is there.
//   skein_scale_bench NODES [--idle SECONDS] [--limit SECONDS] [--stagger MS] [--server ADDRESS:PORT]
//                     [--dds fastdds|cyclonedds] [--dds fastdds|cyclonedds]
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/node/roster.hpp"
#include "skein/node/waker.hpp"

namespace {

using namespace skein;  // NOLINT(google-build-using-namespace)
using blackboard::Now;
using node::Waker;

struct Options {
  int nodes = 4;
  double idle = 10, limit = 120;
  int stagger = 0;  ///< [ms] between two starts
  std::string server, dds;
};

/// What one node found out.
struct Found {
  double matched = -1;  ///< [s] since the first start; -1: not within the limit
  double opened = 0;    ///< [s] that opening the transport took
  double processor = 0; ///< [s] until it was matched
  double idle = 0;      ///< share of a processor afterwards
  double memory = 0;    ///< private [MB]
};

node::Roster roster_of(int nodes) {
  std::vector<std::string> uavs;
  for (int i = 1; i <= nodes; ++i) uavs.push_back("uav" + std::to_string(i));
  return node::Roster(uavs);
}

double processor_time() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double private_megabytes() {
  std::ifstream in("/proc/self/smaps_rollup");
  double kilobytes = 0;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("Private_")) continue;
    std::istringstream words(line.substr(line.find(':') + 1));
    double more = 0;
    words >> more;
    kilobytes += more;
  }
  return kilobytes / 1024;
}

/// One node on its blackboard.
class Player {
 public:
  Player(const Options& options, std::uint32_t domain, const std::string& name)
      : roster_(roster_of(options.nodes)), transport_(blackboard::make_dds_transport(config(options, domain, name, roster_))) {
    const node::Member& self = *roster_.find(name);
    blackboard::Config board;
    board.self = self.number;
    board.incarnation = static_cast<std::uint64_t>(Waker::steady_now().count());
    board.heartbeat_period = Duration::milliseconds(1000);
    board.world_reads = node::Roster::world_reads_of(self.role);
    for (auto& channel : roster_.channels_of(self)) {
      if (channel.kind == blackboard::ChannelKind::kOnboard) continue;  // no simulator is played
      if (channel.kind == blackboard::ChannelKind::kRadio)
        missing_.insert(channel.from == self.number ? channel.to : channel.from);
      board.channels.push_back(std::move(channel));
    }
    transport_->on_arrival([this] { waker_.notify(); });
    auto opened = blackboard::Blackboard::open(std::move(board), *transport_);
    if (!opened) {
      std::cerr << name << ": " << opened.error().why << '\n';
      std::exit(3);
    }
    board_.emplace(std::move(*opened));
  }

  /// True if everybody was heard by then.
  bool meet(Duration until) {
    while (!missing_.empty() && Waker::steady_now() < until && !waker_.stop_requested()) turn(until);
    return missing_.empty();
  }
  void stay(Duration until) {
    while (Waker::steady_now() < until && !waker_.stop_requested()) turn(until);
  }

 private:
  static blackboard::DdsConfig config(const Options& options, std::uint32_t domain,
                                          const std::string& name, const node::Roster& roster) {
    blackboard::DdsConfig config{domain, name, {}, {}, roster.names()};
    config.network.dds = blackboard::dds_from_name(options.dds).value_or(config.network.dds);
    if (!options.server.empty()) config.network.discovery_servers = {options.server};
    return config;
  }
  void turn(Duration until) {
    const Duration now = Waker::steady_now();
    for (const auto& incoming : board_->step(Now{{}, now}))
      if (const auto* reach = std::get_if<blackboard::Reachability>(&incoming))
        if (reach->reachable) missing_.erase(reach->peer);
    const Duration next = std::min(board_->next_wakeup().value_or(until), until);
    waker_.wait(std::max(next - Waker::steady_now(), Duration()));
  }

  Waker waker_;  // first: it blocks signals for the middleware's threads too
  node::Roster roster_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::optional<blackboard::Blackboard> board_;
  std::set<node::NodeNumber> missing_;
};

int child(const Options& options, char** argv) {
  const auto domain = static_cast<std::uint32_t>(std::stoul(argv[2]));
  const std::string name = argv[3];
  const Duration begun = Duration::nanoseconds(std::stoll(argv[4]));
  const Duration start = Waker::steady_now();
  Found found;
  Player player(options, domain, name);
  found.opened = (Waker::steady_now() - start).to_seconds();
  if (player.meet(begun + Duration::seconds(options.limit)))
    found.matched = (Waker::steady_now() - begun).to_seconds();
  found.processor = processor_time();
  std::cout << found.matched << ' ' << found.opened << ' ' << found.processor << '\n' << std::flush;
  std::string word;
  for (pollfd input{STDIN_FILENO, POLLIN, 0}; poll(&input, 1, 0) == 0;)  // the others have not met
    player.stay(Waker::steady_now() + Duration::milliseconds(50));
  std::getline(std::cin, word);
  const double before = processor_time();
  const Duration idle = Waker::steady_now();
  player.stay(idle + Duration::seconds(options.idle));
  found.idle = (processor_time() - before) / (Waker::steady_now() - idle).to_seconds();
  std::cout << found.idle << ' ' << private_megabytes() << '\n' << std::flush;
  std::getline(std::cin, word);
  return 0;
}

/// A process of one node, and what it says.
struct Process {
  std::string name;
  pid_t pid = -1;
  FILE* says = nullptr;
  int hears = -1;
};

Process start(const char* self, const std::vector<std::string>& words, const std::string& name) {
  int out[2], in[2];
  if (pipe(out) != 0 || pipe(in) != 0) std::exit(3);
  const pid_t pid = fork();
  if (pid == 0) {
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    for (const int one : {out[0], out[1], in[0], in[1]}) close(one);
    std::vector<char*> argv{const_cast<char*>(self)};
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execv("/proc/self/exe", argv.data());
    _exit(3);
  }
  close(out[1]);
  close(in[0]);
  return {name, pid, fdopen(out[0], "r"), in[1]};
}

void tell(const std::vector<Process>& processes) {
  for (const Process& one : processes) (void)!write(one.hears, "\n", 1);
}

double greatest(const std::vector<Found>& all, double Found::*of) {
  double most = 0;
  for (const Found& one : all) most = std::max(most, one.*of);
  return most;
}

double mean(const std::vector<Found>& all, double Found::*of) {
  double sum = 0;
  for (const Found& one : all) sum += one.*of;
  return all.empty() ? 0 : sum / static_cast<double>(all.size());
}

int measure(const Options& options, int argc, char** argv) {
  const auto lease = blackboard::claim_domain();
  if (!lease) return 3;
  std::vector<std::string> names{"ground"};
  for (int i = 1; i <= options.nodes; ++i) names.push_back("uav" + std::to_string(i));
  std::vector<Process> processes;
  const std::string begun = std::to_string(Waker::steady_now().count());
  for (const std::string& name : names) {
    std::vector<std::string> words{"--child", std::to_string(lease->domain()), name, begun};
    words.insert(words.end(), argv + 1, argv + argc);
    processes.push_back(start(argv[0], words, name));
    if (options.stagger > 0) poll(nullptr, 0, options.stagger);
  }
  std::vector<Found> all(processes.size());
  std::size_t met = 0;
  for (std::size_t i = 0; i < processes.size(); ++i) {
    const int read = std::fscanf(processes[i].says, "%lf %lf %lf", &all[i].matched, &all[i].opened, &all[i].processor);
    met += read == 3 && all[i].matched >= 0 ? 1 : 0;
  }
  tell(processes);
  for (std::size_t i = 0; i < processes.size(); ++i)
    (void)!std::fscanf(processes[i].says, "%lf %lf", &all[i].idle, &all[i].memory);
  tell(processes);
  for (const Process& one : processes) waitpid(one.pid, nullptr, 0);
  std::printf("| %d | %zu of %zu | %.1f | %.1f | %.2f, %.2f | %.1f, %.1f | %.2f, %.2f |\n", options.nodes, met,
              processes.size(), met == processes.size() ? greatest(all, &Found::matched) : -1.0,
              greatest(all, &Found::opened), mean(all, &Found::processor), greatest(all, &Found::processor),
              mean(all, &Found::memory), greatest(all, &Found::memory), 100 * mean(all, &Found::idle),
              100 * greatest(all, &Found::idle));
  return met == processes.size() ? 0 : 1;
}

Options options_of(const std::vector<std::string>& words) {
  Options options;
  options.nodes = std::stoi(words.at(0));
  for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
    if (words[i] == "--idle") options.idle = std::stod(words[i + 1]);
    if (words[i] == "--limit") options.limit = std::stod(words[i + 1]);
    if (words[i] == "--stagger") options.stagger = std::stoi(words[i + 1]);
    if (words[i] == "--server") options.server = words[i + 1];
    if (words[i] == "--dds") options.dds = words[i + 1];
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) try {
  const bool is_child = argc > 5 && std::strcmp(argv[1], "--child") == 0;
  const std::vector<std::string> words(argv + (is_child ? 5 : 1), argv + argc);
  if (words.empty()) {
    std::cerr << "skein_scale_bench NODES [--idle S] [--limit S] [--stagger MS] [--server ADDRESS:PORT]\n"
                 "| nodes | met | all met [s] | opened [s] | processor until then, mean and most [s] "
                 "| private memory [MB] | idle [% of a processor] |\n";
    return 2;
  }
  const Options options = options_of(words);
  return is_child ? child(options, argv) : measure(options, argc, argv);
} catch (const std::exception& error) {
  std::cerr << "skein_scale_bench: " << error.what() << '\n';
  return 2;
}
