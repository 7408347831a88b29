// SPDX-License-Identifier: Apache-2.0
#include "testing/random_domain.hpp"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "skein/foundation/random.hpp"

namespace skein::htn::oracle {

namespace {

using Words = std::vector<std::string>;

const Words kConstants{"a", "b", "c"};
const Words kUnary{"p", "q"};
const Words kBinary{"r", "s"};
constexpr std::uint64_t kTasks = 5;
constexpr std::uint64_t kOperators = 4;

std::string form(std::initializer_list<std::string> items) {
  std::string out = "(";
  for (const std::string& item : items) out += (out.size() > 1 ? " " : "") + item;
  return out + ")";
}

/// The variables of one clause that are bound where the text stands.
struct Scope {
  Words things;   ///< to constants
  Words numbers;  ///< to numbers
  int fresh = 0;
  std::string next() { return "?v" + std::to_string(fresh++); }
};

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed, "random domain") {}

  std::string file() {
    std::string out = "(defdomain d (\n";
    for (std::uint64_t at = 0; at < kOperators; ++at) out += an_operator(at);
    for (std::uint64_t task = 0; task < kTasks; ++task) {
      for (std::uint64_t many = 1 + below(2); many > 0; --many) out += method(task);
    }
    out += axioms() + "))\n";
    return out + problem();
  }

 private:
  std::uint64_t below(std::uint64_t n) { return random_.below(n); }
  bool chance(double probability) { return random_.chance(probability); }
  const std::string& one_of(const Words& words) { return words[below(words.size())]; }

  std::string known(const Scope& scope) {
    if (scope.things.empty() || chance(0.2)) return one_of(kConstants);
    return one_of(scope.things);
  }
  /// Something known, or a new variable that the goal will bind.
  std::string any(Scope& scope) {
    if (!chance(0.45)) return known(scope);
    scope.things.push_back(scope.next());
    return scope.things.back();
  }
  std::string known_atom(const Scope& scope) {
    if (chance(0.5)) return form({one_of(kUnary), known(scope)});
    return form({one_of(kBinary), known(scope), known(scope)});
  }
  std::string atom(Scope& scope) {
    const std::string first = any(scope);
    if (chance(0.4)) return form({one_of(kUnary), first});
    if (chance(0.15)) return form({"u", first});
    if (chance(0.2)) return form({chance(0.5) ? "k" : "path", first, any(scope)});
    return form({one_of(kBinary), first, any(scope)});
  }

  std::string logical(Scope& scope, int depth) {
    const std::string inner = "?w" + std::to_string(scope.fresh++);
    switch (below(8)) {
      case 0:
        return form({"not", chance(0.7) ? known_atom(scope) : form({"r", known(scope), inner})});
      case 1: {
        scope.things.push_back(inner);
        std::string other = form({"s", inner, known(scope)});
        if (chance(0.3)) other = form({other, form({"p", inner})});
        return form({"or", form({one_of(kUnary), inner}), other});
      }
      case 2:
        return form({"imply", known_atom(scope), known_atom(scope)});
      case 3:
        return form({"forall", form({inner}), form({"r", known(scope), inner}),
                     form({one_of(kUnary), inner})});
      case 4:
        return form({"exists", form({inner}), form({"p", inner}), form({"q", inner})});
      case 5: {
        const std::string list = scope.next();
        scope.things.push_back(list);
        return form(
            {chance(0.7) ? "setof" : "bagof", inner, form({chance(0.5) ? "u" : "p", inner}), list});
      }
      case 6:
        return depth > 1 ? atom(scope)
                         : form({"and", goal(scope, depth + 1), goal(scope, depth + 1)});
      default:
        return depth > 1 ? atom(scope) : form({goal(scope, depth + 1), goal(scope, depth + 1)});
    }
  }
  std::string number(Scope& scope) {
    if (scope.numbers.empty()) {
      scope.numbers.push_back(scope.next());
      return form({"n", scope.numbers.back()});
    }
    const std::string from = one_of(scope.numbers);
    if (chance(0.4)) {
      scope.numbers.push_back(scope.next());
      return form({"assign", scope.numbers.back(), form({"+", from, std::to_string(below(3))})});
    }
    if (chance(0.3)) return form({"call", "<", from, "3"});
    if (chance(0.4)) return form({"eval", form({">", from, "1"})});
    scope.numbers.push_back(scope.next());
    return form({"n", scope.numbers.back()});
  }
  std::string goal(Scope& scope, int depth = 0) {
    if (chance(0.6)) return atom(scope);
    if (chance(0.25)) return number(scope);
    if (chance(0.1)) {
      scope.things.push_back(scope.next());
      return form({"assign*", scope.things.back(), "(list 'a 'b)"});
    }
    if (chance(0.1) && scope.things.size() > 1) {
      return "(eval (not (eq '" + scope.things[0] + " '" + scope.things[1] + ")))";
    }
    return logical(scope, depth);
  }
  std::string goals(Scope& scope, std::uint64_t most) {
    std::string out;
    for (std::uint64_t many = 1 + below(most); many > 0; --many) out += ' ' + goal(scope);
    return out.substr(1);
  }
  std::string precondition(Scope& scope) {
    if (chance(0.15)) return "()";
    if (chance(0.15)) return atom(scope);
    if (chance(0.15)) return "(and " + goals(scope, 2) + ")";
    if (chance(0.15)) return "(:first " + goals(scope, 2) + ")";
    if (chance(0.1)) {
      const std::string key = scope.next();
      scope.numbers.push_back(key);
      const std::string order = chance(0.5) ? " #'> " : " ";
      return "(:sort-by " + key + order + form({form({"n", key}), goals(scope, 2)}) + ")";
    }
    return "(" + goals(scope, 3) + ")";
  }

