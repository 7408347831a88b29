// SPDX-License-Identifier: Apache-2.0
// The endpoints of a channel, as Fast DDS makes them.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>

#include "adapters/rtps/link.hpp"
#include "participation.hpp"
#include "sample_listener.hpp"
#include "writer_listener.hpp"

namespace skein::blackboard::fastdds {

/// The endpoints of a participant, each created when it is first needed and owned by the
/// participant.
class Topics {
 public:
  explicit Topics(const Participation& participation) : participation_(participation) {}
  /// Null if Fast DDS refuses it.
  eprosima::fastdds::dds::Topic* of(wire::Slot slot);

 private:
  const Participation& participation_;
  std::map<wire::Slot, eprosima::fastdds::dds::Topic*> topics_;
};

class ChannelEndpoints final : public rtps::Endpoints {
 public:
  /// Precondition: the participation has joined its domain. It and the topics must be alive at each
  /// call, but may end before this object: the participant deletes the remaining endpoints.
  ChannelEndpoints(const Participation& participation, Topics& topics, const rtps::LinkPlan& link,
                   std::unique_ptr<SampleListener> listener,
                   std::unique_ptr<WriterListener> of_writers);

  Result<void, Failure> open() override;
  Result<void, Failure> add_writer(wire::Slot slot) override;
  Result<void, Failure> add_reader(wire::Slot slot) override;
  Result<void, Failure> close() override;
  bool write(const wire::Sample& sample) override;
  void flush(Clock::time_point until) override;

 private:
  Result<void, Failure> refused() const;

  const Participation& participation_;
  Topics& topics_;
  ChannelKind kind_;
  rtps::Pace pace_;
  std::string partition_;
  bool writes_, reads_;
  std::unique_ptr<SampleListener> listener_;
  std::unique_ptr<WriterListener> of_writers_;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
  std::array<eprosima::fastdds::dds::DataWriter*, wire::kSlotCount> writers_{};
};

}  // namespace skein::blackboard::fastdds
