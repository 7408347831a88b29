// SPDX-License-Identifier: Apache-2.0
// The result type of functions that can fail.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace skein {

/// The expected value, or the facts of the failure. Policy: docs/decisions/0002-errors.md.
template <class T, class E>
using Result = tl::expected<T, E>;

/// An error whose only fact is a sentence for people; prefer an enumeration with facts where a
/// caller may want to tell cases apart.
struct Failure {
  std::string why;
  bool operator==(const Failure&) const = default;
};

inline tl::unexpected<Failure> failure(std::string why) {
  return tl::unexpected<Failure>(Failure{std::move(why)});
}

}  // namespace skein
