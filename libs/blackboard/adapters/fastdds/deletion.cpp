// SPDX-License-Identifier: Apache-2.0
#include "deletion.hpp"

#include <fastdds/dds/publisher/DataWriter.hpp>

#include <vector>

namespace skein::blackboard::fastdds {

namespace dds = eprosima::fastdds::dds;

bool delete_publisher(dds::DomainParticipant& participant, dds::Publisher* publisher) {
  const eprosima::fastrtps::types::ReturnCode_t kOk =
      eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
  std::vector<dds::DataWriter*> writers;
  publisher->get_datawriters(writers);
  for (dds::DataWriter* const writer : writers) writer->clear_history(nullptr);
  return publisher->delete_contained_entities() == kOk &&
         participant.delete_publisher(publisher) == kOk;
}

}  // namespace skein::blackboard::fastdds
