// SPDX-License-Identifier: Apache-2.0
// Samples of a stream slot that arrive in another process while they are written as fast as can be,
// through the blackboard and through the bare DDS below it, in alternating blocks of one run:
//   skein_stream_throughput [fastdds|cyclonedds [BLOCKS [SECONDS_PER_BLOCK]]]
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
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

const Node kWriter{NodeNumber(1), "writer"};
const Node kReader{NodeNumber(2), "reader"};

Now now() {
  const auto since = Clock::now().time_since_epoch();
  return {{}, Duration::nanoseconds(std::chrono::nanoseconds(since).count())};
}

/// A blackboard and what wakes its one thread.
class Side {
 public:
  Side(DdsVendor vendor, std::uint32_t domain, const Node& self) {
    DdsConfig dds;
    dds.domain = domain;
    dds.network.dds = vendor;
    transport_ = make_dds_transport(std::move(dds));
    transport_->on_arrival([this] {
      const std::lock_guard lock(mutex_);
      arrived_ = true;
      wake_.notify_one();
    });
    Config config;
    config.self = self.number;
    config.channels = station_link(kReader, kWriter);
    board_ = std::make_unique<Blackboard>(Blackboard::open(std::move(config), *transport_).value());
  }
  Blackboard& board() { return *board_; }
  std::vector<Incoming> wait() {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, std::chrono::milliseconds(20), [this] { return arrived_; });
    arrived_ = false;
    lock.unlock();
    return board_->step(now());
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
  std::unique_ptr<Transport> transport_;
  std::unique_ptr<Blackboard> board_;
};

wire::Telemetry telemetry() {
  wire::Telemetry sample;
  sample.uav = "asker";
  sample.activity = "flying";
  return sample;
}

[[noreturn]] void write_all(DdsVendor vendor, std::uint32_t domain, bool bare) {
  if (bare) {
    const auto stream = make_bare_stream(vendor, domain, BareStream::Role::kWrites);
    for (std::uint64_t i = 1;; ++i) stream->write(i);
  }
  Side side(vendor, domain, kWriter);
  for (std::uint64_t i = 1;; ++i) {
    if (i % 64 == 0) side.board().step(now());
    static_cast<void>(side.board().send(telemetry(), kReader.number, now()));
  }
}

/// Of what `count` counts, per second, from the first that comes.
double rate(const std::function<std::uint64_t()>& count, double seconds) {
  const auto give_up = Clock::now() + std::chrono::seconds(20);
  while (count() == 0 && Clock::now() < give_up) std::this_thread::yield();
  const std::uint64_t before = count();
  const auto begin = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  while (passed() < seconds) static_cast<void>(count());
  return static_cast<double>(count() - before) / passed();
}

double read_bare(DdsVendor vendor, std::uint32_t domain, double seconds) {
  const auto stream = make_bare_stream(vendor, domain, BareStream::Role::kReads);
  return rate(
      [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return stream->taken();
      },
      seconds);
}

double read_board(DdsVendor vendor, std::uint32_t domain, double seconds) {
  Side side(vendor, domain, kReader);
  std::uint64_t taken = 0;
  return rate(
      [&] {
        for (const Incoming& incoming : side.wait())
          taken += std::holds_alternative<Received>(incoming) ? 1 : 0;
        return taken;
      },
      seconds);
}

double block(DdsVendor vendor, std::uint32_t domain, bool bare, double seconds) {
  const std::string name(name_of(vendor));
  const std::string number = std::to_string(domain);
  const pid_t other = fork();
  if (other == 0) {
    execl("/proc/self/exe", "stream_throughput", name.c_str(), bare ? "--bare" : "--board",
          number.c_str(), nullptr);
    _exit(127);
  }
  const double found =
      bare ? read_bare(vendor, domain, seconds) : read_board(vendor, domain, seconds);
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  return found;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

int run(DdsVendor vendor, int blocks, double seconds) {
  const auto lease = claim_domain();
  if (!lease) return 1;
  std::vector<double> bare;
  std::vector<double> board;
  for (int i = 0; i < blocks; ++i) {
    board.push_back(block(vendor, lease->domain(), false, seconds));
    bare.push_back(block(vendor, lease->domain(), true, seconds));
  }
  std::printf("samples per second that arrive, median of %d blocks of %.0f s\n", blocks, seconds);
  std::printf("blackboard      %8.0f\nbare %-10s %8.0f\nratio           %8.2f\n", median(board),
              std::string(name_of(vendor)).c_str(), median(bare), median(board) / median(bare));
  return 0;
}

}  // namespace
}  // namespace skein::blackboard::bench

int main(int argc, char** argv) {
  namespace bench = skein::blackboard::bench;
  const auto vendor = skein::blackboard::dds_from_name(argc > 1 ? argv[1] : "fastdds");
  if (!vendor) {
    std::fprintf(stderr, "skein_stream_throughput [fastdds|cyclonedds [BLOCKS [SECONDS]]]\n");
    return 2;
  }
  const std::string word = argc > 2 ? argv[2] : "5";
  if (word.starts_with("--")) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    bench::write_all(*vendor, static_cast<std::uint32_t>(std::stoul(argv[3])), word == "--bare");
  }
  return bench::run(*vendor, std::stoi(word), argc > 3 ? std::stod(argv[3]) : 3);
}
