// SPDX-License-Identifier: Apache-2.0
// Round trip of an event slot between two processes, through the blackboard and through the bare
// DDS below it, in alternating blocks of one run:
//   skein_event_latency [fastdds|cyclonedds [BLOCKS [ROUND_TRIPS_PER_BLOCK]]]
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "bare_pair.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"

namespace skein::blackboard::bench {
namespace {

using Clock = std::chrono::steady_clock;

const Node kAsker{NodeNumber(1), "asker"};
const Node kAnswerer{NodeNumber(2), "answerer"};

/// A blackboard with its one thread: sleeps until something arrives or is due.
class BlackboardSide {
 public:
  BlackboardSide(DdsVendor vendor, std::uint32_t domain, const Node& self)
      : transport_(transport(vendor, domain)) {
    transport_->on_arrival([this] {
      const std::lock_guard lock(mutex_);
      arrived_ = true;
      wake_.notify_one();
    });
    Config config;
    config.self = self.number;
    config.channels = station_link(kAsker, kAnswerer);
    board_ = std::make_unique<Blackboard>(Blackboard::open(std::move(config), *transport_).value());
  }

  Blackboard& board() { return *board_; }
  static Now now() {
    const auto since = Clock::now().time_since_epoch();
    return {{}, Duration::nanoseconds(std::chrono::nanoseconds(since).count())};
  }
  std::vector<Incoming> wait() {
    std::unique_lock lock(mutex_);
    const Duration until = board_->next_wakeup().value_or(now().steady + Duration::seconds(1));
    wake_.wait_until(lock, Clock::time_point(std::chrono::nanoseconds(until.count())),
                     [this] { return arrived_; });
    arrived_ = false;
    lock.unlock();
    return board_->step(now());
  }

 private:
  static std::unique_ptr<Transport> transport(DdsVendor vendor, std::uint32_t domain) {
    DdsConfig config;
    config.domain = domain;
    config.network.dds = vendor;
    return make_dds_transport(std::move(config));
  }

  std::unique_ptr<Transport> transport_;
  std::unique_ptr<Blackboard> board_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
};

bool ask(BlackboardSide& side, std::uint64_t command) {
  wire::TaskRequest request;
  request.command = command;
  request.task.id = command;
  request.task.type = "goto";
  request.task.parameters.push_back({"to", "", {100.0, 200.0, 50.0}});
  if (!side.board().send(std::move(request), kAnswerer.number, BlackboardSide::now())) return false;
  const auto deadline = Clock::now() + std::chrono::seconds(5);
  while (Clock::now() < deadline) {
    for (const Incoming& incoming : side.wait()) {
      const auto* received = std::get_if<Received>(&incoming);
      if (received == nullptr) continue;
      const auto* reply = std::get_if<wire::RequestReply>(&received->sample);
      if (reply != nullptr && reply->command == command) return true;
    }
  }
  return false;
}

[[noreturn]] void answer(DdsVendor vendor, std::uint32_t domain) {
  std::thread([=] { make_bare_side(vendor, domain, BareSide::Role::kAnswers)->serve(); }).detach();
  BlackboardSide side(vendor, domain, kAnswerer);
  while (true) {
    for (const Incoming& incoming : side.wait()) {
      const auto* received = std::get_if<Received>(&incoming);
      if (received == nullptr) continue;
      const auto* request = std::get_if<wire::TaskRequest>(&received->sample);
      if (request == nullptr) continue;
      wire::RequestReply reply;
      reply.command = request->command;
      reply.accepted = true;
      if (!side.board().send(reply, received->origin, BlackboardSide::now())) std::abort();
    }
  }
}

/// Round trips [µs]; an empty result is a failure.
using Series = std::vector<double>;

bool measure(const std::function<bool(std::uint64_t)>& ask_one, std::uint64_t count,
             Series& series) {
  static std::uint64_t command = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto start = Clock::now();
    if (!ask_one(++command)) return false;
    series.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
  }
  return true;
}

double quantile(Series& series, double share) {
  std::ranges::sort(series);
  return series[static_cast<std::size_t>(share * static_cast<double>(series.size() - 1))];
}

int run(DdsVendor vendor, std::uint32_t domain, std::uint64_t blocks, std::uint64_t per_block) {
  BlackboardSide side(vendor, domain, kAsker);
  const auto bare = make_bare_side(vendor, domain, BareSide::Role::kAsks);
  const auto ask_board = [&](std::uint64_t command) { return ask(side, command); };
  const auto ask_bare = [&](std::uint64_t command) { return bare->ask(command); };
  const auto give_up = Clock::now() + std::chrono::seconds(30);
  while (!side.board().reachable(kAnswerer.number) && Clock::now() < give_up) side.wait();
  Series ignored;
  Series board_series;
  Series bare_series;
  bool good = measure(ask_board, 200, ignored) && measure(ask_bare, 200, ignored);
  for (std::uint64_t block = 0; good && block < blocks; ++block) {
    good = measure(ask_board, per_block, board_series) && measure(ask_bare, per_block, bare_series);
  }
  if (!good) {
    std::fprintf(stderr, "no answer\n");
    return 1;
  }
  const double board_median = quantile(board_series, 0.5);
  const double bare_median = quantile(bare_series, 0.5);
  std::printf("round trip [us]   median      p99\n");
  std::printf("blackboard      %8.1f %8.1f\n", board_median, quantile(board_series, 0.99));
  const double board_p99 = quantile(board_series, 0.99);
  const double bare_p99 = quantile(bare_series, 0.99);
  std::printf("bare %-10s %8.1f %8.1f\n", std::string(name_of(vendor)).c_str(), bare_median,
              bare_p99);
  std::printf("ratio           %8.2f %8.2f   over %zu round trips each\n",
              board_median / bare_median, board_p99 / bare_p99, board_series.size());
  return 0;
}

}  // namespace
}  // namespace skein::blackboard::bench

int main(int argc, char** argv) {
  namespace bench = skein::blackboard::bench;
  const auto vendor = skein::blackboard::dds_from_name(argc > 1 ? argv[1] : "fastdds");
  if (!vendor) {
    std::fprintf(stderr, "skein_event_latency [fastdds|cyclonedds [BLOCKS [ROUND_TRIPS]]]\n");
    return 2;
  }
  if (argc == 4 && std::string(argv[2]) == "--answer") {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    bench::answer(*vendor, static_cast<std::uint32_t>(std::stoul(argv[3])));
  }
  const auto number = [&](int i, std::uint64_t otherwise) {
    return argc > i ? static_cast<std::uint64_t>(std::stoull(argv[i])) : otherwise;
  };
  const auto lease = skein::blackboard::claim_domain();
  if (!lease) {
    std::fprintf(stderr, "%s\n", lease.error().why.c_str());
    return 1;
  }
  const std::string domain = std::to_string(lease->domain());
  const std::string name(skein::blackboard::name_of(*vendor));
  const pid_t other = fork();
  if (other == 0) {
    execl("/proc/self/exe", argv[0], name.c_str(), "--answer", domain.c_str(), nullptr);
    _exit(127);
  }
  const int result = bench::run(*vendor, lease->domain(), number(2, 20), number(3, 500));
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  return result;
}
