// SPDX-License-Identifier: Apache-2.0
#include "skein/sim/messages.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::sim {

std::string_view to_text(FunctionalState state) {
  switch (state) {
    case FunctionalState::kRunning:
      return "running";
    case FunctionalState::kEnded:
      return "ended";
    case FunctionalState::kAborted:
      return "aborted";
  }
  SKEIN_ENSURES(false);
}

}  // namespace skein::sim
