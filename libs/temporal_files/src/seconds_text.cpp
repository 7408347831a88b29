// SPDX-License-Identifier: Apache-2.0
#include "seconds_text.hpp"

#include <algorithm>
#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::temporal {

namespace {

constexpr long kNanosecondDigits = 9;
constexpr long kLargestExponent = 1'000'000'000;  // beyond any text's length: saturates
constexpr std::size_t kMostDigits = 19;           // of kLargest, 2^60

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// ±digits · 10^exponent [ns]; digits without leading or trailing zeros, none for zero.
struct Decimal {
  bool negative = false;
  std::string digits;
  long exponent = 0;
};

bool take_sign(std::string_view& text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  return negative;
}

std::string_view take_digits(std::string_view& text) {
  const auto* end = std::find_if_not(text.begin(), text.end(), is_digit);
  const std::string_view digits(text.begin(), static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

// What follows the 'e'; nothing when it is not a whole number.
std::optional<long> exponent_from(std::string_view text) {
  const bool negative = take_sign(text);
  const std::string_view digits = take_digits(text);
  if (digits.empty() || !text.empty()) return std::nullopt;
  long value = 0;
  for (const char c : digits) value = std::min(kLargestExponent, value * 10 + (c - '0'));
  return negative ? -value : value;
}

void strip_zeros(Decimal& decimal) {
  decimal.digits.erase(0, std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size()));
  while (!decimal.digits.empty() && decimal.digits.back() == '0') {
    decimal.digits.pop_back();
    ++decimal.exponent;
  }
}

std::optional<Decimal> parse(std::string_view text) {
  Decimal decimal;
  decimal.negative = take_sign(text);
  decimal.digits = take_digits(text);
  decimal.exponent = kNanosecondDigits;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const std::string_view fraction = take_digits(text);
    decimal.digits += fraction;
    decimal.exponent -= static_cast<long>(fraction.size());
  }
  if (decimal.digits.empty()) return std::nullopt;
  if (text.starts_with('e') || text.starts_with('E')) {
    const std::optional<long> exponent = exponent_from(text.substr(1));
    if (!exponent) return std::nullopt;
    decimal.exponent += *exponent;
  } else if (!text.empty()) {
    return std::nullopt;
  }
  strip_zeros(decimal);
  return decimal;
}

// Drops the digits below the nanosecond. Whether the dropped part is a half or more.
bool drop_fraction(Decimal& decimal) {
  const auto dropped = static_cast<std::size_t>(-decimal.exponent);
  decimal.exponent = 0;
  if (dropped > decimal.digits.size()) {
    decimal.digits.clear();
    return false;
  }
  const std::size_t kept = decimal.digits.size() - dropped;
  const bool up = decimal.digits[kept] >= '5';
  decimal.digits.resize(kept);
  return up;
}

}  // namespace

Result<Ticks, BadSeconds> seconds_from(std::string_view text, BelowNanosecond below) {
  std::optional<Decimal> decimal = parse(text);
  if (!decimal) return tl::unexpected(BadSeconds::kNotANumber);
  if (decimal->digits.empty()) return Ticks{0};
  const bool too_fine = decimal->exponent < 0;
  if (too_fine && below == BelowNanosecond::kRefuse) return tl::unexpected(BadSeconds::kTooFine);
  const bool up = too_fine && drop_fraction(*decimal);
  const auto length = static_cast<long>(decimal->digits.size()) + decimal->exponent;
  if (length > static_cast<long>(kMostDigits)) return tl::unexpected(BadSeconds::kOverflow);
  decimal->digits.append(static_cast<std::size_t>(decimal->exponent), '0');
  // At most 19 digits: below 10^19, which fits in 64 bits without a sign.
  std::uint64_t value = 0;
  for (const char c : decimal->digits) value = value * 10 + static_cast<std::uint64_t>(c - '0');
  if (up) ++value;
  if (value > static_cast<std::uint64_t>(kLargest)) return tl::unexpected(BadSeconds::kOverflow);
  const auto ticks = static_cast<Ticks>(value);
  return decimal->negative ? -ticks : ticks;
}

std::string seconds_text(Ticks ticks) { return to_text(Duration::nanoseconds(ticks)); }

}  // namespace skein::temporal
