// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/fingerprint.hpp"

#include <cstdio>
#include <cstring>

namespace skein {

Fingerprint& Fingerprint::put(std::string_view text) {
  for (const char one : text) byte(static_cast<unsigned char>(one));
  return put(static_cast<std::uint64_t>(text.size()));
}

Fingerprint& Fingerprint::put(std::uint64_t number) {
  for (int shift = 0; shift < 64; shift += 8) byte(static_cast<unsigned char>(number >> shift));
  return *this;
}

Fingerprint& Fingerprint::put(double number) {
  const double plain = number == 0 ? 0 : number;
  std::uint64_t bits = 0;
  std::memcpy(&bits, &plain, sizeof bits);
  return put(bits);
}

std::string fingerprint_text(std::uint64_t value) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
  return digits;
}

}  // namespace skein
