// SPDX-License-Identifier: Apache-2.0
// The laws of the supervisor under random events, with a real executive.
#include <rapidcheck/gtest.h>

#include "testing/core_flight.hpp"

namespace skein::supervisor {
namespace {

RC_GTEST_PROP(Supervisor, KeepsItsLawsWhateverHappens, (std::uint64_t seed)) {
  Random random(seed);
  testing::Flight flight(seed);

  for (int i = 0; i < 40; ++i) {
    flight.disturb();
    flight.run(random.uniform(0, 30));
  }
  flight.settle();
  flight.check_rest();

  RC_LOG() << "seed " << seed << "\n";
  for (const std::string& law : flight.broken()) RC_LOG() << law << "\n";
  RC_ASSERT(flight.broken().empty());
}

}  // namespace
}  // namespace skein::supervisor
