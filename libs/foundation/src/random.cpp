// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/random.hpp"

#include <cmath>
#include <numbers>

#include "skein/foundation/contract.hpp"

namespace skein {

namespace {

// FNV-1a, then a finaliser: neighbouring seeds and similar purposes give unrelated sequences.
std::uint64_t mixed(std::uint64_t seed, std::string_view purpose) {
  std::uint64_t hash = 14695981039346656037ULL ^ seed;
  for (const char c : purpose) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
  return hash ^ (hash >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed, std::string_view purpose) : engine_(mixed(seed, purpose)) {}

double Random::uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

double Random::uniform(double low, double high) {
  SKEIN_EXPECTS(low <= high);
  return low + (high - low) * uniform();
}

std::uint64_t Random::below(std::uint64_t n) {
  SKEIN_EXPECTS(n > 0);
  const std::uint64_t unbiased = ~std::uint64_t{0} - ~std::uint64_t{0} % n;
  std::uint64_t value = engine_();
  while (value >= unbiased) value = engine_();
  return value % n;
}

double Random::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace skein
