// SPDX-License-Identifier: Apache-2.0
#include "station.hpp"

#include <algorithm>
#include <filesystem>
#include <random>

#include "skein/blackboard/link_instance.hpp"
#include "skein/node/roster.hpp"

namespace skein::operate_tool {

namespace {

constexpr const char* kName = "operator";

/// Its own folder in that of make-keys, or the folder itself on a machine that has only its own.
std::string keys_of(const std::string& folder) {
  const std::filesystem::path own = std::filesystem::path(folder) / kName;
  return !folder.empty() && std::filesystem::is_directory(own) ? own.string() : folder;
}

}  // namespace

bool Boards::complete() const {
  return ground && std::all_of(ground->uavs.begin(), ground->uavs.end(), [this](const auto& uav) {
           return uavs.contains(uav) && tasks.contains(uav);
         });
}

Result<void, Failure> Station::open() {
  const node::Roster roster({});
  blackboard::NetworkConfig network = options_.network;
  network.keys = keys_of(network.keys);
  transport_ =
      blackboard::make_dds_transport({options_.domain, kName, network, {}, roster.names()});
  transport_->on_arrival([this] { waker_.notify(); });
  std::random_device random;
  instance_ = random();
  blackboard::Config config;
  config.self = roster.operators();
  config.incarnation = static_cast<std::uint64_t>(node::Waker::steady_now().count());
  config.channels = roster.channels_of(*roster.find(kName));
  config.world_reads = roster.world_reads_of(wire::Role::kOperator);
  auto board = blackboard::Blackboard::open(std::move(config), *transport_);
  if (!board) return tl::unexpected(board.error());
  board_.emplace(std::move(*board));
  return {};
}

blackboard::Now Station::now() {
  const Duration steady = node::Waker::steady_now();
  return {clock_.now(steady), steady};
}

MissionTime Station::mission_time() { return now().mission; }

bool Station::listen(double seconds, const std::function<bool()>& done) {
  const Duration until = node::Waker::steady_now() + Duration::seconds(seconds);
  while (true) {
    take();
    if (done()) return true;
    const Duration left = until - node::Waker::steady_now();
    if (left <= Duration() || interrupted()) return false;
    waker_.wait(left);
  }
}

void Station::take() {
  for (const auto& incoming : board_->step(now())) {
    if (const auto* received = std::get_if<blackboard::Received>(&incoming)) {
      take(received->sample);
    }
  }
}

void Station::take(const wire::Sample& sample) {
  if (const auto* clock = std::get_if<wire::Clock>(&sample)) {
    clock_.update(*clock, node::Waker::steady_now());
    clock_heard_ = true;
  } else if (const auto* link = std::get_if<wire::LinkState>(&sample)) {
    if (blackboard::is_of_one(*link)) boards_.links.insert_or_assign(link->header.instance, *link);
  } else if (const auto* ground = std::get_if<wire::GroundBoard>(&sample)) {
    boards_.ground = *ground;
  } else if (const auto* uav = std::get_if<wire::UavBoard>(&sample)) {
    boards_.uavs.insert_or_assign(uav->uav, *uav);
  } else if (const auto* tasks = std::get_if<wire::UavTasks>(&sample)) {
    boards_.tasks.insert_or_assign(tasks->uav, *tasks);
  } else if (const auto* reply = std::get_if<wire::OperatorReply>(&sample)) {
    answers_.insert_or_assign({reply->who, reply->number}, *reply);
  }
}

void Station::ask(const wire::OperatorRequest& request) {
  wire::OperatorRequest sample = request;
  sample.header.instance = instance_;
  (void)board_->publish(sample, now());  // what is malformed was refused before
}

std::optional<wire::OperatorReply> Station::answer(const std::string& who,
                                                   std::uint64_t number) const {
  const auto found = answers_.find({who, number});
  return found == answers_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace skein::operate_tool
