// SPDX-License-Identifier: Apache-2.0
#include "skein/merging/former_life.hpp"

#include "skein/foundation/contract.hpp"
#include "skein/foundation/rising.hpp"

namespace skein::merging {

bool FormerLife::may_have_granted(std::uint64_t request) const {
  SKEIN_EXPECTS(begun_.has_value());
  return with_witness_ && !was_none_ && request < Rising::least(*begun_ + kClocksApart);
}

}  // namespace skein::merging
