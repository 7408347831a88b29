// SPDX-License-Identifier: Apache-2.0
// One channel of a transport over RTPS: when it has which endpoints, whatever the vendor.
#include "link.hpp"

#include <algorithm>
#include <utility>

namespace skein::blackboard::rtps {
namespace {

std::size_t at(wire::Slot slot) { return static_cast<std::size_t>(slot); }

bool contains(const std::vector<wire::Slot>& slots, wire::Slot slot) {
  return std::ranges::find(slots, slot) != slots.end();
}

/// Writers of events over radio that a node may have from the beginning: those of a team of six.
constexpr std::ptrdiff_t kFewWriters = 64;
/// [bit/s] To tell of an endpoint takes half a kilobyte for each of the others.
constexpr double kRoomToTell = 100'000;

std::ptrdiff_t writers_of_events(const TransportPlan& plan) {
  std::ptrdiff_t all = 0;
  for (const ChannelConfig& channel : plan.channels) {
    if (channel.kind != ChannelKind::kRadio || channel.from != plan.self) continue;
    all += std::ranges::count(channel.slots, wire::SlotClass::kEvent, wire::slot_class);
  }
  return all;
}

}  // namespace

bool is_pattern(std::string_view partition) {
  return partition.find_first_of("*?[") != partition.npos;
}

bool LinkPlan::waits_to_write(wire::Slot slot) const {
  if (slot == wire::Slot::kHeartbeat) return false;
  // A reader that was there before may still not know the writer when that knows it: what is said
  // again then is lost.
  const bool is_stream = wire::slot_class(slot) == wire::SlotClass::kStream;
  if (news_does_not_wait && wire::slot_class(slot) != wire::SlotClass::kState) return false;
  return writers_wait && (!is_stream || readers_wait);
}

bool LinkPlan::waits_to_read(wire::Slot slot) const {
  return readers_wait && slot != wire::Slot::kHeartbeat;
}

LinkPlan plan_link(const TransportPlan& plan, std::size_t index, const DdsConfig& config) {
  LinkPlan link;
  link.config = plan.channels.at(index);
  const bool world = link.config.kind == ChannelKind::kWorld;
  std::vector<wire::Slot> slots = link.config.slots;
  if (!world) slots.push_back(wire::Slot::kHeartbeat);
  if (world || link.config.from == plan.self) link.writes = slots;
  if (world || link.config.from != plan.self) link.reads = world ? plan.world_reads : slots;
  link.writers_wait = !world && config.network.keys.empty() && !config.endpoints_at_once;
  link.readers_wait = link.writers_wait && !is_pattern(link.config.partition);
  const bool has_room = link.config.capacity <= 0 || link.config.capacity >= kRoomToTell;
  link.news_does_not_wait =
      link.config.kind == ChannelKind::kRadio && has_room && writers_of_events(plan) <= kFewWriters;
  return link;
}

Link::Link(LinkPlan plan, std::unique_ptr<Endpoints> endpoints, Log log)
    : plan_(std::move(plan)), endpoints_(std::move(endpoints)), log_(std::move(log)) {}

Result<void, Failure> Link::open() { return set_up(true); }

bool Link::write(const wire::Sample& sample) {
  if (plan_.config.kind != ChannelKind::kWorld) kept_.keep(sample, KeptSamples::Clock::now());
  return !up_ || write_now(sample);
}

bool Link::write_now(const wire::Sample& sample) {
  const wire::Slot slot = wire::slot_of(sample);
  if (!writers_.test(at(slot))) {
    if (!plan_.waits_to_write(slot) || !contains(plan_.writes, slot)) return false;
    if (auto added = add_writer(slot); !added) {
      say_once(slot, added.error());
      return false;
    }
  }
  const auto unmet = key_of_unmet(sample);
  if (unmet && unmet_.contains(*unmet)) return true;
  const bool taken = endpoints_->write(sample);
  if (taken && unmet) unmet_.insert(*unmet);
  if (taken) first_words_.keep(sample, FirstWords::Clock::now());
  return taken;
}

// Sessions say what is not acknowledged again. To a reader that is found late all of that would be
// told at once, and fill a narrow channel.
std::optional<Link::Event> Link::key_of_unmet(const wire::Sample& sample) const {
  const wire::Slot slot = wire::slot_of(sample);
  const bool is_of_a_session =
      wire::slot_class(slot) == wire::SlotClass::kEvent && plan_.config.kind != ChannelKind::kWorld;
  if (!is_of_a_session || met_.test(at(slot))) return std::nullopt;
  const wire::SampleHeader& header = wire::header_of(sample);
  return Event{slot, header.origin, header.incarnation, header.sequence_number, header.expires};
}

Result<void, Failure> Link::set_up(bool up) {
  if (!up) {
    up_ = false;
    return close();
  }
  if (up_) return {};
  auto made = make_endpoints();
  if (made) made = repeat_kept();
  if (!made) (void)close();  // whole or not at all
  up_ = made.has_value();
  return made;
}

void Link::attend(wire::Slot slot) {
  if (!contains(plan_.reads, slot)) return;
  written_by_others_.set(at(slot));
  if (!up_ || readers_.test(at(slot))) return;
  if (auto added = add_reader(slot); !added) say_once(slot, added.error());
}

void Link::meet(wire::Slot slot) {
  if (!up_ || !writers_.test(at(slot))) return;
  met_.set(at(slot));
  std::erase_if(unmet_, [slot](const Event& one) { return std::get<wire::Slot>(one) == slot; });
  first_words_.found(slot, FirstWords::Clock::now(),
                     [this](const wire::Sample& sample) { endpoints_->write(sample); });
}

void Link::flush(Endpoints::Clock::time_point until) {
  if (plan_.config.kind == ChannelKind::kWorld) endpoints_->flush(until);
}

Result<void, Failure> Link::make_endpoints() {
  if (auto opened = endpoints_->open(); !opened) return opened;
  for (const wire::Slot slot : plan_.writes) {
    if (plan_.waits_to_write(slot) && !streamed_.test(at(slot))) continue;
    if (auto added = add_writer(slot); !added) return added;
  }
  for (const wire::Slot slot : plan_.reads) {
    if (plan_.waits_to_read(slot) && !written_by_others_.test(at(slot))) continue;
    if (auto added = add_reader(slot); !added) return added;
  }
  return {};
}

Result<void, Failure> Link::add_writer(wire::Slot slot) {
  auto added = endpoints_->add_writer(slot);
  if (!added) return added;
  writers_.set(at(slot));
  if (wire::slot_class(slot) != wire::SlotClass::kStream) return added;
  const bool is_radio = plan_.config.kind == ChannelKind::kRadio;
  if ((is_radio || plan_.waits_to_write(slot)) && !streamed_.test(at(slot)))
    first_words_.begin(slot, FirstWords::Clock::now());
  streamed_.set(at(slot));
  return added;
}

Result<void, Failure> Link::add_reader(wire::Slot slot) {
  auto added = endpoints_->add_reader(slot);
  if (added) readers_.set(at(slot));
  return added;
}

Result<void, Failure> Link::repeat_kept() {
  std::size_t refused = 0;
  kept_.for_each(KeptSamples::Clock::now(),
                 [&](const wire::Sample& sample) { refused += write_now(sample) ? 0 : 1; });
  if (refused == 0) return {};
  return failure("DDS does not take " + std::to_string(refused) + " samples of channel " +
                 plan_.config.partition);
}

Result<void, Failure> Link::close() {
  writers_.reset();
  readers_.reset();
  met_.reset();
  unmet_.clear();
  first_words_.clear();
  return endpoints_->close();
}

void Link::say_once(wire::Slot slot, const Failure& failure) {
  if (refused_.test(at(slot)) || !log_) return;
  refused_.set(at(slot));
  log_(failure.why);
}

}  // namespace skein::blackboard::rtps
