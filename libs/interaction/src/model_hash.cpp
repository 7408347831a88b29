// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/model_hash.hpp"
#include "skein/foundation/fingerprint.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include "skein/foundation/overloaded.hpp"

namespace skein::interaction {

namespace {

template <class Enumeration>
std::uint64_t number_of(Enumeration value) {
  return static_cast<std::uint64_t>(value);
}

/// Puts what a model says into a fingerprint; each kind of thing with how many parts it has.
class Meaning {
 public:
  explicit Meaning(const Library& library) : library_(library) {}

  std::uint64_t of(const Model& model) {
    print_.put(model.task);
    list(model.variants, [this](const Variant& one) { put(one); });
    return print_.value();
  }

 private:
  template <class List, class Put>
  void list(const List& list, Put put_one) {
    print_.put(std::uint64_t{list.size()});
    for (const auto& one : list) put_one(one);
  }
  void texts(const std::vector<std::string>& all) {
    list(all, [this](const std::string& one) { print_.put(one); });
  }
  /// Whose order says nothing.
  void set(std::vector<std::string> all) {
    std::sort(all.begin(), all.end());
    texts(all);
  }

  void put(const Variant& variant) {
    print_.put(variant.name);
    put(variant.parameters);
    set(variant.roles);
    std::set<std::string> scms;
    for (const ScmInstance& one : variant.table.scms) scms.insert(one.scm);
    const std::set<std::string> roles(variant.roles.begin(), variant.roles.end());
    list(roles, [this](const std::string& name) { put(library_.roles.at(name)); });
    list(scms, [this](const std::string& name) { put(library_.scms.at(name)); });
    put(variant.table);
    if (!variant.by_ground.empty()) texts({variant.by_ground.begin(), variant.by_ground.end()});
  }

  void put(const Parameters& parameters) {
    list(parameters, [this](const Parameter& one) {
      print_.put(one.name).put(number_of(one.type)).put(std::uint64_t{one.optional});
    });
  }

  void put(const Role& role) {
    print_.put(role.name);
    std::vector<Requirement> needs = role.requirements;
    std::sort(needs.begin(), needs.end(), [](const Requirement& a, const Requirement& b) {
      return a.capability < b.capability;
    });
    list(needs, [this](const Requirement& one) { put(one); });
    put(role.parameters);
    list(role.automaton.componels(), [this](const Componel& one) { put(one); });
  }

  void put(const Requirement& requirement) {
    print_.put(requirement.capability).put(std::uint64_t{requirement.value.index()});
    std::visit(
        Overloaded{[](std::monostate) {}, [this](const std::string& value) { print_.put(value); },
                   [this](const Requirement::Bound& bound) {
                     print_.put(number_of(bound.relation)).put(bound.value);
                   }},
        requirement.value);
  }

  void put(const Componel& componel) {
    print_.put(componel.id).put(std::uint64_t{componel.parent});
    print_.put(std::uint64_t{componel.what.index()});
    std::visit([this](const auto& what) { put(what); }, componel.what);
  }

  void put(const Block& block) {
    print_.put(number_of(block.type)).put(number_of(block.end));
    put(block.precondition);
    put(block.exit);
    list(block.locals, [this](const LocalParameter& local) {
      print_.put(local.name).put(local.initialiser);
      const std::string function = local.initialiser.substr(0, local.initialiser.find('('));
      const auto found = library_.functions.find(function);
      if (found != library_.functions.end()) put(found->second);
    });
    set(block.scms);
  }

  void put(const Function& function) {
    list(function.takes, [this](ParameterType one) { print_.put(number_of(one)); });
    print_.put(number_of(function.gives));
  }

  void put(const Task& task) {
    print_.put(task.type);
    const auto found = library_.tasks.find(task.type);
    if (found != library_.tasks.end()) put(found->second);
    put(task.parameters);
  }

  void put(const CoordinationAction& action) {
    print_.put(action.modality);
    put(action.in);
    put(action.out);
  }

  void put(const config::Value& value) {
    print_.put(number_of(value.kind));
    if (value.kind == config::Value::Kind::kScalar) put_scalar(value);
    list(value.items, [this](const config::Value& one) { put(one); });
    std::vector<const config::Entry*> entries;
    for (const config::Entry& one : value.entries) entries.push_back(&one);
    std::sort(entries.begin(), entries.end(),
              [](const auto* a, const auto* b) { return a->key < b->key; });
    list(entries, [this](const config::Entry* one) {
      print_.put(one->key);
      put(one->value);
    });
  }

