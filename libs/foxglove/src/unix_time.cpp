// SPDX-License-Identifier: Apache-2.0
#include "unix_time.hpp"

#include <chrono>
#include <ctime>
#include <iomanip>
#include <sstream>

namespace skein::foxglove {

std::uint64_t epoch_of(const std::string& iso) {
  std::tm parts{};
  std::istringstream text(iso);
  text >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%SZ");
  const std::chrono::year_month_day date{
      std::chrono::year(parts.tm_year + 1900),
      std::chrono::month(static_cast<unsigned>(parts.tm_mon + 1)),
      std::chrono::day(static_cast<unsigned>(parts.tm_mday))};
  if (!text || !date.ok()) return 0;
  const std::chrono::nanoseconds since =
      std::chrono::sys_days(date).time_since_epoch() + std::chrono::hours(parts.tm_hour) +
      std::chrono::minutes(parts.tm_min) + std::chrono::seconds(parts.tm_sec);
  return since.count() < 0 ? 0 : static_cast<std::uint64_t>(since.count());
}

std::uint64_t unix_time(std::uint64_t epoch, MissionTime at) {
  if (at.count() >= 0) return epoch + static_cast<std::uint64_t>(at.count());
  const std::uint64_t before = std::uint64_t{0} - static_cast<std::uint64_t>(at.count());
  return before > epoch ? 0 : epoch - before;
}

}  // namespace skein::foxglove
