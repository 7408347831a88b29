// SPDX-License-Identifier: Apache-2.0
// skein_temporal_differential [--scenarios N] [--seed S]: the differential test for as long as
// wanted. Exit codes: 0, 1 a mismatch, 2 wrong usage.
#include <charconv>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <string_view>

#include "skein/foundation/exit_code.hpp"
#include "testing/differential.hpp"

namespace skein::temporal::testing {
namespace {

struct Arguments {
  std::uint64_t scenarios = 100'000;
  std::uint64_t seed = 1;
};

bool read(int argc, char** argv, Arguments& arguments) {
  for (int at = 1; at < argc; at += 2) {
    const std::string_view name = argv[at];
    std::uint64_t* target = name == "--scenarios" ? &arguments.scenarios
                            : name == "--seed"    ? &arguments.seed
                                                  : nullptr;
    if (target == nullptr || at + 1 == argc) return false;
    const char* end = argv[at + 1] + std::strlen(argv[at + 1]);
    const auto [stopped, error] = std::from_chars(argv[at + 1], end, *target);
    if (error != std::errc() || stopped != end) return false;
  }
  return true;
}

struct Totals {
  std::uint64_t perturbations = 0;
  std::uint64_t comparisons = 0;
  std::uint64_t inconsistent = 0;
  std::uint64_t mismatches = 0;
};

void play_all_algorithms(std::uint64_t seed, Totals& totals) {
  const DifferentialScenario scenario = make_differential_scenario(seed);
  for (const Algorithm algorithm : kAlgorithms) {
    const DifferentialOutcome outcome = play(scenario, algorithm);
    totals.perturbations += outcome.perturbations;
    totals.comparisons += outcome.comparisons;
    totals.inconsistent += outcome.inconsistent;
    if (!outcome.mismatch) continue;
    ++totals.mismatches;
    std::cerr << '\n';
    std::cout << to_text(algorithm) << ", seed " << seed << ": " << *outcome.mismatch << '\n';
  }
}

int run(const Arguments& arguments) {
  constexpr std::uint64_t kBetweenLines = 500;
  Totals totals;
  for (std::uint64_t number = 0; number < arguments.scenarios; ++number) {
    play_all_algorithms(arguments.seed + number, totals);
    if ((number + 1) % kBetweenLines == 0) {
      std::cerr << '\r' << number + 1 << " of " << arguments.scenarios << " scenarios, "
                << totals.mismatches << " mismatches" << std::flush;
    }
  }
  std::cerr << '\n';
  std::cout << arguments.scenarios << " scenarios × 4 algorithms, " << totals.perturbations
            << " perturbations, " << totals.comparisons << " comparisons, " << totals.inconsistent
            << " of inconsistent networks: " << totals.mismatches << " mismatches\n";
  return totals.mismatches == 0 ? kExitOk : kExitNegative;
}

}  // namespace
}  // namespace skein::temporal::testing

int main(int argc, char** argv) {
  skein::temporal::testing::Arguments arguments;
  if (!skein::temporal::testing::read(argc, argv, arguments)) {
    std::cerr << "usage: " << argv[0] << " [--scenarios N] [--seed S]\n";
    return skein::kExitBadInput;
  }
  return skein::temporal::testing::run(arguments);
}
