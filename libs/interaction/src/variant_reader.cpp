// SPDX-License-Identifier: Apache-2.0
// A variant: its coordination table against the roles and SCMs that it binds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "library_reader.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::interaction {

namespace {

using config::Reader;
using Quantity = SpatialConstraint::Quantity;

constexpr int kMostUavs = 1000;
constexpr const char* kOthers = "R*";

class VariantReader {
 public:
  VariantReader(std::string name, const Library& library) : library_(library) {
    variant_.name = std::move(name);
  }

  Variant read(const Reader& reader) {
    reader.keys({"parameters", "roles", "by-ground", "coordination"});
    variant_.parameters = read_parameters(reader.optional("parameters"));
    read_roles(reader.required("roles"));
    read_by_ground(reader.optional("by-ground"));
    const Reader table = reader.required("coordination");
    table.keys({"arity", "actions", "scms", "blocks", "parameters"});
    read_arities(table.required("arity"));
    read_correspondences(table);
    read_scms(table.optional("scms"));
    read_places(table.optional("blocks"));
    check_scms_in_roles(table);
    read_role_parameters(table);
    return std::move(variant_);
  }

 private:
  CoordinationTable& table() { return variant_.table; }
  const Role& role(const std::string& name) const { return library_.roles.at(name); }
  bool has_role(const std::string& name) const {
    return std::find(variant_.roles.begin(), variant_.roles.end(), name) != variant_.roles.end();
  }

  void read_roles(const Reader& reader) {
    for (const Reader& one : reader.items()) {
      const std::string name = one.name_among(names_in(library_.roles), "a role that is defined");
      if (name.empty()) {
        some_role_unknown_ = true;
        continue;
      }
      if (has_role(name)) one.error("the role '" + name + "' is there twice", "each role once");
      variant_.roles.push_back(name);
    }
    if (reader.is_sequence() && reader.items().empty())
      reader.error("no roles", "at least one role");
  }

  // What is left of an area only its own UAV knows as it flies.
  void read_by_ground(const Reader& reader) {
    for (const Reader& one : reader.items()) {
      const std::string name = role_named(one, one.text());
      if (name.empty()) continue;
      variant_.by_ground.insert(name);
      for (const Componel& componel : role(name).automaton.componels()) {
        if (componel.action() == nullptr || componel.action()->modality != "area-sharing") continue;
        one.error("'" + name + "' shares an area, which the ground station cannot do for a UAV",
                  "roles without area-sharing");
      }
    }
  }

  /// What hangs on a role that `roles` misspells is no further error.
  bool may_be_unknown_role(const std::string& name) const {
    return some_role_unknown_ && library_.roles.count(name) > 0;
  }

  /// One of the roles of this variant; reported and empty if it is none.
  std::string role_named(const Reader& reader, const std::string& name) const {
    if (has_role(name)) return name;
    if (may_be_unknown_role(name)) return "";
    reader.error("unknown role '" + name + "'", "a role of this variant",
                 nearest_name(name, variant_.roles));
    return "";
  }

  // --- (1) arities

  void read_arities(const Reader& reader) {
    for (const auto& [name, value] : reader.entries()) {
      if (!role_named(value, name).empty()) table().arities[name] = read_arity(value);
    }
    long long most = 0;
    for (const std::string& name : variant_.roles) {
      const auto found = table().arities.find(name);
      if (found == table().arities.end()) {
        if (reader.present()) reader.error("no arity of '" + name + "'", name + ": 1");
        most += kMostUavs;
      } else {
        most += found->second.most.value_or(kMostUavs);
      }
    }
    if (reader.present() && most < 2) {
      reader.error("no team can play this: a joint task takes at least two UAVs",
                   "arities that allow two");
    }
  }

