// SPDX-License-Identifier: Apache-2.0
// How much the properties and series of the tests try: little in `./check`, much in `./check
// --long`. RapidCheck's own number of cases is set by the same script (RC_PARAMS).
#pragma once

#include <cstdlib>
#include <string_view>

namespace skein::testing {

/// Whether the long form is asked for: SKEIN_LONG=1 in the environment.
inline bool long_tests() {
  const char* given = std::getenv("SKEIN_LONG");
  return given != nullptr && std::string_view(given) == "1";
}

/// `few` cases, or `many` in the long form.
template <class Number>
Number cases(Number few, Number many) {
  return long_tests() ? many : few;
}

}  // namespace skein::testing
