// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "assignment.hpp"
#include "skein/foundation/joined.hpp"
#include "standard_modalities.hpp"

namespace skein::interaction {

namespace {

bool is_count(double number) { return number == static_cast<int>(number); }

Arity arity_of(const Row& role) {
  Arity arity{static_cast<int>(role.numbers[0]), std::nullopt};
  if (role.numbers[1] >= 0) arity.most = static_cast<int>(role.numbers[1]);
  return arity;
}

class RoleAllocation : public NegotiationModality {
 public:
  std::string_view name() const override { return "role-allocation"; }

 private:
  std::optional<std::string> do_check(const Terms& terms) const override {
    std::set<std::string> roles;
    for (const Row& row : terms.parameters) {
      if (row.name.empty() || !roles.insert(row.name).second) {
        return "role '" + row.name + "' is there twice, or has no name";
      }
      const bool two = row.numbers.size() == 2 && std::abs(row.numbers[0]) < 1e6 &&
                       std::abs(row.numbers[1]) < 1e6;
      if (!two || !is_count(row.numbers[0]) || !is_count(row.numbers[1]) || row.numbers[0] < 0) {
        return "role '" + row.name + "' has no arity [least, most]";
      }
    }
    if (roles.empty()) return "no roles";
    return std::nullopt;
  }

  std::optional<std::string> do_check_offer(const Terms& terms, const Rows& offer) const override {
    std::set<std::string> roles, offered;
    for (const Row& row : terms.parameters) roles.insert(row.name);
    for (const Row& row : offer) {
      if (roles.count(row.name) == 0) return "unknown role '" + row.name + "'";
      if (!offered.insert(row.name).second) return "two costs of role '" + row.name + "'";
      if (row.numbers.size() != 1 || !(row.numbers[0] >= 0)) {
        return "role '" + row.name + "' has no cost";
      }
    }
    return std::nullopt;
  }

  Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const override {
    std::vector<Arity> arities;
    for (const Row& row : terms.parameters) {
      arities.push_back(arity_of(row));
    }
    std::vector<std::vector<std::optional<double>>> costs;
    for (const std::string& uav : terms.members) costs.push_back(costs_of(terms, offers.at(uav)));
    const auto best = assign(costs, arities);
    if (!best) return failure(why_none(terms, offers));
    Rows result;
    for (std::size_t i = 0; i < best->size(); ++i) {
      const std::size_t role = (*best)[i];
      result.push_back({terms.members[i], terms.parameters[role].name, {*costs[i][role]}});
    }
    return result;
  }

  /// What each role asks for, and who offers to play it.
  static std::string why_none(const Terms& terms, const Offers& offers) {
    std::string text = "no assignment of roles to the " + std::to_string(terms.members.size()) +
                       " members satisfies the arities:";
    for (const Row& row : terms.parameters) {
      std::vector<std::string> players;
      for (const auto& [uav, offer] : offers) {
        const auto plays = [&](const Row& one) { return one.name == row.name; };
        if (std::any_of(offer.begin(), offer.end(), plays)) players.push_back(uav);
      }
      text += " '" + row.name + "' is for " + to_text(arity_of(row)) + ", offered by " +
              (players.empty() ? "nobody" : joined(players, " and ")) + ";";
    }
    text.pop_back();
    return text;
  }

  static std::vector<std::optional<double>> costs_of(const Terms& terms, const Rows& offer) {
    std::vector<std::optional<double>> costs(terms.parameters.size());
    for (std::size_t i = 0; i < costs.size(); ++i) {
      for (const Row& row : offer) {
        if (row.name == terms.parameters[i].name) costs[i] = row.numbers[0];
      }
    }
    return costs;
  }
};

}  // namespace

std::unique_ptr<NegotiationModality> role_allocation() {
  return std::make_unique<RoleAllocation>();
}

}  // namespace skein::interaction
