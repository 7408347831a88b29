// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/modality.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::interaction {

std::optional<std::string> NegotiationModality::problem_of(const Terms& terms,
                                                           const Rows& offer) const {
  return do_check_offer(terms, offer);
}

Result<Rows, Failure> NegotiationModality::settle(const Terms& terms, const Offers& offers) const {
  SKEIN_EXPECTS(offers.size() == terms.members.size());
  return do_settle(terms, offers);
}

Result<Rows, Failure> reckon(const Terms& terms, const Offers& offers, const FlownSweep& flown) {
  const Modalities all = standard_modalities(flown);
  const auto modality = all.find(terms.modality);
  SKEIN_EXPECTS(modality != all.end());
  return modality->second->settle(terms, offers);
}

}  // namespace skein::interaction
