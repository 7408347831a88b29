// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/contract.hpp"

#include <cstdio>
#include <cstdlib>

namespace skein::detail {

void contract_broken(const char* kind, const char* condition, const char* file, int line) {
  std::fprintf(stderr, "skein: broken %s: %s (%s:%d)\n", kind, condition, file, line);
  std::fflush(stderr);
  std::abort();
}

}  // namespace skein::detail