  static Arity read_arity(const Reader& reader) {
    if (reader.is_scalar()) {
      const int n = static_cast<int>(reader.integer(1, 1, kMostUavs));
      return {n, n};
    }
    reader.keys({"at-least", "at-most", "between"});
    const Reader least = reader.optional("at-least");
    const Reader most = reader.optional("at-most");
    const Reader between = reader.optional("between");
    if (least.present() + most.present() + between.present() != 1) {
      reader.error("no arity", "a number, or one of at-least, at-most and between");
      return {};
    }
    if (least.present()) return {static_cast<int>(least.integer(1, 0, kMostUavs)), std::nullopt};
    if (most.present()) return {0, static_cast<int>(most.integer(1, 1, kMostUavs))};
    const std::vector<Reader> ends = between.items();
    if (ends.size() != 2) {
      between.error("no range", "[LEAST, MOST]");
      return {};
    }
    const int low = static_cast<int>(ends[0].integer(1, 0, kMostUavs));
    const int high = static_cast<int>(ends[1].integer(low, 1, kMostUavs));
    if (high < low) between.error("no number is between them", "[LEAST, MOST]");
    return {low, high};
  }

  // --- (2) correspondences

  void read_correspondences(const Reader& coordination) {
    const Reader reader = coordination.optional("actions");
    std::vector<Reader> at;
    for (const Reader& one : reader.items()) {
      one.keys({"role", "action", "with", "target", "who"});
      Correspondence read;
      const CoordinationAction* own = read_action(one, "role", "action", read.role, read.action);
      const CoordinationAction* target =
          read_action(one, "with", "target", read.target_role, read.target_action);
      if (own == nullptr || target == nullptr) continue;
      if (own->modality != target->modality) {
        one.error("'" + read.action + "' is " + own->modality + " and '" + read.target_action +
                      "' is " + target->modality,
                  "actions of one modality");
      }
      read_number(one.required("who"), read);
      table().correspondences.push_back(std::move(read));
      at.push_back(one);
    }
    for (std::size_t i = 0; i < at.size(); ++i) check_symmetry(at[i], table().correspondences[i]);
    check_actions_answered(reader.present() ? reader : coordination);
  }

  const CoordinationAction* read_action(const Reader& reader, const char* role_key,
                                        const char* action_key, std::string& role_name,
                                        std::string& action_name) const {
    const Reader role_at = reader.required(role_key);
    const Reader action_at = reader.required(action_key);
    if (!role_at.is_scalar() || !action_at.is_scalar()) return nullptr;
    role_name = role_named(role_at, role_at.text());
    action_name = action_at.text();
    if (role_name.empty()) return nullptr;
    const Automaton& automaton = role(role_name).automaton;
    std::vector<std::string> actions;
    for (const Componel& one : automaton.componels()) {
      if (one.action() == nullptr) continue;
      if (one.id == action_name) return one.action();
      actions.push_back(one.id);
    }
    action_at.error("unknown action '" + action_name + "'",
                    "a coordination action of '" + role_name + "'",
                    nearest_name(action_name, actions));
    return nullptr;
  }

  void read_number(const Reader& reader, Correspondence& read) {
    if (reader.is_scalar() && reader.text() == "everyone") return;
    read.number = static_cast<int>(reader.integer(1, 1, kMostUavs));
    const auto arity = table().arities.find(read.target_role);
    if (arity == table().arities.end() || !arity->second.most) return;
    const int others = *arity->second.most - (read.role == read.target_role ? 1 : 0);
    if (*read.number > others) {
      reader.error("no team has " + std::to_string(*read.number) + " others who play '" +
                       read.target_role + "'",
                   "at most " + std::to_string(others) + ", or everyone");
    }
  }

  void check_symmetry(const Reader& reader, const Correspondence& one) const {
    const auto& all = variant_.table.correspondences;
    const bool answered = std::any_of(all.begin(), all.end(), [&](const Correspondence& other) {
      return other.role == one.target_role && other.action == one.target_action &&
             other.target_role == one.role && other.target_action == one.action;
    });
    if (answered) return;
    reader.error("'" + one.target_action + "' of '" + one.target_role + "' does not answer it",
                 "{role: " + one.target_role + ", action: " + one.target_action +
                     ", with: " + one.role + ", target: " + one.action + ", who: …}");
  }

