// SPDX-License-Identifier: Apache-2.0
// How long an event takes over DDS on a channel of 9,600 bit/s that carries nothing else, and on
// one that telemetry of three UAVs, ten times a second each, fills. Loopback has no airtime: that
// of the event itself is added to what it waited.
//   skein_saturated_latency [DDS [EVENTS]]          fastdds or cyclonedds
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"

namespace skein::blackboard::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kCapacity = 9'600;
constexpr std::uint32_t kOrigins = 3;
constexpr std::chrono::milliseconds kTelemetry{100}, kEvent{1'711};
const Node kUav{NodeNumber(2), "marvin"};
const Node kGround{NodeNumber(1), "ground"};

Now now() {
  const auto since = Clock::now().time_since_epoch();
  return {{}, Duration::nanoseconds(std::chrono::nanoseconds(since).count())};
}

wire::Telemetry telemetry(std::uint32_t origin) {
  wire::Telemetry sample;
  sample.header.instance = origin;
  sample.uav = "marvin";
  sample.position = {312.5F, -41.25F, 60};
  sample.activity = "goto";
  sample.airborne = true;
  return sample;
}

wire::TaskEvent event(std::uint64_t id) {
  wire::TaskEvent sample;
  sample.uav = "marvin";
  sample.id = id;
  sample.type = "goto";
  return sample;
}

/// Both ends of the channel, in one thread.
class Pair {
 public:
  explicit Pair(DdsVendor vendor) {
    for (const Node& node : {kUav, kGround}) {
      DdsConfig dds;
      dds.domain = lease_.domain();
      dds.network.dds = vendor;
      End end{make_dds_transport(std::move(dds)), nullptr};
      end.transport->on_arrival([this] {
        const std::lock_guard lock(mutex_);
        arrived_ = true;
        wake_.notify_one();
      });
      Config config;
      config.self = node.number;
      config.channels = station_link(kGround, kUav);
      for (ChannelConfig& channel : config.channels) channel.capacity = kCapacity;
      config.heartbeat_period = Duration::milliseconds(1'000);
      end.board =
          std::make_unique<Blackboard>(Blackboard::open(std::move(config), *end.transport).value());
      ends_.push_back(std::move(end));
    }
  }

  bool meet() {
    const auto limit = Clock::now() + std::chrono::seconds(60);
    while (Clock::now() < limit &&
           !(uav().reachable(kGround.number) && ends_[1].board->reachable(kUav.number)))
      turn();
    return uav().reachable(kGround.number);
  }
  /// Seconds from when each of so many events was sent until it was there.
  std::vector<double> latencies(std::uint64_t events, bool is_saturated) {
    taken_.clear();
    auto next_event = Clock::now() + kEvent, next_telemetry = Clock::now();
    std::uint64_t sent = 0;
    const auto limit = Clock::now() + (events + 20) * kEvent;
    while (taken_.size() < events && Clock::now() < limit) {
      for (; is_saturated && next_telemetry <= Clock::now(); next_telemetry += kTelemetry)
        for (std::uint32_t i = 0; i < kOrigins; ++i)
          static_cast<void>(uav().send(telemetry(i), kGround.number, now()));
      if (sent < events && next_event <= Clock::now()) {
        next_event += kEvent;
        sent_[++last_] = Clock::now();
        ++sent;
        static_cast<void>(uav().send(event(last_), kGround.number, now()));
      }
      turn();
    }
    return taken_;
  }

 private:
  struct End {
    std::unique_ptr<Transport> transport;
    std::unique_ptr<Blackboard> board;
  };
  Blackboard& uav() { return *ends_[0].board; }
  void turn() {
    for (End& end : ends_)
      for (const Incoming& incoming : end.board->step(now())) take(incoming);
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, std::chrono::milliseconds(1), [this] { return arrived_; });
    arrived_ = false;
  }
  void take(const Incoming& incoming) {
    const auto* received = std::get_if<Received>(&incoming);
    const auto* one =
        received == nullptr ? nullptr : std::get_if<wire::TaskEvent>(&received->sample);
    if (one == nullptr) return;
    const std::chrono::duration<double> waited = Clock::now() - sent_.at(one->id);
    taken_.push_back(waited.count() +
                     airtime(channel_bytes(received->sample), kCapacity).to_seconds());
  }

  DomainLease lease_ = claim_domain().value();
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
  std::vector<End> ends_;
  std::map<std::uint64_t, Clock::time_point> sent_;
  std::uint64_t last_ = 0;
  std::vector<double> taken_;
};

double quantile(std::vector<double> all, double share) {
  std::ranges::sort(all);
  return all.at(static_cast<std::size_t>(share * static_cast<double>(all.size() - 1)));
}

int run(DdsVendor vendor, std::uint64_t events) {
  Pair pair(vendor);
  if (!pair.meet()) return 1;
  const auto quiet = pair.latencies(events, false);
  const auto full = pair.latencies(events, true);
  if (quiet.size() < events || full.size() < events) {
    std::printf("events did not come: %zu and %zu of %zu\n", quiet.size(), full.size(),
                static_cast<std::size_t>(events));
    return 1;
  }
  std::printf("%s: an event of %zu bytes, telemetry of %zu\n", std::string(name_of(vendor)).c_str(),
              channel_bytes(event(1)), channel_bytes(telemetry(1)));
  for (const double share : {0.5, 0.95, 0.99})
    std::printf("  %2.0f %%: %.3f s unloaded, %.3f s saturated: %.2f times\n", 100 * share,
                quantile(quiet, share), quantile(full, share),
                quantile(full, share) / quantile(quiet, share));
  return 0;
}

}  // namespace
}  // namespace skein::blackboard::bench

int main(int argc, char** argv) {
  const auto vendor = skein::blackboard::dds_from_name(argc > 1 ? argv[1] : "fastdds");
  if (!vendor) {
    std::fprintf(stderr, "skein_saturated_latency [DDS [EVENTS]]\n");
    return 2;
  }
  return skein::blackboard::bench::run(*vendor, argc > 2 ? std::stoul(argv[2]) : 60);
}
