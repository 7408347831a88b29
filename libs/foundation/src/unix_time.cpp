// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/unix_time.hpp"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <iomanip>
#include <sstream>

namespace skein {

std::uint64_t epoch_of(const std::string& iso) {
  std::tm parts{};
  std::istringstream text(iso);
  text >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%SZ");
  const std::chrono::year_month_day date{
      std::chrono::year(parts.tm_year + 1900),
      std::chrono::month(static_cast<unsigned>(parts.tm_mon + 1)),
      std::chrono::day(static_cast<unsigned>(parts.tm_mday))};
  // A text that ends too soon is no failure of get_time.
  const bool whole = !text.fail() && iso.ends_with('Z') && text.peek() == EOF;
  if (!whole || !date.ok()) return 0;
  const std::chrono::seconds since =
      std::chrono::sys_days(date).time_since_epoch() + std::chrono::hours(parts.tm_hour) +
      std::chrono::minutes(parts.tm_min) + std::chrono::seconds(parts.tm_sec);
  constexpr auto kLast = std::chrono::floor<std::chrono::seconds>(std::chrono::nanoseconds::max());
  if (since.count() < 0 || since > kLast) return 0;
  return static_cast<std::uint64_t>(std::chrono::nanoseconds(since).count());
}

std::uint64_t unix_time(std::uint64_t epoch, MissionTime at) {
  if (at.count() >= 0) return epoch + static_cast<std::uint64_t>(at.count());
  const std::uint64_t before = std::uint64_t{0} - static_cast<std::uint64_t>(at.count());
  return before > epoch ? 0 : epoch - before;
}

std::string utc_text(std::uint64_t nanoseconds) {
  using namespace std::chrono;  // NOLINT(google-build-using-namespace): its units
  const auto thousandths =
      floor<milliseconds>(std::chrono::nanoseconds(static_cast<std::int64_t>(nanoseconds)));
  const auto days = floor<std::chrono::days>(thousandths);
  const year_month_day date{sys_days(days)};
  const hh_mm_ss time(thousandths - days);
  std::ostringstream text;
  const auto two = [&](auto value) -> std::ostream& {
    return text << std::setw(2) << std::setfill('0') << value;
  };
  text << std::setw(4) << std::setfill('0') << static_cast<int>(date.year()) << '-';
  two(static_cast<unsigned>(date.month())) << '-';
  two(static_cast<unsigned>(date.day())) << 'T';
  two(time.hours().count()) << ':';
  two(time.minutes().count()) << ':';
  two(time.seconds().count());
  if (const auto rest = time.subseconds().count(); rest != 0)
    text << '.' << std::setw(3) << std::setfill('0') << rest;
  return text.str() + 'Z';
}

}  // namespace skein
