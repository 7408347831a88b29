// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <memory>
#include <ostream>

#include "listener.hpp"
#include "recorder.hpp"
#include "skein/blackboard/fastdds_observer.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/spy_tool/record.hpp"
#include "verbs/verbs.hpp"

namespace skein::spy_tool {

namespace {

constexpr Duration kTurn = Duration::milliseconds(200);
constexpr Duration kFlush = Duration::milliseconds(1000);

Taken taken_from(const Heard& heard) {
  const blackboard::SampleSeen& raw = heard.raw();
  return {*heard.slot(), raw.partition, static_cast<std::uint64_t>(raw.heard),
          static_cast<std::uint64_t>(raw.sent),
          std::string(reinterpret_cast<const char*>(raw.bytes.data()), raw.bytes.size())};
}

/// Records until it is enough; the number of samples.
std::uint64_t record_all(const RecordOptions& options, Listener& listener, std::ofstream& file) {
  Recorder recorder(options.with_json, [&](std::string_view bytes) {
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
  const Duration begun = node::Waker::steady_now();
  Duration flushed = begun;
  bool enough = false;
  while (!enough && !listener.interrupted() && file) {
    listener.listen(node::Waker::steady_now() + kTurn, [&](const Heard& heard) {
      if (!heard.slot() || heard.gone()) return true;
      recorder.take(taken_from(heard));
      enough = recorder.samples() == options.spy.count;
      return !enough;
    });
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
  Listener listener(
      options.spy, std::make_unique<blackboard::FastDdsObserver>(
                       blackboard::ObserverConfig{options.spy.domain, "spy", options.spy.network}));
  if (const Diagnostics wrong = listener.check(); !wrong.empty()) {
    err << to_text(wrong);
    return kExitBadInput;
  }
  std::ofstream file(options.file, std::ios::binary | std::ios::trunc);
  if (!file) {
    err << options.file << ": cannot be written\n";
    return kExitSystem;
  }
  listener.look_in_turns();
  if (auto opened = listener.open(); !opened) {
    err << opened.error().why << '\n';
    return kExitSystem;
  }
  const std::uint64_t samples = record_all(options, listener, file);
  file.close();
  if (!file) {
    err << options.file << ": cannot be written\n";
    return kExitSystem;
  }
  out << options.file << ": " << samples << " samples\n";
  if (samples > 0 || listener.interrupted()) return kExitOk;
  return nothing_heard(options.spy, listener, 0, err);
}

}  // namespace skein::spy_tool
