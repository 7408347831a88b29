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

/// Instead of a cost, why the member does not offer to play the role.
bool is_refusal(const Row& offered) { return offered.numbers.empty() && !offered.text.empty(); }

/// "heliv and marvin", or "nobody (marvin: no camera)".
std::string players_of(const std::string& role, const Offers& offers) {
  std::vector<std::string> players, refusals;
  for (const auto& [uav, offer] : offers) {
    for (const Row& row : offer) {
      if (row.name != role) continue;
      if (is_refusal(row))
        refusals.push_back(uav + ": " + row.text);
      else
        players.push_back(uav);
    }
  }
  const std::string names = players.empty() ? "nobody" : joined(players, " and ");
  return refusals.empty() ? names : names + " (" + joined(refusals, "; ") + ")";
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
      if (is_refusal(row)) continue;
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

  /// What each role asks for, who offers to play it, and why the others do not.
  static std::string why_none(const Terms& terms, const Offers& offers) {
    std::string text = "no assignment of roles to the " + std::to_string(terms.members.size()) +
                       " members satisfies the arities:";
    for (const Row& row : terms.parameters) {
      text += " '" + row.name + "' is for " + to_text(arity_of(row)) + ", offered by " +
              players_of(row.name, offers) + ";";
    }
    text.pop_back();
    return text;
  }

  static std::vector<std::optional<double>> costs_of(const Terms& terms, const Rows& offer) {
    std::vector<std::optional<double>> costs(terms.parameters.size());
    for (std::size_t i = 0; i < costs.size(); ++i) {
      for (const Row& row : offer) {
        if (row.name == terms.parameters[i].name && !is_refusal(row)) costs[i] = row.numbers[0];
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
