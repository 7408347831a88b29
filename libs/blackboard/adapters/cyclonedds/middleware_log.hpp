// SPDX-License-Identifier: Apache-2.0
// Where the warnings of Cyclone DDS go.
#pragma once

#include <dds/dds.h>

#include <functional>
#include <string>

namespace skein::blackboard::cyclonedds {

/// Diverts the log of Cyclone DDS for one domain of this process to `sink` for the lifetime of the
/// object; an empty sink discards it. Nothing goes to the console in any case.
class MiddlewareLog {
 public:
  MiddlewareLog(dds_domainid_t domain, std::function<void(const std::string&)> sink);
  MiddlewareLog(const MiddlewareLog&) = delete;
  MiddlewareLog& operator=(const MiddlewareLog&) = delete;
  ~MiddlewareLog();

 private:
  dds_domainid_t domain_;
};

}  // namespace skein::blackboard::cyclonedds
