// SPDX-License-Identifier: Apache-2.0
// Three members along one street, and why one of them waits.
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "testing/net.hpp"

namespace skein::merging::testing {

inline const std::string kA = "a", kB = "b", kC = "c";

/// A stretch of one street, 10 m wide.
inline Volume stretch(double from, double to) { return {{from, 0}, {to, 0}, 5, 30, 50}; }
inline Volume place(double at) { return stretch(at, at); }

inline void expect_why(const Net& net, const std::string& who, const std::string& peer,
                       Awaited what) {
  EXPECT_THAT(net.whys(who), ::testing::ElementsAre(Waits::Why{peer, what}));
}

}  // namespace skein::merging::testing
