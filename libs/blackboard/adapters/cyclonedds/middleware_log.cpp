// SPDX-License-Identifier: Apache-2.0
// Where the warnings of Cyclone DDS go.
#include "middleware_log.hpp"

#include <dds/ddsrt/log.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

namespace skein::blackboard::cyclonedds {
namespace {

/// The sinks by domain; outlives every thread of the middleware.
struct Sinks {
  std::mutex mutex;
  std::map<dds_domainid_t, std::function<void(const std::string&)>> of;
};

Sinks& sinks() {
  static auto* const the_one = new Sinks;  // never destroyed: threads may outlive main()
  return *the_one;
}

/// Lines that are of no domain (UINT32_MAX) go to all.
void consume(void* /*nothing*/, const dds_log_data_t* data) {
  std::string line(data->message, data->size);
  while (!line.empty() && line.back() == '\n') line.pop_back();
  const std::lock_guard lock(sinks().mutex);
  for (const auto& [domain, sink] : sinks().of) {
    if (sink && (data->domid == domain || data->domid == UINT32_MAX)) sink(line);
  }
}

}  // namespace

MiddlewareLog::MiddlewareLog(dds_domainid_t domain, std::function<void(const std::string&)> sink)
    : domain_(domain) {
  {
    const std::lock_guard lock(sinks().mutex);
    sinks().of.insert_or_assign(domain, std::move(sink));
  }
  static std::once_flag once;
  std::call_once(once, [] { dds_set_log_sink(consume, nullptr); });
}

MiddlewareLog::~MiddlewareLog() {
  const std::lock_guard lock(sinks().mutex);
  sinks().of.erase(domain_);
}

}  // namespace skein::blackboard::cyclonedds
