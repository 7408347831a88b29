// SPDX-License-Identifier: Apache-2.0
// The order of answers, against SHOP3's rules played by recursion on texts: nothing is indexed,
// reordered or remembered.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "testing/planner_questions.hpp"

namespace skein::htn {
namespace {

using test::Questions;
using Names = std::vector<std::string>;  ///< constants, and variables that begin with '?'

/// A goal of the logic: an atom, or a connective of queries.
struct Asked {
  enum class Kind : std::uint8_t { kAtom, kAnd, kOr, kNot };
  Kind kind = Kind::kAtom;
  std::string predicate;
  Names arguments;
  std::vector<std::vector<Asked>> parts;  ///< a connective's; of `and` and `not` one

  std::string text() const {
    if (kind == Kind::kAtom) {
      std::string atom = "(" + predicate;
      for (const std::string& argument : arguments) atom += " " + argument;
      return atom + ")";
    }
    std::string out = kind == Kind::kAnd ? "(and" : kind == Kind::kOr ? "(or" : "(not";
    for (const std::vector<Asked>& part : parts) {
      std::string goals;
      for (const Asked& goal : part) goals += " " + goal.text();
      out += kind == Kind::kOr ? " (" + goals + ")" : goals;
    }
    return out + ")";
  }
};
using Query = std::vector<Asked>;

Names variables_of(const Query& query) {
  Names out;
  for (const Asked& goal : query) {
    Names inside = goal.arguments;
    for (const Query& part : goal.parts) {
      const Names more = variables_of(part);
      inside.insert(inside.end(), more.begin(), more.end());
    }
    for (const std::string& name : inside)
      if (name[0] == '?' && std::find(out.begin(), out.end(), name) == out.end())
        out.push_back(name);
  }
  return out;
}

/// (:- (predicate ?u …) tail …), each tail one goal.
struct Axiom {
  std::string predicate;
  Names parameters;
  std::vector<Asked> tails;
};

struct Theory {
  std::vector<Asked> facts;  ///< the oldest first
  std::vector<Axiom> axioms;

  std::string facts_text() const {
    std::string text;
    for (const Asked& fact : facts) text += fact.text();
    return text;
  }
  std::string axioms_text() const {
    std::string text;
    for (const Axiom& axiom : axioms) {
      text += "(:- " + Asked{{}, axiom.predicate, axiom.parameters, {}}.text();
      for (const Asked& tail : axiom.tails) text += " (" + tail.text() + ")";
      text += ")\n";
    }
    return text;
  }
};

/// SHOP3's rules: of an atom the axioms come first, in their order, then the facts, the newest
/// first; what each of them gives is put before what was there. The answers of a connective's
/// query are found as a whole, each once, and gone through in their order in the same way. Of an
/// axiom the first tail is used that has an answer.
class NaiveProver {
 public:
  using Answer = std::map<std::string, std::string>;

  explicit NaiveProver(const Theory& theory) : theory_(theory) {}

  std::vector<Answer> query(const Query& goals, const Answer& known) {
    std::vector<Answer> out;
    std::vector<Answer> seen;
    const Names names = variables_of(goals);
    for (Answer& answer : solve(goals, known)) {
      Answer seen_by_names;
      for (const std::string& name : names)
        if (answer.contains(name)) seen_by_names[name] = answer[name];
      if (std::find(seen.begin(), seen.end(), seen_by_names) != seen.end()) continue;
      seen.push_back(std::move(seen_by_names));
      out.push_back(std::move(answer));
    }
    return out;
  }

 private:
  static void put_before(std::vector<Answer>& all, std::vector<Answer> made) {
    made.insert(made.end(), all.begin(), all.end());
    all = std::move(made);
  }

  std::vector<Answer> solve(const Query& goals, const Answer& known) {
    if (goals.empty()) return {known};
    const Asked& goal = goals.front();
    const Query rest(goals.begin() + 1, goals.end());
    std::vector<Answer> out;
    switch (goal.kind) {
      case Asked::Kind::kAtom:
        for (const Axiom& axiom : theory_.axioms)
          if (axiom.predicate == goal.predicate)
            put_before(out, by_axiom(axiom, goal, rest, known));
        for (auto fact = theory_.facts.rbegin(); fact != theory_.facts.rend(); ++fact)
          if (const auto bound = matched(goal, *fact, known)) put_before(out, solve(rest, *bound));
        break;
      case Asked::Kind::kAnd:
      case Asked::Kind::kOr:
        for (const Query& part : goal.parts)
          for (const Answer& answer : query(part, known)) put_before(out, solve(rest, answer));
        break;
      case Asked::Kind::kNot:
        if (query(goal.parts.front(), known).empty()) out = solve(rest, known);
        break;
    }
    return out;
  }

  std::vector<Answer> by_axiom(const Axiom& axiom, const Asked& goal, const Query& rest,
                               const Answer& known) {
    const std::string fresh = "#" + std::to_string(++activations_);
    for (const Asked& tail : axiom.tails) {
      const Asked called = renamed(tail, axiom, goal, known, fresh);
      if (query({called}, known).empty()) continue;
      Query all{called};
      all.insert(all.end(), rest.begin(), rest.end());
      return solve(all, known);
    }
    return {};
  }

  static Asked renamed(Asked tail, const Axiom& axiom, const Asked& goal, const Answer& known,
                       const std::string& fresh) {
    for (std::string& name : tail.arguments) {
      if (name[0] != '?') continue;
      const auto at = std::find(axiom.parameters.begin(), axiom.parameters.end(), name);
      name = at == axiom.parameters.end()
                 ? name + fresh
                 : value(goal.arguments[static_cast<std::size_t>(at - axiom.parameters.begin())],
                         known);
    }
    for (Query& part : tail.parts)
      for (Asked& inner : part) inner = renamed(inner, axiom, goal, known, fresh);
    return tail;
  }

