// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/time.hpp"

#include <cmath>
#include <cstdio>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/whole.hpp"

namespace skein {

namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

// The magnitude as unsigned, so that the most negative value has one.
std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}

std::string decimal_seconds(std::int64_t ns) {
  const std::uint64_t size = magnitude(ns);
  std::string text = ns < 0 ? "-" : "";
  text += std::to_string(size / kNanosecondsPerSecond);
  std::string fraction = std::to_string(size % kNanosecondsPerSecond);
  fraction.insert(0, 9 - fraction.size(), '0');
  fraction.erase(fraction.find_last_not_of('0') + 1);
  return fraction.empty() ? text : text + "." + fraction;
}

}  // namespace

Duration Duration::seconds(double s) {
  SKEIN_EXPECTS(!std::isnan(s));
  return Duration(whole(std::round(s * 1e9)));
}

std::string to_text(MissionTime t) { return decimal_seconds(t.count()); }

std::string to_text(Duration d) { return decimal_seconds(d.count()); }

std::string to_clock_text(MissionTime t) {
  const std::uint64_t s = magnitude(t.count()) / kNanosecondsPerSecond;
  char text[48];
  std::snprintf(text, sizeof text, "%s%llu:%02llu:%02llu", t.count() < 0 ? "-" : "",
                static_cast<unsigned long long>(s / 3600),
                static_cast<unsigned long long>(s / 60 % 60),
                static_cast<unsigned long long>(s % 60));
  return text;
}

}  // namespace skein
