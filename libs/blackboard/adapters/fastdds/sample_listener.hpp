// SPDX-License-Identifier: Apache-2.0
// What readers of Fast DDS do with what comes.
#pragma once

#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include <cstdint>
#include <map>
#include <string>

#include "adapters/rtps/mailbox.hpp"
#include "sample_type.hpp"
#include "security.hpp"

namespace skein::blackboard::fastdds {

/// Takes all samples of a reader as soon as they arrive, in the middleware's thread; one for each
/// channel.
class SampleListener final : public eprosima::fastdds::dds::DataReaderListener {
 public:
  struct Place {
    std::size_t channel = 0;
    ChannelConfig config;
    NodeNumber self;
  };
  /// The nodes that may write, in a secured domain; both members must outlive the listener.
  struct Writers {
    const Identities* identities = nullptr;  ///< null: anybody
    const std::map<NodeNumber, std::string>& names;
  };
  /// The mailbox must outlive the listener.
  SampleListener(rtps::Mailbox& mailbox, Place place, const Writers& writers)
      : mailbox_(mailbox), place_(std::move(place)), writers_(writers) {}

  void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;

 private:
  using Prefix = eprosima::fastrtps::rtps::GuidPrefix_t;

  /// Where a partition is shared, our readers also match our own writers.
  bool is_own(const Cargo& cargo) const;
  /// A forged sample gets a header of zeros, so that it has no effect on the session of the node
  /// that it names.
  void check_writer(Cargo& cargo, const Prefix& writer) const;
  /// Whether the writer is the origin or a relay that may forward its samples (docs/threats.md).
  bool is_entitled(const wire::Sample& sample, const std::string& origin,
                   const Prefix& writer) const;

  rtps::Mailbox& mailbox_;
  Place place_;
  Writers writers_;
};

}  // namespace skein::blackboard::fastdds
