// SPDX-License-Identifier: Apache-2.0
// How long after a cut of ten seconds what was said in it is there: a state and five events from
// each of eight UAVs, and an order to each, over links that are all cut and healed at once.
//   skein_heal_time [GROUND [UAVS [ROUNDS]]]        each fastdds or cyclonedds
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"

namespace skein::blackboard::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kUavs = 8;
constexpr std::uint64_t kEvents = 5;
constexpr std::chrono::seconds kCut{10};
const Node kGround{NodeNumber(1), "ground"};

Node uav(std::uint32_t index) { return {NodeNumber(10 + index), "uav" + std::to_string(index)}; }

Now now() {
  const auto since = Clock::now().time_since_epoch();
  return {{}, Duration::nanoseconds(std::chrono::nanoseconds(since).count())};
}

/// All blackboards, in one thread.
class Team {
 public:
  Team(DdsVendor ground, DdsVendor uavs) {
    std::vector<ChannelConfig> all;
    for (std::uint32_t i = 0; i < kUavs; ++i) {
      const auto link = station_link(kGround, uav(i));
      add(uavs, uav(i), link);
      all.insert(all.end(), link.begin(), link.end());
    }
    add(ground, kGround, all);
  }

  void set_links(bool up) {
    const ChannelCondition condition{up, {}, 0};
    for (std::uint32_t i = 0; i < kUavs; ++i) {
      for (Blackboard* const end : {&board(kGround), &board(uav(i))}) {
        end->set_condition(kGround.number, uav(i).number, condition, now());
        end->set_condition(uav(i).number, kGround.number, condition, now());
      }
    }
  }
  /// Until the condition holds or so much time has passed; whether it holds.
  bool run(const std::function<bool()>& condition, Clock::duration limit) {
    const auto until = Clock::now() + limit;
    while (!condition() && Clock::now() < until) {
      for (Member& member : members_)
        for (Incoming& incoming : member.board->step(now())) take(member.node, incoming);
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, std::chrono::milliseconds(5), [this] { return arrived_; });
      arrived_ = false;
    }
    return condition();
  }
  Blackboard& board(const Node& node) {
    return *std::ranges::find(members_, node.number, [](const Member& one) {
              return one.node.number;
            })->board;
  }

  /// Of each UAV: what came in this round, and when all had.
  struct Link {
    bool state = false, order = false;
    std::set<std::uint64_t> events;
    std::optional<Clock::time_point> whole;
  };
  std::vector<Link> links{kUavs};

 private:
  struct Member {
    Node node;
    std::unique_ptr<Transport> transport;
    std::unique_ptr<Blackboard> board;
  };

  void add(DdsVendor vendor, const Node& node, const std::vector<ChannelConfig>& channels) {
    DdsConfig dds;
    dds.domain = lease_.domain();
    dds.network.dds = vendor;
    Member member{node, make_dds_transport(std::move(dds)), nullptr};
    member.transport->on_arrival([this] {
      const std::lock_guard lock(mutex_);
      arrived_ = true;
      wake_.notify_one();
    });
    Config config;
    config.self = node.number;
    config.channels = channels;
    config.heartbeat_period = Duration::milliseconds(250);  // as daemons
    member.board = std::make_unique<Blackboard>(
        Blackboard::open(std::move(config), *member.transport).value());
    members_.push_back(std::move(member));
  }
  void take(const Node& node, const Incoming& incoming) {
    const auto* received = std::get_if<Received>(&incoming);
    if (received == nullptr) return;
    const auto other = node.number == kGround.number ? received->origin : node.number;
    Link& link = links.at(other.value() - uav(0).number.value());
    if (const auto* state = std::get_if<wire::AutonomyDegree>(&received->sample)) {
      link.state = link.state || state->degree == 3;
    } else if (const auto* event = std::get_if<wire::TaskEvent>(&received->sample)) {
      link.events.insert(event->id);
    } else if (std::holds_alternative<wire::TaskRequest>(received->sample)) {
      link.order = true;
    }
    if (link.state && link.order && link.events.size() == kEvents && !link.whole)
      link.whole = Clock::now();
  }

  DomainLease lease_ = claim_domain().value();
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
  std::vector<Member> members_;
};

void say_all(Team& team) {
  for (std::uint32_t i = 0; i < kUavs; ++i) {
    wire::AutonomyDegree degree;
    degree.uav = uav(i).name;
    degree.degree = 3;
    static_cast<void>(team.board(uav(i)).send(degree, kGround.number, now()));
    for (std::uint64_t event = 1; event <= kEvents; ++event) {
      wire::TaskEvent sample;
      sample.id = event;
      static_cast<void>(team.board(uav(i)).send(sample, kGround.number, now()));
    }
    static_cast<void>(team.board(kGround).send(wire::TaskRequest{}, uav(i).number, now()));
  }
}

int run(DdsVendor ground, DdsVendor uavs, int rounds) {
  Team team(ground, uavs);
  const auto all_reach = [&] {
    for (std::uint32_t i = 0; i < kUavs; ++i)
      if (!team.board(kGround).reachable(uav(i).number) ||
          !team.board(uav(i)).reachable(kGround.number))
        return false;
    return true;
  };
  if (!team.run(all_reach, std::chrono::seconds(60))) return 1;
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    team.set_links(false);
    team.run([] { return false; }, kCut / 2);
    team.links.assign(kUavs, {});
    say_all(team);
    team.run([] { return false; }, kCut / 2);
    const auto healed = Clock::now();
    team.set_links(true);
    const auto whole = [&] {
      return std::ranges::all_of(team.links,
                                 [](const auto& link) { return link.whole.has_value(); });
    };
    if (!team.run(whole, std::chrono::seconds(30))) {
      std::printf("not whole 30 s after the cut\n");
      return 1;
    }
    for (const auto& link : team.links)
      times.push_back(std::chrono::duration<double>(*link.whole - healed).count());
    team.run(all_reach, std::chrono::seconds(30));
  }
  std::ranges::sort(times);
  const auto at = [&](double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  std::printf("ground on %s, UAVs on %s: median %.3f s, p99 %.3f s, most %.3f s, of %zu links\n",
              std::string(name_of(ground)).c_str(), std::string(name_of(uavs)).c_str(), at(0.5),
              at(0.99), times.back(), times.size());
  return 0;
}

}  // namespace
}  // namespace skein::blackboard::bench

int main(int argc, char** argv) {
  using skein::blackboard::dds_from_name;
  const auto ground = dds_from_name(argc > 1 ? argv[1] : "fastdds");
  const auto uavs = dds_from_name(argc > 2 ? argv[2] : "fastdds");
  if (!ground || !uavs) {
    std::fprintf(stderr, "skein_heal_time [GROUND [UAVS [ROUNDS]]]\n");
    return 2;
  }
  return skein::blackboard::bench::run(*ground, *uavs, argc > 3 ? std::stoi(argv[3]) : 10);
}