  static Words parameters(const std::string& stem, std::uint64_t count) {
    Words out;
    for (std::uint64_t at = 0; at < count; ++at) out.push_back(stem + std::to_string(at));
    return out;
  }
  static std::string head(const std::string& name, const Words& arguments) {
    std::string out = "(" + name;
    for (const std::string& argument : arguments) out += ' ' + argument;
    return out + ")";
  }
  static std::uint64_t arity(std::uint64_t index) { return index % 3; }

  std::string changes(const Scope& scope, bool adds) {
    std::string out = "(";
    for (std::uint64_t many = below(3); many > 0; --many) out += known_atom(scope);
    if (chance(0.15)) {
      out += "(forall (?z) (" + one_of(kUnary) + " ?z) (" +
             form({one_of(kBinary), "?z", known(scope)}) + "))";
    }
    if (chance(0.12)) {
      const std::string kept = form({one_of(kUnary), known(scope)});
      if (adds) out += kept;
      out += form({":protection", kept});
    }
    return out + ")";
  }
  std::string cost(const Scope& scope) {
    if (chance(0.4)) return "";
    if (!scope.numbers.empty()) return form({"+", scope.numbers[0], "1"});
    return std::to_string(below(4));
  }
  std::string an_operator(std::uint64_t index) {
    Scope scope;
    scope.things = parameters("?x", arity(index));
    const std::string name = (index == 3 ? "!!o" : "!o") + std::to_string(index);
    std::string out = "  (:operator " + head(name, scope.things) + ' ';
    out += (chance(0.6) ? "()" : "(" + goals(scope, 2) + ")") + ' ';
    out += changes(scope, false) + ' ';
    out += changes(scope, true) + ' ' + cost(scope);
    return out + ")\n";
  }

  std::string one_task(const Scope& scope, std::uint64_t after) {
    const bool primitive = after >= kTasks || chance(after == 0 ? 0.1 : 0.5);
    const std::uint64_t index = primitive ? below(kOperators) : after + below(kTasks - after);
    Words arguments;
    for (std::uint64_t at = 0; at < arity(index); ++at) {
      arguments.push_back(chance(0.04) ? "?free" : known(scope));
    }
    const std::string stem = primitive ? (index == 3 ? "!!o" : "!o") : "t";
    const std::string plain = head(stem + std::to_string(index), arguments);
    if (!chance(0.15)) return plain;
    return (chance(0.5) ? "(:task :immediate " : "(:immediate ") + plain.substr(1);
  }
  std::string network(const Scope& scope, std::uint64_t after, int depth) {
    if (chance(0.12)) return "()";
    std::string out;
    for (std::uint64_t many = 1 + below(3); many > 0; --many) {
      const bool inner = depth < 2 && chance(0.2);
      out += ' ' + (inner ? network(scope, after, depth + 1) : one_task(scope, after));
    }
    const char* kind = chance(0.35) ? ":unordered" : ":ordered";
    return chance(0.4) && depth == 0 && out.starts_with(" (") && !out.starts_with(" ()")
               ? "(" + out.substr(1) + ")"
               : "(" + (kind + out) + ")";
  }
  std::string method(std::uint64_t task) {
    const Words arguments = parameters("?y", arity(task));
    std::string out = "  (:method " + head("t" + std::to_string(task), arguments);
    for (std::uint64_t branch = 0, many = 1 + below(2); branch < many; ++branch) {
      Scope scope;
      scope.things = arguments;
      scope.fresh = static_cast<int>(10 * branch);
      const std::uint64_t after = chance(0.08) ? task : task + 1;
      out += "\n    m" + std::to_string(labels_++) + ' ' + precondition(scope);
      out += ' ' + network(scope, after, 0);
    }
    return out + ")\n";
  }

  std::string axioms() {
    std::string out = "  (:- (path ?x ?y) ((k ?x ?y)) ((k ?x ?z) (path ?z ?y)))\n";
    for (std::uint64_t many = 1 + below(2); many > 0; --many) {
      out += "  (:- (u ?x)";
      for (std::uint64_t tail = 1 + below(2); tail > 0; --tail) {
        Scope scope;
        scope.things = {"?x"};
        std::string more = chance(0.5) ? ' ' + known_atom(scope) : "";
        if (chance(0.2)) more += " (not (q ?x))";
        const std::string binds = chance(0.5) ? "(p ?x)" : "(r ?x ?z)";
        out += chance(0.15) ? " (:first " + binds + more + ")" : " (" + binds + more + ")";
      }
      out += ")\n";
    }
    return out;
  }

  std::string problem() {
    std::string facts;
    const Scope none;
    for (std::uint64_t many = 5 + below(8); many > 0; --many) facts += known_atom(none);
    for (std::uint64_t many = 1 + below(3); many > 0; --many) {
      facts += form({"n", std::to_string(below(4))});
    }
    facts += chance(0.7) ? "(k a b)(k b c)" : "(k a c)(k a b)(k b c)";
    if (chance(0.3)) facts += "(u b)";
    std::string tasks;
    do {
      tasks = network(none, 0, 0);
    } while (tasks == "()");
    return "(defproblem p d (" + facts + ") " + tasks + ")\n";
  }

  Random random_;
  int labels_ = 0;
};

}  // namespace

std::string random_domain(std::uint64_t seed) { return Writer(seed).file(); }

}  // namespace skein::htn::oracle
