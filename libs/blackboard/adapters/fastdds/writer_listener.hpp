// SPDX-License-Identifier: Apache-2.0
// What the writers of a channel do when they find a reader.
#pragma once

#include <fastdds/dds/core/status/PublicationMatchedStatus.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include "adapters/rtps/matches.hpp"

namespace skein::blackboard::fastdds {

/// Notes the matches of the writers of a channel; one for each channel. Thread rule: called by the
/// middleware's threads.
class WriterListener final : public eprosima::fastdds::dds::DataWriterListener {
 public:
  /// `matches` outlives it.
  WriterListener(rtps::Matches& matches, std::size_t channel)
      : matches_(matches), channel_(channel) {}

  void on_publication_matched(
      eprosima::fastdds::dds::DataWriter* writer,
      const eprosima::fastdds::dds::PublicationMatchedStatus& status) override {
    const auto slot = wire::slot_from_name(writer->get_topic()->get_name());
    if (status.current_count_change > 0 && slot) matches_.found({channel_, *slot});
  }

 private:
  rtps::Matches& matches_;
  std::size_t channel_;
};

}  // namespace skein::blackboard::fastdds