  // A negotiation that nobody else takes part in can never come to anything.
  void check_actions_answered(const Reader& reader) const {
    if (some_role_unknown_) return;
    for (const std::string& name : variant_.roles) {
      for (const Componel& one : role(name).automaton.componels()) {
        if (one.action() == nullptr) continue;
        const auto& all = variant_.table.correspondences;
        const bool there = std::any_of(all.begin(), all.end(), [&](const Correspondence& other) {
          return other.role == name && other.action == one.id;
        });
        if (!there) {
          reader.error("'" + one.id + "' of '" + name + "' corresponds to nothing",
                       "an action of another role for it");
        }
      }
    }
  }

  // --- (3) SCMs with their values

  void read_scms(const Reader& reader) {
    for (const auto& [id, value] : reader.entries()) {
      const std::string name =
          value.required("scm").name_among(names_in(library_.scms), "an SCM that is defined");
      ScmInstance instance{id, name, {}};
      if (!name.empty()) {
        read_arguments(value, library_.scms.at(name), instance);
        check_possible(value, library_.scms.at(name), instance);
      }
      table().scms.push_back(std::move(instance));
    }
  }

  void read_arguments(const Reader& reader, const Scm& scm, ScmInstance& instance) {
    std::vector<std::string> names;
    for (const Scm::Formal& formal : scm.parameters) {
      names.push_back(formal.name);
      const Reader argument = reader.required(formal.name);
      if (!argument.present()) continue;
      instance.arguments[formal.name] =
          formal.place ? Term(read_place(argument)) : read_number_term(argument);
    }
    for (const auto& [name, value] : reader.entries()) {
      if (name == "scm" || std::find(names.begin(), names.end(), name) != names.end()) continue;
      value.error("'" + scm.name + "' has no parameter '" + name + "'", "one of its parameters",
                  nearest_name(name, names));
    }
  }

  std::string read_place(const Reader& reader) const {
    const std::string name = reader.text();
    if (name == kOthers || has_role(name) || may_be_unknown_role(name)) return name;
    const Parameter* parameter = find(variant_.parameters, name);
    if (parameter == nullptr) {
      std::vector<std::string> names = names_in(variant_.parameters);
      names.insert(names.end(), variant_.roles.begin(), variant_.roles.end());
      reader.error("unknown place '" + name + "'",
                   "a parameter of the variant, one of its roles, or R*",
                   nearest_name(name, names));
    } else if (!fits(parameter->type, ParameterType::kPoint)) {
      reader.error("'" + name + "' is of type " + std::string(to_text(parameter->type)),
                   "an Obj or a Point");
    }
    return name;
  }

  Term read_number_term(const Reader& reader) const {
    const Parameter* parameter =
        reader.is_scalar() ? find(variant_.parameters, reader.text()) : nullptr;
    if (parameter == nullptr) return reader.number();
    if (parameter->type != ParameterType::kNumber) {
      reader.error("'" + parameter->name + "' is of type " + std::string(to_text(parameter->type)),
                   "a Number");
    }
    return parameter->name;
  }

  // Bounds on one quantity that leave nothing between them.
  static void check_possible(const Reader& reader, const Scm& scm, const ScmInstance& instance) {
    std::map<std::pair<Quantity, std::vector<std::string>>, std::pair<double, double>> ranges;
    for (const SpatialConstraint& one : scm.constraints) {
      const auto value = number_of(one, instance);
      if (!value) continue;
      check_angle(reader, one, *value);
      auto& [low, high] = ranges.try_emplace({one.quantity, one.of}, -1e300, 1e300).first->second;
      const bool equal = one.relation == Relation::kEqual;
      if (equal || one.relation >= Relation::kAtLeast) low = std::max(low, *value - one.tolerance);
      if (equal || one.relation <= Relation::kAtMost) high = std::min(high, *value + one.tolerance);
    }
    for (const auto& [of, range] : ranges) {
      if (range.first < range.second) continue;
      reader.error("no position satisfies it: '" + of.second.front() + "' is to be beyond " +
                       text_of(range.first) + " and within " + text_of(range.second),
                   "bounds with something between them");
    }
  }

