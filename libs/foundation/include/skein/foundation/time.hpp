// SPDX-License-Identifier: Apache-2.0
// Mission time and durations: signed 64-bit nanoseconds, as strong types.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace skein {

namespace detail {
constexpr std::int64_t end_of_range(bool negative) {
  return negative ? std::numeric_limits<std::int64_t>::min()
                  : std::numeric_limits<std::int64_t>::max();
}
constexpr std::int64_t saturating_add(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  return __builtin_add_overflow(a, b, &sum) ? end_of_range(a < 0) : sum;
}
constexpr std::int64_t saturating_multiply(std::int64_t a, std::int64_t b) {
  std::int64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? end_of_range((a < 0) != (b < 0)) : product;
}
constexpr std::int64_t saturating_negate(std::int64_t a) { return saturating_multiply(a, -1); }
}  // namespace detail

/// A span of time [ns]; may be negative. Value type, trivially copyable.
/// Arithmetic saturates at the ends of the range instead of overflowing, so that "for ever"
/// (`Duration::max()`) stays for ever. Source: spec 1.4.
class Duration {
 public:
  constexpr Duration() = default;
  static constexpr Duration nanoseconds(std::int64_t ns) { return Duration(ns); }
  /// Out of range saturates.
  static constexpr Duration milliseconds(std::int64_t ms) {
    return Duration(detail::saturating_multiply(ms, 1'000'000));
  }
  /// Nearest nanosecond; out of range saturates; NaN is a broken contract.
  static Duration seconds(double s);
  static constexpr Duration max() { return Duration(std::numeric_limits<std::int64_t>::max()); }

  constexpr std::int64_t count() const { return ns_; }
  constexpr double to_seconds() const { return static_cast<double>(ns_) * 1e-9; }
  constexpr auto operator<=>(const Duration&) const = default;

 private:
  constexpr explicit Duration(std::int64_t ns) : ns_(ns) {}
  std::int64_t ns_ = 0;
};

/// An instant of mission time: nanoseconds since the scenario's epoch. Source: spec 1.4.
class MissionTime {
 public:
  constexpr MissionTime() = default;
  static constexpr MissionTime nanoseconds(std::int64_t ns) { return MissionTime(ns); }
  /// Nearest nanosecond; out of range saturates; NaN is a broken contract.
  static MissionTime seconds(double s) { return MissionTime(Duration::seconds(s).count()); }
  static constexpr MissionTime max() {
    return MissionTime(std::numeric_limits<std::int64_t>::max());
  }

  constexpr std::int64_t count() const { return ns_; }
  constexpr double to_seconds() const { return static_cast<double>(ns_) * 1e-9; }
  constexpr auto operator<=>(const MissionTime&) const = default;

 private:
  constexpr explicit MissionTime(std::int64_t ns) : ns_(ns) {}
  std::int64_t ns_ = 0;
};

constexpr Duration operator+(Duration a, Duration b) {
  return Duration::nanoseconds(detail::saturating_add(a.count(), b.count()));
}
constexpr Duration operator-(Duration a, Duration b) {
  return Duration::nanoseconds(
      detail::saturating_add(a.count(), detail::saturating_negate(b.count())));
}
constexpr MissionTime operator+(MissionTime t, Duration d) {
  return MissionTime::nanoseconds(detail::saturating_add(t.count(), d.count()));
}
constexpr MissionTime operator-(MissionTime t, Duration d) {
  return MissionTime::nanoseconds(
      detail::saturating_add(t.count(), detail::saturating_negate(d.count())));
}
constexpr Duration operator-(MissionTime a, MissionTime b) {
  return Duration::nanoseconds(
      detail::saturating_add(a.count(), detail::saturating_negate(b.count())));
}

/// The earlier of two optional wake-ups; an absent one never comes.
constexpr std::optional<MissionTime> earliest(std::optional<MissionTime> a,
                                              std::optional<MissionTime> b) {
  if (!a) return b;
  if (!b) return a;
  return *a < *b ? a : b;
}

/// Seconds in plain decimal, exact to the nanosecond, without trailing zeros: "12.5",
/// "-0.000000001".
std::string to_text(MissionTime t);
std::string to_text(Duration d);

/// Hours, minutes and seconds for people, rounded down to the second: "0:20:05", "-0:00:01".
std::string to_clock_text(MissionTime t);

}  // namespace skein
