// SPDX-License-Identifier: Apache-2.0
// Where the warnings of Fast DDS go.
#include "middleware_log.hpp"

#include <fastdds/dds/log/Log.hpp>
#include <memory>
#include <mutex>

namespace skein::blackboard::fastdds {
namespace {

using eprosima::fastdds::dds::Log;
using eprosima::fastdds::dds::LogConsumer;

/// The sink and who set it; outlives every thread of the middleware.
struct Sink {
  std::mutex mutex;
  std::function<void(const std::string&)> function;
  const MiddlewareLog* owner = nullptr;
};

Sink& sink() {
  static auto* const the_one = new Sink;  // never destroyed: the log thread may outlive main()
  return *the_one;
}

/// Every pair of endpoints of one slot on two channels gives the first line: channels are
/// partitions. With keys Fast DDS goes through all of them to find who sent a message, and says the
/// second of each that it passes. The third it says of each endpoint of Cyclone DDS that is gone;
/// it knows which by the key hash beside that.
bool is_expected(const std::string& message) {
  return message.find("Different Partitions") != std::string::npos ||
         message.find("No key material yet") != std::string::npos ||
         message.find("too large key-only data") != std::string::npos;
}

class Consumer final : public LogConsumer {
 public:
  void Consume(const Log::Entry& entry) override {
    if (is_expected(entry.message)) return;
    const std::lock_guard lock(sink().mutex);
    if (!sink().function) return;
    const std::string category = entry.context.category != nullptr ? entry.context.category : "";
    sink().function(category + ": " + entry.message);
  }
};

}  // namespace

MiddlewareLog::MiddlewareLog(std::function<void(const std::string&)> function) {
  {
    const std::lock_guard lock(sink().mutex);
    sink().function = std::move(function);
    sink().owner = this;
  }
  static std::once_flag once;
  std::call_once(once, [] {
    Log::ClearConsumers();
    Log::RegisterConsumer(std::make_unique<Consumer>());
    Log::SetVerbosity(Log::Kind::Warning);
  });
}

MiddlewareLog::~MiddlewareLog() {
  const std::lock_guard lock(sink().mutex);
  if (sink().owner != this) return;
  sink().function = nullptr;
  sink().owner = nullptr;
}

}  // namespace skein::blackboard::fastdds