  static std::optional<double> number_of(const SpatialConstraint& one,
                                         const ScmInstance& instance) {
    const auto* term = std::get_if<Term>(&one.than);
    if (term == nullptr) return std::nullopt;
    if (const double* number = std::get_if<double>(term)) return *number;
    const auto found = instance.arguments.find(std::get<std::string>(*term));
    if (found == instance.arguments.end()) return std::nullopt;
    const double* number = std::get_if<double>(&found->second);
    return number != nullptr ? std::optional(*number) : std::nullopt;
  }

  static void check_angle(const Reader& reader, const SpatialConstraint& one, double value) {
    constexpr double kPi = std::numbers::pi;
    const bool azimuth = one.quantity == Quantity::kAzimuth;
    const bool altitude = one.quantity == Quantity::kAltitude;
    if (azimuth && (value < 0 || value >= 2 * kPi)) {
      reader.error("no azimuth: " + text_of(value), "from 0 to less than 2π rad");
    }
    if (altitude && std::abs(value) > kPi / 2) {
      reader.error("no altitude: " + text_of(value), "from -π/2 to π/2 rad");
    }
    if (one.quantity == Quantity::kDistance && value < 0) {
      reader.error("no distance: " + text_of(value), "at least 0 m");
    }
  }

  static std::string text_of(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }

  // --- (4) where they hold

  void read_places(const Reader& reader) {
    for (const auto& [id, by_role] : reader.entries()) {
      if (!has_scm(id))
        by_role.error("unknown SCM '" + id + "'", "one of `scms`", nearest_name(id, scm_ids()));
      for (const auto& [name, blocks] : by_role.entries()) {
        const std::string role_name = role_named(blocks, name);
        if (role_name.empty()) continue;
        ScmPlace place{id, role_name, {}};
        for (const Reader& one : blocks.items()) {
          if (is_block(one, role_name)) place.blocks.push_back(one.text());
        }
        table().places.push_back(std::move(place));
      }
    }
    for (const ScmInstance& one : table().scms) {
      const bool held = std::any_of(variant_.roles.begin(), variant_.roles.end(),
                                    [&](const std::string& name) { return holds(name, one.id); });
      if (!held && !some_role_unknown_)
        reader.error("the SCM '" + one.id + "' holds nowhere", one.id + ": {ROLE: [BLOCK]}");
    }
  }

  bool is_block(const Reader& reader, const std::string& role_name) const {
    const Automaton& automaton = role(role_name).automaton;
    const auto index = automaton.find(reader.text());
    if (index && automaton[*index].block() != nullptr) return true;
    reader.error("'" + reader.text() + "' is no block of '" + role_name + "'", "the id of a block",
                 nearest_name(reader.text(), automaton.ids()));
    return false;
  }

  bool has_scm(const std::string& id) const {
    const auto ids = scm_ids();
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  }
  std::vector<std::string> scm_ids() const {
    std::vector<std::string> ids;
    for (const ScmInstance& one : variant_.table.scms) ids.push_back(one.id);
    return ids;
  }

  /// In some block of the role, by the table or by the role itself.
  bool holds(const std::string& role_name, const std::string& id) const {
    const auto& places = variant_.table.places;
    const auto says_so = [&](const ScmPlace& one) {
      return one.role == role_name && one.id == id && !one.blocks.empty();
    };
    if (std::any_of(places.begin(), places.end(), says_so)) return true;
    for (const Componel& one : role(role_name).automaton.componels()) {
      const Block* block = one.block();
      if (block == nullptr) continue;
      if (std::find(block->scms.begin(), block->scms.end(), id) != block->scms.end()) return true;
    }
    return false;
  }

