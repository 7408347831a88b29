// SPDX-License-Identifier: Apache-2.0
// The endpoints of a channel, as Cyclone DDS makes them.
#pragma once

#include <dds/dds.h>

#include <array>
#include <map>
#include <string>

#include "adapters/rtps/link.hpp"
#include "adapters/rtps/matches.hpp"
#include "reader_listener.hpp"

struct ddsi_sertype;

namespace skein::blackboard::cyclonedds {

/// The endpoints of a participant, each created when it is first needed and owned by the
/// participant.
class Topics {
 public:
  struct Topic {
    dds_entity_t entity = 0;             ///< negative: why Cyclone refuses it
    const ddsi_sertype* type = nullptr;  ///< of the domain
  };
  /// Of a participant that is joined later.
  explicit Topics(const dds_entity_t& participant) : participant_(participant) {}
  const Topic& of(wire::Slot slot);

 private:
  const dds_entity_t& participant_;
  std::map<wire::Slot, Topic> topics_;
};

class ChannelEndpoints final : public rtps::Endpoints {
 public:
  /// Precondition: the participant exists. It, the topics, the mailbox and the matches must be
  /// alive at each call. The participant may end before this object, and deletes the remaining
  /// endpoints.
  ChannelEndpoints(const dds_entity_t& participant, Topics& topics, const rtps::LinkPlan& link,
                   std::size_t channel, rtps::Mailbox& mailbox, rtps::Matches& matches);

  Result<void, Failure> open() override;
  Result<void, Failure> add_writer(wire::Slot slot) override;
  Result<void, Failure> add_reader(wire::Slot slot) override;
  Result<void, Failure> close() override;
  bool write(const wire::Sample& sample) override;
  void flush(Clock::time_point until) override;

 private:
  Result<void, Failure> made(dds_return_t code) const;
  /// Null: the matches of its writer are not reported.
  dds_listener_t* listener_of(wire::Slot slot);

  const dds_entity_t& participant_;
  Topics& topics_;
  ChannelKind kind_;
  std::string partition_;
  bool writes_, reads_;
  /// Of a writer of a stream.
  struct MatchListener {
    rtps::Matches* matches = nullptr;
    rtps::Matches::Writer writer;
  };
  std::map<wire::Slot, ReaderListener> listeners_;
  std::map<wire::Slot, MatchListener> match_listeners_;
  dds_entity_t publisher_ = 0, subscriber_ = 0;
  std::array<dds_entity_t, wire::kSlotCount> writers_{};
};

}  // namespace skein::blackboard::cyclonedds