  // 900, 900.0 and 9e2 are one number; "900" is a text.
  void put_scalar(const config::Value& value) {
    double number = 0;
    const char* end = value.scalar.data() + value.scalar.size();
    const auto read = std::from_chars(value.scalar.data(), end, number);
    const bool is_number = !value.quoted && read.ec == std::errc() && read.ptr == end;
    print_.put(std::uint64_t{value.quoted}).put(std::uint64_t{is_number});
    if (is_number) {
      print_.put(number);
    } else {
      print_.put(value.scalar);
    }
  }

  void put(const Formula& formula) {
    list(formula, [this](const Clause& clause) {
      list(clause, [this](const Literal& literal) { put(literal); });
    });
  }

  void put(const Literal& literal) {
    print_.put(std::uint64_t{literal.condition.index()}).put(std::uint64_t{literal.negated});
    print_.put(number_of(literal.modality)).put(number_of(literal.effect));
    std::visit([this](const auto& condition) { put(condition); }, literal.condition);
  }
  void put(const ComponelIs& is) {
    print_.put(std::uint64_t{is.componel}).put(number_of(is.state));
  }
  void put(const MessagePending& is) { print_.put(is.message); }
  void put(const TimeIs& is) {
    print_.put(number_of(is.after.count())).put(std::uint64_t{is.since.index()});
    print_.put(std::uint64_t{is.passed});
    if (!is.named.empty()) print_.put(is.named);
    if (const auto* event = std::get_if<TimeIs::Event>(&is.since)) {
      put(ComponelIs{event->componel, event->state});
    }
  }

  void put(const Scm& scm) {
    print_.put(scm.name);
    // Which is which is told by the names: the order of the formals is that of a map.
    std::vector<std::string> formals;
    for (const Scm::Formal& one : scm.parameters)
      formals.push_back((one.place ? "P" : "N") + one.name);
    set(formals);
    list(scm.constraints, [this](const SpatialConstraint& one) { put(one); });
  }

  void put(const SpatialConstraint& one) {
    print_.put(number_of(one.quantity)).put(number_of(one.relation)).put(one.tolerance);
    texts(one.of);
    print_.put(std::uint64_t{one.than.index()});
    std::visit([this](const auto& than) { put(than); }, one.than);
  }
  void put(const std::vector<std::string>& places) { texts(places); }
  void put(const Term& term) {
    print_.put(std::uint64_t{term.index()});
    std::visit([this](const auto& value) { print_.put(value); }, term);
  }

  void put(const CoordinationTable& table) {
    list(table.arities, [this](const auto& one) {
      print_.put(one.first).put(number_of(one.second.least));
      print_.put(number_of(one.second.most.value_or(-1)));
    });
    put_correspondences(table.correspondences);
    std::map<std::string, const ScmInstance*> instances;
    for (const ScmInstance& one : table.scms) instances[one.id] = &one;
    list(instances, [this](const auto& one) {
      print_.put(one.first).put(one.second->scm);
      list(one.second->arguments, [this](const auto& argument) {
        print_.put(argument.first);
        put(argument.second);
      });
    });
    std::map<std::pair<std::string, std::string>, const ScmPlace*> places;
    for (const ScmPlace& one : table.places) places[{one.id, one.role}] = &one;
    list(places, [this](const auto& one) {
      print_.put(one.first.first).put(one.first.second);
      set(one.second->blocks);
    });
    list(table.parameters, [this](const auto& role) {
      print_.put(role.first);
      list(role.second, [this](const auto& one) { print_.put(one.first).put(one.second); });
    });
  }

  void put_correspondences(std::vector<Correspondence> all) {
    const auto key = [](const Correspondence& one) {
      return std::tie(one.role, one.action, one.target_role, one.target_action, one.number);
    };
    std::sort(all.begin(), all.end(),
              [&](const Correspondence& a, const Correspondence& b) { return key(a) < key(b); });
    list(all, [this](const Correspondence& one) {
      print_.put(one.role).put(one.action).put(one.target_role).put(one.target_action);
      print_.put(number_of(one.number.value_or(-1)));
    });
  }

  const Library& library_;
  Fingerprint print_;
};

}  // namespace

ModelHash hash_of(const Library& library, const std::string& task) {
  return {Meaning(library).of(library.models.at(task))};
}

std::map<std::string, ModelHash> hashes_of(const Library& library) {
  std::map<std::string, ModelHash> hashes;
  for (const auto& [task, model] : library.models) hashes.emplace(task, hash_of(library, task));
  return hashes;
}

std::string to_text(ModelHash hash) { return fingerprint_text(hash.value); }

}  // namespace skein::interaction
