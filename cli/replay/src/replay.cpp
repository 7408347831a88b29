// SPDX-License-Identifier: Apache-2.0
#include "skein/replay_tool/replay.hpp"

#include <ostream>

#include "player.hpp"
#include "recording.hpp"
#include "retold.hpp"
#include "skein/console/console.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/node/waker.hpp"

namespace skein::replay_tool {

namespace {

constexpr Duration kTurn = Duration::milliseconds(50);

/// The page, and the recording as far as it was told.
class Replay {
 public:
  Replay(const Recording& recording, console::Console& page, node::Waker& waker, double speed)
      : recording_(recording),
        page_(page),
        waker_(waker),
        player_(recording.until(), speed),
        retold_(recording.uavs) {}

  void run(std::ostream& err) {
    page_.attach([this] { waker_.notify(); });
    Duration last = node::Waker::steady_now();
    while (!waker_.stop_requested()) {
      const Duration now = node::Waker::steady_now();
      player_.advance(now - last);
      last = now;
      take_wishes(err);
      tell(now);
      waker_.wait(kTurn);
    }
    page_.detach();
  }

 private:
  void take_wishes(std::ostream& err) {
    for (const wire::Sample& sample : page_.take()) {
      const auto* request = std::get_if<wire::OperatorRequest>(&sample);
      if (request == nullptr) continue;
      const auto wish = wish_of(request->request);
      if (!wish) {
        err << wish.error().why << '\n';
      } else if (player_.carry_out(*wish)) {
        begin_again();
      }
    }
  }

  void begin_again() {
    page_.begin_again();
    retold_ = Retold(recording_.uavs);
    told_ = 0;
  }

  void tell(Duration steady) {
    for (; told_ < recording_.records.size(); ++told_) {
      const journal::Record& record = recording_.records[told_];
      if (record.at() > player_.at()) break;
      for (const wire::Sample& sample : retold_.see(record)) page_.sees(sample);
      page_.sees(record);
    }
    page_.turn({{player_.at(), steady},
                player_.speed(),
                player_.playing() ? wire::ClockPhase::kRunning : wire::ClockPhase::kHolding});
  }

  const Recording& recording_;
  console::Console& page_;
  node::Waker& waker_;
  Player player_;
  Retold retold_;
  std::size_t told_ = 0;  ///< lines
};

}  // namespace

int replay(const ReplayOptions& options, std::ostream& out, std::ostream& err) {
  const auto recording = read_recording(options.folder);
  if (!recording) {
    err << recording.error().why << '\n';
    return kExitBadInput;
  }
  if (recording->unreadable > 0)
    err << options.folder << "/events.jsonl: " << recording->unreadable
        << " lines cannot be read and are left out\n";
  console::ConsoleConfig config;
  config.port = 0;
  config.world = recording->world;
  if (auto read = console::read_address(options.console, config); !read) {
    err << "--console: " << read.error().why << '\n';
    return kExitBadInput;
  }
  node::Waker waker;  // before the page's thread: it blocks signals for it too
  auto page = console::Console::open(std::move(config));
  if (!page) {
    err << page.error().why << '\n';
    return kExitBadInput;
  }
  out << "replay at " << (*page)->url() << std::endl;
  Replay(*recording, **page, waker, options.speed).run(err);
  return kExitOk;
}

}  // namespace skein::replay_tool
