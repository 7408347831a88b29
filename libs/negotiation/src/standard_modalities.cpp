// SPDX-License-Identifier: Apache-2.0
#include "standard_modalities.hpp"

namespace skein::interaction {

Modalities standard_modalities(const FlownSweep& flown) {
  Modalities all;
  const auto add = [&all](std::unique_ptr<NegotiationModality> one) {
    const std::string name(one->name());
    all.emplace(name, std::move(one));
  };
  add(role_allocation());
  add(time_interval());
  add(area_sharing(flown));
  add(perception_positions());
  add(relay_chain());
  return all;
}

}  // namespace skein::interaction
