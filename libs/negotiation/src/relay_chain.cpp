// SPDX-License-Identifier: Apache-2.0
#include "assignment.hpp"
#include "choices.hpp"
#include "standard_modalities.hpp"

namespace skein::interaction {

namespace {

class RelayChain : public NegotiationModality {
 public:
  std::string_view name() const override { return "relay-chain"; }

 private:
  std::optional<std::string> do_check(const Terms& terms) const override {
    if (terms.parameters.empty()) return "no links";
    if (terms.parameters.size() > terms.members.size()) return "more links than members";
    for (const Row& row : terms.parameters) {
      if (row.name != "link" || row.numbers.size() != 3) return "'" + row.name + "' is no link";
    }
    return std::nullopt;
  }

  std::optional<std::string> do_check_offer(const Terms& terms, const Rows& offer) const override {
    return problem_of_choices(offer, "link", terms.parameters.size());
  }

  Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const override {
    const std::size_t links = terms.parameters.size();
    std::vector<Arity> arities(links, Arity{1, 1});
    arities.push_back({0, std::nullopt});  // who is not needed
    std::vector<std::vector<std::optional<double>>> costs;
    for (const std::string& uav : terms.members) {
      costs.push_back(costs_of_choices(offers.at(uav), links));
      costs.back().push_back(0.0);
    }
    const auto best = assign(costs, arities);
    if (!best) return failure("some link suits nobody");
    Rows result;
    for (std::size_t i = 0; i < best->size(); ++i) {
      const bool needed = (*best)[i] < links;
      result.push_back({terms.members[i], "", {needed ? static_cast<double>((*best)[i]) : -1}});
    }
    return result;
  }
};

}  // namespace

std::unique_ptr<NegotiationModality> relay_chain() { return std::make_unique<RelayChain>(); }

}  // namespace skein::interaction
