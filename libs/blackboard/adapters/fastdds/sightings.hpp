// SPDX-License-Identifier: Apache-2.0
// Discovery and samples of Fast DDS as Sightings.
#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "skein/blackboard/observer.hpp"

namespace skein::blackboard::fastdds {

/// Listens to the discovery of one participant and to all of its readers, in the middleware's
/// threads, and keeps the results until they are taken. Its readers read a RawType.
class Sightings final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  std::vector<Sighting> take();
  void on_sighting(std::function<void()> notify);

  void on_participant_discovery(
      eprosima::fastdds::dds::DomainParticipant* participant,
      eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& found) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& found) override;
  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& found) override;
  void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;

 private:
  void put(std::vector<Sighting> sightings);
  std::string partition_of(const std::string& writer) const;

  mutable std::mutex mutex_;
  std::vector<Sighting> all_;
  std::map<std::string, std::string> partitions_;  ///< by writer
  std::mutex notify_mutex_;                        // apart: a notified thread may take at once
  std::function<void()> notify_;
};

}  // namespace skein::blackboard::fastdds
