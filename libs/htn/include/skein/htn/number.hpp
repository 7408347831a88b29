// SPDX-License-Identifier: Apache-2.0
// Numbers as Lisp has them: what an operation yields depends on the kinds of its arguments.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"

namespace skein::htn {

enum class NumberKind : std::uint8_t { kInteger, kRatio, kSingle, kDouble };

/// An integer (64 bits), a ratio in lowest terms with denominator > 1, or a float of single or
/// double precision (`0.01` is single, `0.01d0` and `0.01L0` double).
struct Number {
  NumberKind kind = NumberKind::kInteger;
  std::int64_t numerator = 0;    ///< integer and ratio
  std::int64_t denominator = 1;  ///< ratio
  double real = 0;               ///< single (exactly representable as one) and double
  bool operator==(const Number&) const = default;
};

inline Number integer(std::int64_t value) { return {NumberKind::kInteger, value, 1, 0}; }
inline Number real(double value) { return {NumberKind::kDouble, 0, 1, value}; }
Number single(double value);

double to_double(const Number& number);
/// Lisp `=`: compares values whatever the kinds.
bool equal_value(const Number& left, const Number& right);
/// Lisp `<` on values.
bool less_value(const Number& left, const Number& right);

/// The kind of the result is the widest of both (integer, ratio, single, double). Errors: division
/// by zero; an integer or a float beyond its range.
Result<Number, Failure> add(const Number& left, const Number& right);
Result<Number, Failure> subtract(const Number& left, const Number& right);
Result<Number, Failure> multiply(const Number& left, const Number& right);
Result<Number, Failure> divide(const Number& left, const Number& right);

/// Reads "12", "-3", "1/3", ".5", "1.", "2e3", "0.01L0"; empty when the text is no number; an
/// error when it is one that cannot be represented.
std::optional<Result<Number, Failure>> parse_number(std::string_view text);
/// The shortest text that reads back as the same number: "4.0200005", "12", "1/3", "0.5".
/// Integral floats keep ".0"; doubles are written plainly.
std::string to_text(const Number& number);

}  // namespace skein::htn