  // What roles say of SCMs: those they hold, and messages about them.
  void check_scms_in_roles(const Reader& reader) const {
    for (const std::string& name : variant_.roles) {
      for (const Componel& one : role(name).automaton.componels()) {
        const Block* block = one.block();
        if (block == nullptr) continue;
        for (const std::string& id : block->scms) {
          if (has_scm(id)) continue;
          reader.error("'" + one.id + "' of '" + name + "' holds '" + id + "', which is not there",
                       "scms: {" + id + ": …}", nearest_name(id, scm_ids()));
        }
        check_messages(reader, name, one, block->precondition);
        check_messages(reader, name, one, block->exit);
      }
    }
  }

  void check_messages(const Reader& reader, const std::string& name, const Componel& componel,
                      const Formula& formula) const {
    for (const Clause& clause : formula) {
      for (const Literal& literal : clause) {
        const auto* message = std::get_if<MessagePending>(&literal.condition);
        const std::string id = message != nullptr ? scm_in(message->message) : "";
        if (id.empty() || literal.negated || holds(name, id)) continue;
        reader.error("'" + componel.id + "' of '" + name + "' waits for '" + message->message +
                         "', which can never come: '" + id + "' holds in no block of that role",
                     "blocks: {" + id + ": {" + name + ": [BLOCK]}}", nearest_name(id, scm_ids()));
      }
    }
  }

  // "mcs2" of "mcs2 violated"; empty if it is no message of the checker.
  static std::string scm_in(const std::string& message) {
    for (const char* finding : {" violated", " satisfied", " undetermined"}) {
      const std::string end = finding;
      if (message.size() > end.size() && message.ends_with(end)) {
        return message.substr(0, message.size() - end.size());
      }
    }
    return "";
  }

  // --- (5) parameters of roles

  void read_role_parameters(const Reader& coordination) {
    const Reader reader = coordination.optional("parameters");
    for (const auto& [name, given] : reader.entries()) {
      if (role_named(given, name).empty()) continue;
      for (const auto& [parameter, value] : given.entries()) {
        if (find(role(name).parameters, parameter) == nullptr) {
          value.error("'" + name + "' has no parameter '" + parameter + "'",
                      "one of its parameters",
                      nearest_name(parameter, names_in(role(name).parameters)));
        }
      }
    }
    for (const std::string& name : variant_.roles) {
      const Reader given = reader.optional(name);
      for (const Parameter& parameter : role(name).parameters) {
        const Reader value = given.optional(parameter.name);
        if (value.present()) {
          table().parameters[name][parameter.name] = read_role_parameter(value, parameter);
        } else {
          (given.present() ? given : coordination)
              .error("the parameter '" + parameter.name + "' of '" + name + "' is not given",
                     "parameters: {" + name + ": {" + parameter.name + ": …}}");
        }
      }
    }
  }

  std::string read_role_parameter(const Reader& reader, const Parameter& parameter) const {
    const std::string name = reader.text();
    const Parameter* given = find(variant_.parameters, name);
    if (given == nullptr) {
      reader.error("unknown parameter '" + name + "'", "a parameter of the variant",
                   nearest_name(name, names_in(variant_.parameters)));
    } else if (!fits(given->type, parameter.type)) {
      reader.error("'" + name + "' is of type " + std::string(to_text(given->type)),
                   "one of type " + std::string(to_text(parameter.type)));
    }
    return name;
  }

  const Library& library_;
  Variant variant_;
  bool some_role_unknown_ = false;
};

}  // namespace

Variant read_variant(const std::string& name, const Reader& reader, const Library& library) {
  return VariantReader(name, library).read(reader);
}

}  // namespace skein::interaction
