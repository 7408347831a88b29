// SPDX-License-Identifier: Apache-2.0
// Numbers read and written.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "skein/htn/number.hpp"

namespace skein::htn {

namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

// The parts of a number as written, each a piece of its text.
struct Parts {
  bool negative = false;
  std::string_view whole;
  bool point = false;
  std::string_view fraction;
  char marker = 0;  // of the exponent, in lower case; 0: none
  std::string_view exponent;
  bool slash = false;
  std::string_view denominator;
};

std::string_view take_digits(std::string_view& text) {
  std::size_t count = 0;
  while (count < text.size() && is_digit(text[count])) ++count;
  const std::string_view digits = text.substr(0, count);
  text.remove_prefix(count);
  return digits;
}

bool take(std::string_view& text, char letter) {
  if (text.empty() || text.front() != letter) return false;
  text.remove_prefix(1);
  return true;
}

// Marks: e as the reader is told (single), s f single, d l double.
bool take_exponent(std::string_view& text, Parts& parts) {
  if (text.empty()) return true;
  const char marker = static_cast<char>(text.front() | 0x20);
  if (std::string_view("esfdl").find(marker) == std::string_view::npos) return false;
  parts.marker = marker;
  text.remove_prefix(1);
  const std::string_view start = text;
  if (!take(text, '+')) take(text, '-');
  const std::string_view digits = take_digits(text);
  parts.exponent = start.substr(0, start.size() - text.size());
  if (parts.exponent.starts_with('+')) parts.exponent.remove_prefix(1);
  return !digits.empty();
}

std::optional<Parts> split(std::string_view text) {
  Parts parts;
  parts.negative = take(text, '-');
  if (!parts.negative) take(text, '+');
  parts.whole = take_digits(text);
  if (!parts.whole.empty() && take(text, '/')) {
    parts.slash = true;
    parts.denominator = take_digits(text);
    if (parts.denominator.empty() || !text.empty()) return std::nullopt;
    return parts;
  }
  parts.point = take(text, '.');
  if (parts.point) parts.fraction = take_digits(text);
  if (parts.whole.empty() && parts.fraction.empty()) return std::nullopt;
  if (!take_exponent(text, parts) || !text.empty()) return std::nullopt;
  return parts;
}

Result<std::int64_t, Failure> parse_integer(bool negative, std::string_view digits) {
  const std::string text = (negative ? "-" : "") + std::string(digits);
  std::int64_t value = 0;
  const auto outcome = std::from_chars(text.data(), text.data() + text.size(), value);
  if (outcome.ec != std::errc{}) return failure("integer beyond 64 bits");
  return value;
}

Result<Number, Failure> parse_ratio(const Parts& parts) {
  const auto numerator = parse_integer(parts.negative, parts.whole);
  const auto denominator = parse_integer(false, parts.denominator);
  if (!numerator) return tl::unexpected(numerator.error());
  if (!denominator) return tl::unexpected(denominator.error());
  return divide(integer(*numerator), integer(*denominator));
}

template <class Real>
Result<double, Failure> parse_real(const std::string& text) {
  Real value = 0;
  const auto outcome = std::from_chars(text.data(), text.data() + text.size(), value);
  if (outcome.ec != std::errc{}) return failure("float beyond its range");
  return static_cast<double>(value);
}

Result<Number, Failure> parse_float(const Parts& parts) {
  std::string text = parts.negative ? "-" : "";
  text.append(parts.whole.empty() ? "0" : parts.whole).append(".");
  text.append(parts.fraction.empty() ? "0" : parts.fraction);
  if (parts.marker != 0) text.append("e").append(parts.exponent);
  const bool is_double = parts.marker == 'd' || parts.marker == 'l';
  const auto value = is_double ? parse_real<double>(text) : parse_real<float>(text);
  if (!value) return tl::unexpected(value.error());
  return is_double ? real(*value) : single(*value);
}

void append_integral(std::int64_t value, std::string& out) {
  std::array<char, 24> buffer{};
  const auto [end, failed] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), end);
}

// What Lisp writes without an exponent; false for anything else.
template <class Real>
bool append_plain(Real value, std::string& out) {
  const Real size = std::abs(value);
  if (value != 0 && !(size >= static_cast<Real>(1e-3) && size < static_cast<Real>(1e7)))
    return false;
  std::array<char, 64> buffer{};
  const auto [end, failed] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  out += text;
  if (text.find('.') == std::string_view::npos) out += ".0";
  return true;
}

// Digits of the shortest text, and the power of ten of the first of them.
struct Decimal {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

Decimal shortest(const Number& number) {
  std::array<char, 64> buffer{};
  const auto format = std::chars_format::scientific;
  char* const end = buffer.data() + buffer.size();
  const auto outcome =
      number.kind == NumberKind::kSingle
          ? std::to_chars(buffer.data(), end, static_cast<float>(number.real), format)
          : std::to_chars(buffer.data(), end, number.real, format);
  std::string_view text(buffer.data(), static_cast<std::size_t>(outcome.ptr - buffer.data()));
  Decimal decimal;
  decimal.negative = take(text, '-');
  decimal.digits = take_digits(text);
  if (take(text, '.')) decimal.digits += take_digits(text);
  take(text, 'e');
  take(text, '+');
  std::from_chars(text.data(), text.data() + text.size(), decimal.exponent);
  return decimal;
}

std::string plain(const Decimal& decimal) {
  const std::string& digits = decimal.digits;
  if (decimal.exponent < 0) {
    return "0." + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') + digits;
  }
  const auto whole = static_cast<std::size_t>(decimal.exponent) + 1;
  if (digits.size() <= whole) return digits + std::string(whole - digits.size(), '0') + ".0";
  return digits.substr(0, whole) + '.' + digits.substr(whole);
}

std::string with_exponent(const Decimal& decimal) {
  const std::string rest = decimal.digits.substr(1);
  return decimal.digits.substr(0, 1) + '.' + (rest.empty() ? "0" : rest) + 'e' +
         std::to_string(decimal.exponent);
}

// Lisp's bounds of the plain form.
std::string real_text(const Number& number) {
  if (!std::isfinite(number.real)) return std::isnan(number.real) ? "nan" : "infinity";
  const Decimal decimal = shortest(number);
  const bool is_plain = number.real == 0 || (decimal.exponent >= -3 && decimal.exponent < 7);
  return (decimal.negative ? "-" : "") + (is_plain ? plain(decimal) : with_exponent(decimal));
}

}  // namespace

std::optional<Result<Number, Failure>> parse_number(std::string_view text) {
  const std::optional<Parts> parts = split(text);
  if (!parts) return std::nullopt;
  if (parts->slash) return parse_ratio(*parts);
  const bool is_float = !parts->fraction.empty() || parts->marker != 0;
  if (is_float) return parse_float(*parts);
  const auto value = parse_integer(parts->negative, parts->whole);
  if (!value) return Result<Number, Failure>(tl::unexpected(value.error()));
  return Result<Number, Failure>(integer(*value));
}

std::string to_text(const Number& number) {
  std::string out;
  switch (number.kind) {
    case NumberKind::kInteger:
      append_integral(number.numerator, out);
      return out;
    case NumberKind::kRatio:
      append_integral(number.numerator, out);
      out += '/';
      append_integral(number.denominator, out);
      return out;
    case NumberKind::kSingle:
      if (append_plain(static_cast<float>(number.real), out)) return out;
      break;
    case NumberKind::kDouble:
      if (append_plain(number.real, out)) return out;
      break;
  }
  return real_text(number);
}

}  // namespace skein::htn
