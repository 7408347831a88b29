// SPDX-License-Identifier: Apache-2.0
// A hash of a value composed of parts, for comparisons.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace skein {

/// FNV-1a over 64 bits. Every part includes its length or kind, so that "ab", "c" differs from "a",
/// "bc". Not a cryptographic hash: it detects accidental differences only.
class Fingerprint {
 public:
  Fingerprint& put(std::string_view text);
  Fingerprint& put(std::uint64_t number);
  /// Numbers that compare equal give the same fingerprint: -0 and 0, too.
  Fingerprint& put(double number);
  std::uint64_t value() const { return value_; }

 private:
  void byte(unsigned char one) { value_ = (value_ ^ one) * 0x100000001b3ULL; }

  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

/// Sixteen hexadecimal digits.
std::string fingerprint_text(std::uint64_t value);

}  // namespace skein
