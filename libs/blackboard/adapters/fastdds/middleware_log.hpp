// SPDX-License-Identifier: Apache-2.0
// Where the warnings of Fast DDS go.
#pragma once

#include <functional>
#include <string>

namespace skein::blackboard::fastdds {

/// Diverts the log of Fast DDS, one per process, to `sink` for as long as it lives; an empty sink
/// discards it. Of several objects the last one counts. Nothing goes to the console in any case.
class MiddlewareLog {
 public:
  explicit MiddlewareLog(std::function<void(const std::string&)> sink);
  MiddlewareLog(const MiddlewareLog&) = delete;
  MiddlewareLog& operator=(const MiddlewareLog&) = delete;
  ~MiddlewareLog();
};

}  // namespace skein::blackboard::fastdds