  static std::string value(const std::string& name, const Answer& known) {
    const auto at = known.find(name);
    return at == known.end() ? name : at->second;
  }

  static std::optional<Answer> matched(const Asked& goal, const Asked& fact, const Answer& known) {
    if (goal.predicate != fact.predicate) return std::nullopt;
    Answer out = known;
    for (std::size_t at = 0; at < fact.arguments.size(); ++at) {
      const std::string wanted = value(goal.arguments[at], out);
      if (wanted[0] == '?') {
        out[wanted] = fact.arguments[at];
      } else if (wanted != fact.arguments[at]) {
        return std::nullopt;
      }
    }
    return out;
  }

  const Theory& theory_;
  int activations_ = 0;
};

// ---- what is drawn ---------------------------------------------------------------------------

const Names kFew{"a", "b", "c"};
const Names kMany{"a", "b", "c", "d", "e", "f", "g", "h"};

Asked atom(const Names& predicates, const Names& names) {
  const std::string predicate = *rc::gen::elementOf(predicates);
  Asked made{{}, predicate, {}, {}};
  for (int left = predicate == "q" || predicate == "s" ? 2 : 1; left > 0; --left)
    made.arguments.push_back(*rc::gen::elementOf(names));
  return made;
}

Asked drawn_goal(int depth, const Names& predicates, const Names& names) {
  const int kind = depth == 0 ? 0 : *rc::gen::inRange(0, 6);
  if (kind < 3) return atom(predicates, names);
  Asked made;
  made.kind = kind == 3 ? Asked::Kind::kAnd : kind == 4 ? Asked::Kind::kOr : Asked::Kind::kNot;
  for (int part = made.kind == Asked::Kind::kOr ? *rc::gen::inRange(1, 4) : 1; part > 0; --part) {
    Query goals;
    const bool one = made.kind == Asked::Kind::kNot;
    for (int goal = one ? 1 : *rc::gen::inRange(1, 3); goal > 0; --goal)
      goals.push_back(drawn_goal(depth - 1, predicates, names));
    made.parts.push_back(std::move(goals));
  }
  return made;
}

Theory drawn_theory(const Names& constants, int most_pairs) {
  Theory theory;
  for (const std::string& one : constants)
    for (const char* const predicate : {"p", "r"})
      if (*rc::gen::arbitrary<bool>()) theory.facts.push_back({{}, predicate, {one}, {}});
  for (int left = *rc::gen::inRange(0, most_pairs); left > 0; --left) {
    const Asked fact = atom({"q", "s"}, constants);
    const auto same = [&](const Asked& other) { return other.text() == fact.text(); };
    if (std::none_of(theory.facts.begin(), theory.facts.end(), same)) theory.facts.push_back(fact);
  }
  for (int left = *rc::gen::inRange(0, 4); left > 0; --left) {
    const bool two = *rc::gen::arbitrary<bool>();
    Axiom axiom{two ? "s" : "r", two ? Names{"?u", "?v"} : Names{"?u"}, {}};
    for (int tail = *rc::gen::inRange(1, 3); tail > 0; --tail)
      axiom.tails.push_back(drawn_goal(1, {"p", "q"}, {"?u", "?u", "?v", "?w", "a"}));
    theory.axioms.push_back(std::move(axiom));
  }
  return theory;
}

std::string shown(const std::vector<NaiveProver::Answer>& answers, const Names& names) {
  std::string text;
  for (const NaiveProver::Answer& answer : answers) {
    text += text.empty() ? "(" : " (";
    for (const std::string& name : names) {
      const auto at = answer.find(name);
      text += (name == names.front() ? "" : " ") + (at == answer.end() ? "_" : at->second);
    }
    text += ")";
  }
  return answers.empty() ? "none" : text;
}

/// The planner's answers are those of the rules, in their order; unbound variables are alike.
void expect_the_order_of_shop3(const Theory& theory, const Query& query) {
  const Names names{"?x", "?y", "?z"};
  std::string condition;
  for (const Asked& goal : query) condition += goal.text();
  RC_LOG() << theory.facts_text() << "\n" << theory.axioms_text() << condition;
  const std::vector<NaiveProver::Answer> expected = NaiveProver(theory).query(query, {});
  Questions questions(theory.facts_text(), theory.axioms_text());

  const std::string found = questions.ask("(" + condition + ")", "?x ?y ?z");

  static const std::regex kUnbound(R"(\?[_\w]*)");
  RC_ASSERT(std::regex_replace(found, kUnbound, "_") == shown(expected, names));
}

RC_GTEST_PROP(ProverOrderProperty, AnswersComeInTheOrderOfShop3, ()) {
  const Theory theory = drawn_theory(kFew, 6);
  Query query;
  for (int left = *rc::gen::inRange(1, 4); left > 0; --left)
    query.push_back(drawn_goal(2, {"p", "q", "r", "s"}, {"?x", "?y", "?z", "?x", "b"}));

  expect_the_order_of_shop3(theory, query);
}

// Where many facts match, they are found by an index, and goals are taken out of their turn.
RC_GTEST_PROP(ProverOrderProperty, ManyFactsComeInTheOrderOfShop3, ()) {
  const Theory theory = drawn_theory(kMany, 50);
  Query query;
  for (int left = *rc::gen::inRange(2, 5); left > 0; --left)
    query.push_back(atom({"p", "q", "q", "s"}, {"?x", "?y", "?z", "?x", "?y", "b"}));
  // What is bound nowhere ranges over too much.
  RC_PRE(variables_of(query).size() == 3U);

  expect_the_order_of_shop3(theory, query);
}

}  // namespace
}  // namespace skein::htn
