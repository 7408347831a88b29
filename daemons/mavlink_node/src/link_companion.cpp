// SPDX-License-Identifier: Apache-2.0
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>

#include "skein/foundation/overloaded.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/mavlink_node/mavlink_node.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::mavlink_node {

LinkCompanion::LinkCompanion(std::string name, std::string uav, std::shared_ptr<Cockpit> cockpit)
    : name_(std::move(name)), uav_(std::move(uav)), cockpit_(std::move(cockpit)) {}

LinkCompanion::~LinkCompanion() { detach(); }

void LinkCompanion::attach(std::function<void()> wake) {
  stop_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  thread_ = std::thread([this, wake = std::move(wake)] { watch(wake); });
}

void LinkCompanion::detach() {
  if (!thread_.joinable()) return;
  eventfd_write(stop_, 1);
  thread_.join();
  close(stop_);
}

// While bytes lie there unread it wakes the daemon again every few milliseconds, not in a storm.
void LinkCompanion::watch(const std::function<void()>& wake) const {
  const double period = autopilot::Bridge::kPeriod.to_seconds() * 1e3 / cockpit_->rate();
  const int milliseconds = std::max(1, static_cast<int>(period));
  for (;;) {
    std::array<pollfd, 2> files{{{stop_, POLLIN, 0}, {cockpit_->descriptor(), POLLIN, 0}}};
    if (poll(files.data(), files.size(), milliseconds) < 0 && errno != EINTR) return;
    if (files[0].revents != 0) return;
    wake();
    if (files[1].revents != 0 && poll(files.data(), 1, std::min(milliseconds, 5)) > 0) return;
  }
}

std::vector<wire::Sample> LinkCompanion::take() {
  cockpit_->turn();
  std::vector<wire::Sample> samples;
  for (const autopilot::Effect& effect : cockpit_->take()) samples.push_back(sample_of(effect));
  return samples;
}

wire::Sample LinkCompanion::sample_of(const autopilot::Effect& effect) const {
  return std::visit(
      Overloaded{
          [&](const functional::Status& status) -> wire::Sample {
            return translation::to_wire(uav_, status);
          },
          [](const world::Telemetry& telemetry) -> wire::Sample {
            return translation::to_wire(telemetry);
          },
          [](const world::Perception& look) -> wire::Sample { return translation::to_wire(look); },
          [&](const autopilot::Notice& notice) -> wire::Sample {
            wire::JournalEntry entry;
            entry.record = journal::to_json(
                journal::record_of(mission_, name_, journal::lines::Notice{.text = notice.text}));
            return entry;
          },
          [](const autopilot::Transmit&) -> wire::Sample { return wire::JournalEntry{}; }},
      effect);
}

}  // namespace skein::mavlink_node
