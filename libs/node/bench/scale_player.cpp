// SPDX-License-Identifier: Apache-2.0
#include "scale_player.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/node/roster.hpp"
#include "skein/node/waker.hpp"

namespace skein::node::bench {

namespace {

constexpr Duration kTurn = Duration::milliseconds(50);

Roster roster_of(int nodes) {
  std::vector<std::string> uavs;
  for (int i = 1; i <= nodes; ++i) uavs.push_back("uav" + std::to_string(i));
  return Roster(uavs);
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

blackboard::DdsConfig dds_config(const ScaleOptions& options, std::uint32_t domain,
                                 const std::string& name, const Roster& roster) {
  blackboard::DdsConfig config{domain, name, {}, {}, roster.names()};
  config.network.dds = blackboard::dds_from_name(options.dds).value_or(config.network.dds);
  config.network.types = options.types;
  config.endpoints_at_once = options.at_once;
  if (!options.server.empty()) config.network.discovery_servers = {options.server};
  return config;
}

/// One node on its blackboard.
class Player {
 public:
  Player(const ScaleOptions& options, std::uint32_t domain, const std::string& name)
      : roster_(roster_of(options.nodes)),
        transport_(blackboard::make_dds_transport(dds_config(options, domain, name, roster_))) {
    const Member& self = *roster_.find(name);
    blackboard::Config board;
    board.self = self.number;
    board.incarnation = static_cast<std::uint64_t>(Waker::steady_now().count());
    board.heartbeat_period = Duration::milliseconds(1000);
    board.world_reads = roster_.world_reads_of(self.role);
    for (auto& channel : roster_.channels_of(self)) {
      if (channel.kind == blackboard::ChannelKind::kOnboard) continue;  // no simulator is played
      if (channel.kind == blackboard::ChannelKind::kRadio)
        missing_.insert(channel.from == self.number ? channel.to : channel.from);
      board.channels.push_back(std::move(channel));
    }
    if (options.least) leave_one_writer_and_one_reader(board);
    transport_->on_arrival([this] { waker_.notify(); });
    auto opened = blackboard::Blackboard::open(std::move(board), *transport_);
    if (!opened) throw std::runtime_error(name + ": " + opened.error().why);
    board_.emplace(std::move(*opened));
    if (options.least) introduce(name);
  }

  /// Whether everybody was heard by then.
  bool meet(Duration until) {
    while (!missing_.empty() && goes_on(until)) turn(until);
    return missing_.empty();
  }
  void stay(Duration until) {
    while (goes_on(until)) turn(until);
  }

 private:
  static void leave_one_writer_and_one_reader(blackboard::Config& board) {
    std::erase_if(board.channels, [](const blackboard::ChannelConfig& channel) {
      return channel.kind != blackboard::ChannelKind::kWorld;
    });
    board.channels.front().slots = {wire::Slot::kDirectoryEntry};
    board.world_reads = {wire::Slot::kDirectoryEntry};
  }
  void introduce(const std::string& name) {
    wire::DirectoryEntry entry;
    entry.name = name;
    const auto sent = board_->publish(entry, blackboard::Now{{}, Waker::steady_now()});
    if (!sent) throw std::runtime_error(name + " cannot say its name");
  }
  bool goes_on(Duration until) const {
    return Waker::steady_now() < until && !waker_.stop_requested();
  }
  void turn(Duration until) {
    const Duration now = Waker::steady_now();
    for (const auto& incoming : board_->step(blackboard::Now{{}, now})) {
      const auto* reach = std::get_if<blackboard::Reachability>(&incoming);
      if (reach != nullptr && reach->reachable) missing_.erase(reach->peer);
      const auto* received = std::get_if<blackboard::Received>(&incoming);
      if (received != nullptr && received->channel == blackboard::ChannelKind::kWorld)
        missing_.erase(received->origin);
    }
    // Without a channel that has heartbeats nothing is due by itself.
    const Duration next = std::min(board_->next_wakeup().value_or(now + kTurn), until);
    waker_.wait(std::max(next - Waker::steady_now(), Duration()));
  }

  Waker waker_;  // first: it blocks signals for the middleware's threads too
  Roster roster_;
  std::unique_ptr<blackboard::Transport> transport_;
  std::optional<blackboard::Blackboard> board_;
  std::set<NodeNumber> missing_;
};

/// Lives on until there is a line on standard input.
void wait_for_word(Player& player) {
  for (pollfd input{STDIN_FILENO, POLLIN, 0}; poll(&input, 1, 0) == 0;)
    player.stay(Waker::steady_now() + kTurn);
  std::string word;
  std::getline(std::cin, word);
}

}  // namespace

int play_node(const ScaleOptions& options, std::uint32_t domain, const std::string& name,
              Duration begun) {
  const Duration start = Waker::steady_now();
  Player player(options, domain, name);
  Found found;
  found.opened = (Waker::steady_now() - start).to_seconds();
  if (player.meet(begun + Duration::seconds(options.limit)))
    found.matched = (Waker::steady_now() - begun).to_seconds();
  found.processor = processor_time();
  std::cout << found.matched << ' ' << found.opened << ' ' << found.processor << '\n' << std::flush;
  wait_for_word(player);
  const double before = processor_time();
  const Duration idle = Waker::steady_now();
  player.stay(idle + Duration::seconds(options.idle));
  found.idle = (processor_time() - before) / (Waker::steady_now() - idle).to_seconds();
  found.memory = private_megabytes();
  std::cout << found.idle << ' ' << found.memory << '\n' << std::flush;
  wait_for_word(player);
  return 0;
}

}  // namespace skein::node::bench
