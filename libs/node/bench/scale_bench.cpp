// SPDX-License-Identifier: Apache-2.0
// How a team of n decision nodes and a ground station meets over DDS, each in a process of its own
// with all the channels it has in flight: time until everybody has heard everybody, then memory and
// processor time of a node that only says that it is there.
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "scale_player.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/node/waker.hpp"

namespace {

using skein::node::Waker;
using skein::node::bench::Found;
using skein::node::bench::ScaleOptions;

constexpr const char* kUsage =
    R"(skein_scale_bench NODES [--dds fastdds|cyclonedds] [--server ADDRESS:PORT] [--idle SECONDS]
                  [--limit SECONDS] [--stagger MILLISECONDS] [--at-once yes] [--least yes]
                  [--types yes]
A row: nodes beside the ground station | who met all others | until the last did [s]
| opening the transport, most [s] | processor until then, mean and most [s]
| private memory, mean and most [MB] | idle, mean and most [% of a processor]
)";

/// The options of the program, and of itself as a child: "--child DOMAIN NAME BEGUN" before them.
ScaleOptions options_of(const std::vector<std::string>& words) {
  ScaleOptions options;
  options.nodes = std::stoi(words.at(0));
  for (std::size_t i = 1; i < words.size(); i += 2) {
    const std::string& value = words.at(i + 1);
    if (words[i] == "--idle") options.idle = std::stod(value);
    if (words[i] == "--limit") options.limit = std::stod(value);
    if (words[i] == "--stagger") options.stagger = std::stoi(value);
    if (words[i] == "--server") options.server = value;
    if (words[i] == "--dds") options.dds = value;
    if (words[i] == "--types") options.types = value == "yes";
    if (words[i] == "--at-once") options.at_once = value == "yes";
    if (words[i] == "--least") options.least = value == "yes";
  }
  return options;
}

/// A process of one node, what it says, and where it is told to go on.
struct Process {
  pid_t pid = -1;
  FILE* says = nullptr;
  int hears = -1;
};

Process start(const std::vector<std::string>& words) {
  std::array<int, 2> out{}, in{};
  if (pipe(out.data()) != 0 || pipe(in.data()) != 0) throw std::runtime_error("no pipes are left");
  const pid_t pid = fork();
  if (pid == 0) {
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    for (const int one : {out[0], out[1], in[0], in[1]}) close(one);
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execv("/proc/self/exe", argv.data());
    _exit(3);
  }
  close(out[1]);
  close(in[0]);
  return {pid, fdopen(out[0], "r"), in[1]};
}

void tell_to_go_on(const std::vector<Process>& processes) {
  for (const Process& one : processes)
    if (write(one.hears, "\n", 1) != 1) std::cerr << "a node is dead\n";
}

double greatest(const std::vector<Found>& all, double Found::*of) {
  double most = 0;
  for (const Found& one : all) most = std::max(most, one.*of);
  return most;
}

double mean(const std::vector<Found>& all, double Found::*of) {
  const double sum =
      std::accumulate(all.begin(), all.end(), 0.0,
                      [of](double so_far, const Found& one) { return so_far + one.*of; });
  return sum / static_cast<double>(all.size());
}

std::vector<Process> start_all(const ScaleOptions& options, std::uint32_t domain,
                               const std::vector<std::string>& own_words) {
  std::vector<std::string> names{"ground"};
  for (int i = 1; i <= options.nodes; ++i) names.push_back("uav" + std::to_string(i));
  const std::string begun = std::to_string(Waker::steady_now().count());
  std::vector<Process> processes;
  for (const std::string& name : names) {
    std::vector<std::string> words{"node", "--child", std::to_string(domain), name, begun};
    words.insert(words.end(), own_words.begin(), own_words.end());
    processes.push_back(start(words));
    if (options.stagger > 0) poll(nullptr, 0, options.stagger);
  }
  return processes;
}

int measure(const ScaleOptions& options, const std::vector<std::string>& words) {
  const auto lease = skein::blackboard::claim_domain();
  if (!lease) throw std::runtime_error(lease.error().why);
  const std::vector<Process> processes = start_all(options, lease->domain(), words);
  std::vector<Found> all(processes.size());
  std::size_t met = 0;
  for (std::size_t i = 0; i < processes.size(); ++i) {
    Found& one = all[i];
    const int read =
        std::fscanf(processes[i].says, "%lf %lf %lf", &one.matched, &one.opened, &one.processor);
    met += read == 3 && one.matched >= 0 ? 1 : 0;
  }
  tell_to_go_on(processes);
  bool whole = met == all.size();
  for (std::size_t i = 0; i < processes.size(); ++i)
    whole = std::fscanf(processes[i].says, "%lf %lf", &all[i].idle, &all[i].memory) == 2 && whole;
  tell_to_go_on(processes);
  for (const Process& one : processes) waitpid(one.pid, nullptr, 0);
  std::printf("| %d | %zu of %zu | %.1f | %.2f | %.2f, %.2f | %.1f, %.1f | %.2f, %.2f |\n",
              options.nodes, met, all.size(), whole ? greatest(all, &Found::matched) : -1.0,
              greatest(all, &Found::opened), mean(all, &Found::processor),
              greatest(all, &Found::processor), mean(all, &Found::memory),
              greatest(all, &Found::memory), 100 * mean(all, &Found::idle),
              100 * greatest(all, &Found::idle));
  return whole ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const bool is_child = argc > 5 && std::strcmp(argv[1], "--child") == 0;
  const std::vector<std::string> words(argv + (is_child ? 5 : 1), argv + argc);
  if (words.empty()) {
    std::cerr << kUsage;
    return 2;
  }
  const ScaleOptions options = options_of(words);
  if (!is_child) return measure(options, words);
  const auto domain = static_cast<std::uint32_t>(std::stoul(argv[2]));
  return skein::node::bench::play_node(options, domain, argv[3],
                                       skein::Duration::nanoseconds(std::stoll(argv[4])));
} catch (const std::exception& error) {
  std::cerr << "skein_scale_bench: " << error.what() << '\n' << kUsage;
  return 2;
}
