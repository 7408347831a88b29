// SPDX-License-Identifier: Apache-2.0
// One channel of a transport over RTPS: when it has which endpoints, whatever the vendor.
#pragma once

#include <bitset>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "adapters/rtps/first_words.hpp"
#include "adapters/rtps/kept_samples.hpp"
#include "skein/blackboard/dds_config.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::rtps {

/// A node's side of a channel.
struct LinkPlan {
  ChannelConfig config;
  std::vector<wire::Slot> writes, reads;
  /// Whether a writer is made for its first sample only, and a reader once somebody writes. A node
  /// has dozens of slots for each of its peers and uses few of them, while every endpoint is told
  /// to every participant. Only the heartbeat's do not wait: it is always said.
  bool writers_wait = false, readers_wait = false;
  /// Writers of events and streams do not wait all the same: a reader that has to be found first
  /// over a link that loses much comes seconds after the first command, or the first look.
  bool news_does_not_wait = false;

  bool waits_to_write(wire::Slot slot) const;
  bool waits_to_read(wire::Slot slot) const;
};

/// Whether the text is a pattern, which stands for many partitions.
bool is_pattern(std::string_view partition);

/// Of the channel with that index. Endpoints of the world do not wait: everybody uses them, and
/// some write there only when they end. With keys none do, since it must be known at once whether
/// all is allowed. Writers of events and streams over a radio do not where those of events are
/// few, and the radio has room to tell of them. Behind a discovery server readers wait, too: see
/// scouts_of.
LinkPlan plan_link(const TransportPlan& plan, std::size_t index, const DdsConfig& config);

/// The DDS endpoints of one channel, implemented for each vendor. Failures are sentences that name
/// vendor and channel.
class Endpoints {
 public:
  using Clock = std::chrono::steady_clock;

  Endpoints() = default;
  Endpoints(const Endpoints&) = delete;
  Endpoints& operator=(const Endpoints&) = delete;
  virtual ~Endpoints() = default;

  /// What they belong to, as far as something is written or read, without any yet.
  virtual Result<void, Failure> open() = 0;
  virtual Result<void, Failure> add_writer(wire::Slot slot) = 0;
  virtual Result<void, Failure> add_reader(wire::Slot slot) = 0;
  /// Deletes all endpoints, with the histories of the writers.
  virtual Result<void, Failure> close() = 0;
  /// Writes with the writer of the sample's slot, which must have been added; false if the
  /// middleware did not accept the sample.
  virtual bool write(const wire::Sample& sample) = 0;
  /// Waits until all readers have received all samples written, at most until `until`.
  virtual void flush(Clock::time_point until) = 0;
};

/// While it is cut a channel has no endpoints: they are not moved to another partition, since not
/// every vendor can (Cyclone DDS), nor follows a writer that moves. What writers keep for those who
/// connect later is written again then. Thread rule: one thread.
class Link {
 public:
  using Log = std::function<void(const std::string&)>;

  /// `log` is told, once for each slot, why an endpoint could not be made when it was needed; may
  /// be empty.
  Link(LinkPlan plan, std::unique_ptr<Endpoints> endpoints, Log log);

  /// Once, before everything else.
  Result<void, Failure> open();
  /// As Transport::write() and set_up().
  bool write(const wire::Sample& sample);
  Result<void, Failure> set_up(bool up);
  bool up() const { return up_; }
  /// A remote writer of this slot was discovered for this channel's reader.
  void attend(wire::Slot slot);
  /// This channel's writer of that slot has found a reader.
  void meet(wire::Slot slot);
  /// On the world channel no session makes good what a writer takes with it: waits, within bounds,
  /// until everybody has got it.
  void flush(Endpoints::Clock::time_point until);

 private:
  using Slots = std::bitset<wire::kSlotCount>;
  /// Slot, origin, incarnation, number and expiry.
  using Event = std::tuple<wire::Slot, std::uint32_t, std::uint64_t, std::uint64_t, std::int64_t>;

  Result<void, Failure> make_endpoints();
  Result<void, Failure> add_writer(wire::Slot slot);
  Result<void, Failure> add_reader(wire::Slot slot);
  Result<void, Failure> repeat_kept();
  Result<void, Failure> close();
  bool write_now(const wire::Sample& sample);
  void say_once(wire::Slot slot, const Failure& failure);
  /// Of an event that was not said since its writer has found a reader, while there is one to say
  /// it again; none: what is said again is written again.
  std::optional<Event> key_of_unmet(const wire::Sample& sample) const;

  LinkPlan plan_;
  std::unique_ptr<Endpoints> endpoints_;
  Log log_;
  bool up_ = false;
  Slots writers_, readers_;  ///< that exist
  Slots written_by_others_;  ///< of the reads
  Slots streamed_;           ///< streams that were written: their writers wait no more after a cut
  Slots refused_;            ///< that were told of
  Slots met_;                ///< whose writers have found a reader
  std::set<Event> unmet_;    ///< that were written to writers that have not
  KeptSamples kept_;
  FirstWords first_words_;
};

}  // namespace skein::blackboard::rtps
