// SPDX-License-Identifier: Apache-2.0
// A number that tells whether two values are the same, for values that are put together from parts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace skein {

/// FNV-1a over 64 bits. Every part is closed by its length or kind, so that "ab", "c" is not "a",
/// "bc". It finds differences that happen, not those that somebody makes to deceive.
class Fingerprint {
 public:
  Fingerprint& put(std::string_view text);
  Fingerprint& put(std::uint64_t number);
  /// Numbers that compare equal are equal: -0 is 0.
  Fingerprint& put(double number);
  std::uint64_t value() const { return value_; }

 private:
  void byte(unsigned char one) { value_ = (value_ ^ one) * 0x100000001b3ULL; }

  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

/// Sixteen hexadecimal digits.
std::string fingerprint_text(std::uint64_t value);

}  // namespace skein
