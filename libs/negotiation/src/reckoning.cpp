// SPDX-License-Identifier: Apache-2.0
#include "reckoning.hpp"

#include <utility>

#include "skein/foundation/fingerprint.hpp"

namespace skein::interaction {

namespace {

Offers offers_in(const Facts& facts) {
  Offers all;
  for (const Entry& one : facts.entries()) all[one.uav] = one.offer;
  return all;
}

}  // namespace

void Reckoning::begin(std::shared_ptr<const NegotiationModality> modality) {
  modality_ = std::move(modality);
}

std::optional<std::string> Reckoning::bad_offer(const Terms& terms, const Facts& facts) const {
  for (const Entry& one : facts.entries()) {
    if (!one.offered) continue;
    if (auto problem = modality_->problem_of(terms, one.offer)) {
      return "the offer of " + one.uav + ": " + *problem;
    }
  }
  return std::nullopt;
}

std::optional<std::string> Reckoning::reckon(const Terms& terms, const Facts& facts,
                                             NegotiationEffects& out) {
  if (result_) return std::nullopt;
  if (!modality_->is_long()) return know(modality_->settle(terms, offers_in(facts)));
  if (!std::exchange(under_way_, true)) out.emplace_back(ReckonResult{terms, offers_in(facts)});
  return std::nullopt;
}

std::optional<std::string> Reckoning::know(Result<Rows, Failure> result) {
  under_way_ = false;
  if (!result) return result.error().why;
  result_ = std::move(*result);
  return std::nullopt;
}

std::uint64_t Reckoning::fingerprint() const {
  Fingerprint print;
  for (const Row& row : *result_) {
    print.put(row.name).put(row.text).put(std::uint64_t{row.numbers.size()});
    for (const double number : row.numbers) print.put(number);
  }
  return print.value();
}

}  // namespace skein::interaction
