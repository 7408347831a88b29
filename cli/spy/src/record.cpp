// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <memory>
#include <ostream>

#include "listener.hpp"
#include "recorder.hpp"
#include "skein/blackboard/passive_observer.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/spy_tool/record.hpp"
#include "unread.hpp"
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

/// What a passive recording lacks.
void tell_unseen(const Listener& listener, const Unread& unread, std::uint64_t lost,
                 std::ostream& err) {
  std::vector<std::string> topics = unread.topics();
  std::erase_if(topics, [&](const std::string& topic) {
    const auto slot = wire::slot_from_name(topic);
    return !slot || !listener.wanted(*slot);
  });
  if (!topics.empty())
    err << "not seen, since nobody reads it and so it is not sent: " << joined(topics, ", ")
        << '\n';
  if (lost > 0) err << lost << " datagrams passed too fast to be seen\n";
}

}  // namespace

int record(const RecordOptions& options, std::ostream& out, std::ostream& err) {
  const blackboard::ObserverConfig config{options.spy.domain, "spy", options.spy.network};
  std::unique_ptr<blackboard::Observer> observer;
  const blackboard::PassiveObserver* passive = nullptr;
  if (options.passive) {
    auto one = std::make_unique<blackboard::PassiveObserver>(config);
    passive = one.get();
    observer = std::move(one);
  } else {
    observer = std::make_unique<blackboard::FastDdsObserver>(config);
  }
  Listener listener(options.spy, std::move(observer));
  if (const Diagnostics wrong = listener.check(); !wrong.empty()) {
    err << to_text(wrong);
    return kExitBadInput;
  }
  std::ofstream file(options.file, std::ios::binary | std::ios::trunc);
  if (!file) {
    err << options.file << ": cannot be written\n";
    return kExitSystem;
  }
  Unread unread;
  if (passive != nullptr)
    listener.on_sighting([&](const blackboard::Sighting& one) {
      unread.see(one);
      return true;
    });
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
  if (passive != nullptr) tell_unseen(listener, unread, passive->lost(), err);
  if (samples > 0 || listener.interrupted()) return kExitOk;
  return nothing_heard(options.spy, listener, 0, err);
}

}  // namespace skein::spy_tool
