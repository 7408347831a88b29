// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <fstream>
#include <mutex>
#include <ostream>

#include "listener.hpp"
#include "recorder.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/spy_tool/record.hpp"

namespace skein::spy_tool {

namespace {

constexpr Duration kTurn = Duration::milliseconds(200);
constexpr Duration kFlush = Duration::milliseconds(1000);

std::uint64_t wall_clock() {
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(
                                        std::chrono::system_clock::now().time_since_epoch())
                                        .count());
}

/// What the middleware's threads leave.
class Basket {
 public:
  void put(const blackboard::RawSample& raw) {
    Taken taken{raw.slot, raw.partition, wall_clock(),
                static_cast<std::uint64_t>(std::max<std::int64_t>(raw.source_time, 0)),
                std::string(reinterpret_cast<const char*>(raw.bytes.data()), raw.bytes.size())};
    const std::lock_guard lock(mutex_);
    all_.push_back(std::move(taken));
  }
  std::vector<Taken> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(all_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<Taken> all_;
};

/// Records until it is enough; the number of samples.
std::uint64_t record_all(const RecordOptions& options, Listener& listener, Basket& basket,
                         std::ofstream& file) {
  Recorder recorder(options.with_json, [&](std::string_view bytes) {
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
  const Duration begun = node::Waker::steady_now();
  Duration flushed = begun;
  bool enough = false;
  while (!enough && !listener.interrupted() && file) {
    listener.listen(node::Waker::steady_now() + kTurn, [](const Heard&) { return true; });
    for (const Taken& taken : basket.take()) {
      if (!listener.wanted(taken.slot) || enough) continue;
      recorder.take(taken);
      enough = recorder.samples() == options.spy.count;
    }
    const Duration now = node::Waker::steady_now();
    enough = enough ||
             (options.spy.duration > 0 && now - begun >= Duration::seconds(options.spy.duration));
    if (now - flushed < kFlush) continue;
    flushed = now;
    recorder.flush();
    file.flush();
  }
  recorder.close();
  return recorder.samples();
}

}  // namespace

int record(const RecordOptions& options, std::ostream& out, std::ostream& err) {
  Basket basket;
  Listener listener(options.spy, [&](const blackboard::RawSample& raw) { basket.put(raw); });
  if (const Diagnostics wrong = listener.check(); !wrong.empty()) {
    err << to_text(wrong);
    return kExitBadInput;
  }
  std::ofstream file(options.file, std::ios::binary | std::ios::trunc);
  if (!file) {
    err << options.file << ": cannot be written\n";
    return kExitSystem;
  }
  if (auto opened = listener.open(); !opened) {
    err << opened.error().why << '\n';
    return kExitSystem;
  }
  const std::uint64_t samples = record_all(options, listener, basket, file);
  file.close();
  if (!file) {
    err << options.file << ": cannot be written\n";
    return kExitSystem;
  }
  out << options.file << ": " << samples << " samples\n";
  if (samples > 0 || listener.interrupted()) return kExitOk;
  err << "nothing heard on domain " << options.spy.domain << '\n';
  return kExitTimeout;
}

}  // namespace skein::spy_tool
