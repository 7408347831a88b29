// SPDX-License-Identifier: Apache-2.0
// Errors of a reading as text, for tests.
#pragma once

#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"

namespace skein::temporal {

/// Empty when it was read.
template <class T>
std::string errors_of(const Result<T, Diagnostics>& read) {
  return read ? "" : to_text(read.error());
}

}  // namespace skein::temporal
