// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/given_plan.hpp"

#include <charconv>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "skein/htn/syntax.hpp"

namespace skein::htn {

namespace {

using nlohmann::json;

constexpr int kDeepest = 2000;
constexpr std::size_t kMostErrors = 100;
constexpr std::uint64_t kLargestInteger = std::numeric_limits<std::int64_t>::max();

/// Makes terms of what a plan file holds; variables that were left unbound become kLocal terms.
class TermMaker {
 public:
  explicit TermMaker(TermStore& store) : store_(store) {}

  std::optional<Term> from_text(const Document& document, NodeIndex index, int depth = 0) {
    const Node& node = document[index];
    if (!node.list) {
      const std::string_view text(document.text);
      return atom(node.atom, text.substr(node.begin, node.end - node.begin));
    }
    if (depth > kDeepest) return {};
    std::vector<Term> items;
    for (const NodeIndex child : children(document, index)) {
      const std::optional<Term> item = from_text(document, child, depth + 1);
      if (!item) return {};
      items.push_back(*item);
    }
    if (!node.dotted || items.empty()) return store_.list(items);
    const Term tail = items.back();
    items.pop_back();
    return store_.list(items, tail);
  }

  std::optional<Term> from_json(const json& value, int depth = 0) {
    if (value.is_null()) return kNil;
    if (value.is_boolean()) return TermStore::boolean(value.get<bool>());
    const bool beyond = value.is_number_unsigned() && value.get<std::uint64_t>() > kLargestInteger;
    if (value.is_number_integer() && !beyond) return store_.integer(value.get<std::int64_t>());
    if (value.is_number()) return store_.number(real(value.get<double>()));
    if (value.is_string()) return from_string(value.get_ref<const std::string&>());
    if (!value.is_array() || depth > kDeepest) return {};
    std::vector<Term> items;
    for (const json& item : value) {
      const std::optional<Term> made = from_json(item, depth + 1);
      if (!made) return {};
      items.push_back(*made);
    }
    return list_of(std::move(items));
  }

 private:
  // (a . b) is written ["a", ".", "b"].
  Term list_of(std::vector<Term> items) {
    Term tail = kNil;
    if (items.size() > 2 && items[items.size() - 2] == store_.symbol(".")) {
      tail = items.back();
      items.resize(items.size() - 2);
    }
    return store_.list(items, tail);
  }
  Term from_string(const std::string& text) {
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
      return store_.string(text.substr(1, text.size() - 2));
    }
    const auto number = parse_number(text);
    if (number && number->has_value()) return atom(store_.number(**number), text);
    return atom(store_.symbol(text), text);
  }
  // Floats are taken as double whatever their text says.
  Term atom(Term term, std::string_view text) {
    if (term.is(TermKind::kSymbol) && store_.name(term).starts_with('?')) {
      const auto next = static_cast<std::uint32_t>(locals_.size());
      return {TermKind::kLocal,
              locals_.try_emplace(std::string(store_.name(term)), next).first->second};
    }
    if (!term.is(TermKind::kNumber)) return term;
    if (store_.value(term).kind != NumberKind::kSingle) return term;
    double value = to_double(store_.value(term));
    std::from_chars(text.data(), text.data() + text.size(), value);
    return store_.number(real(value));
  }

  TermStore& store_;
  std::map<std::string, std::uint32_t> locals_;
};

Diagnostic problem(const std::string& file, int line, std::string message, std::string expected) {
  Diagnostic out;
  out.file = file;
  out.line = line;
  out.message = std::move(message);
  out.expected = std::move(expected);
  return out;
}

std::optional<Number> number_in(TermStore& store, const json& value) {
  const std::optional<Term> term = TermMaker(store).from_json(value);
  if (!term || !term->is(TermKind::kNumber)) return {};
  return store.value(*term);
}

const json& member(const json& object, const char* name) {
  static const json absent;
  const auto found = object.find(name);
  return found == object.end() ? absent : *found;
}

std::string string_in(const json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::uint32_t index_in(const json& value, std::uint32_t absent) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= absent) return absent;
  return value.get<std::uint32_t>();
}

/// Reads one line of `skein plan --json`.
class JsonReader {
 public:
  JsonReader(const std::string& file, int line, TermStore& store, Diagnostics& errors)
      : file_(file), line_(line), store_(store), errors_(errors) {}

  void read(const std::string& text, std::vector<GivenPlan>& out) {
    bool deep = false;
    const auto shallow = [&deep](int depth, json::parse_event_t, json&) {
      deep = deep || depth > kDeepest;
      return depth <= kDeepest;
    };
    const json object = json::parse(text, shallow, false);
    if (deep) return wrong("nested more than " + std::to_string(kDeepest) + " deep", "");
    if (!object.is_object()) return wrong("not a JSON object", "one object a line");
    const json& plans = member(object, "plans");
    if (!plans.is_array()) return wrong("no plans", "\"plans\": […]");
    for (const json& plan : plans) {
      GivenPlan made;
      made.problem = string_in(member(object, "problem"));
      made.without_internal = says_internal_left_out(object) || says_internal_left_out(plan);
      if (!plan.is_object() || !read_steps(plan, made) || !read_tree(plan, made)) continue;
      made.cost = number_in(store_, member(plan, "cost"));
      out.push_back(std::move(made));
    }
  }

 private:
  void wrong(std::string message, std::string expected) {
    errors_.add(problem(file_, line_, std::move(message), std::move(expected)));
  }
  static bool says_internal_left_out(const json& object) {
    return object.is_object() && member(object, "internal") == json(false);
  }
  bool read_steps(const json& plan, GivenPlan& made) {
    TermMaker maker(store_);
    const json& costs = member(plan, "costs");
    for (const json& step : member(plan, "steps")) {
      const std::optional<Term> action = maker.from_json(step);
      if (!action || !action->is(TermKind::kPair)) {
        wrong("step " + std::to_string(made.steps.size() + 1) + " is no list",
              "[\"!name\", argument…]");
        return false;
      }
      GivenStep given{*action, {}, line_};
      if (costs.is_array() && made.steps.size() < costs.size()) {
        given.cost = number_in(store_, costs[made.steps.size()]);
      }
      made.steps.push_back(given);
    }
    return true;
  }
  bool read_tree(const json& plan, GivenPlan& made) {
    static const std::map<std::string, TreeNodeKind> kinds = {
        {"task", TreeNodeKind::kTask},
        {"ordered", TreeNodeKind::kOrdered},
        {"unordered", TreeNodeKind::kUnordered},
        {"step", TreeNodeKind::kStep}};
    TermMaker maker(store_);
    for (const json& node : member(plan, "tree")) {
      GivenNode given;
      const json& kind = member(node, "kind");
      const auto found = kinds.find(string_in(kind));
      const std::optional<Term> task = maker.from_json(member(node, "task"));
      if (found == kinds.end() || !task) {
        wrong("tree node " + std::to_string(made.tree.size()) + " is not understood",
              "\"kind\": task, ordered, unordered or step");
        return false;
      }
      given.kind = found->second;
      given.task = *task;
      given.method = string_in(member(node, "method"));
      given.step = index_in(member(node, "step"), kNoStep);
      given.immediate = member(node, "immediate") == json(true);
      given.support = support_in(member(node, "support"), maker);
      for (const json& child : member(node, "children")) {
        given.children.push_back(index_in(child, kNoParent));
      }
      made.tree.push_back(std::move(given));
    }
    return true;
  }

  static std::vector<CausalLink> support_in(const json& links, TermMaker& maker) {
    std::vector<CausalLink> out;
    for (const json& link : links) {
      if (!link.is_object()) continue;
      const std::optional<Term> fact = maker.from_json(member(link, "fact"));
      const json& step = member(link, "step");
      const std::string word = string_in(step);
      const StepIndex from = word == "initial"   ? kInitialState
                             : word == "outside" ? kOutside
                                                 : index_in(step, kNoStep);
      if (fact && fact->is(TermKind::kPair) && from != kNoStep) out.push_back({*fact, from});
    }
    return out;
  }

  const std::string& file_;
  int line_;
  TermStore& store_;
  Diagnostics& errors_;
};

GivenPlan read_text(const std::string& file, const std::string& text, TermStore& store,
                    Diagnostics& errors) {
  GivenPlan out;
  TermMaker maker(store);
  const Document document = read_document(file, text, store, errors);
  for (const NodeIndex index : document.top) {
    if (errors.size() > kMostErrors) break;
    const int line = place_of(document, document[index].begin).line;
    const std::optional<Term> term = maker.from_text(document, index);
    if (term && term->is(TermKind::kPair)) {
      out.steps.push_back({*term, {}, line});
    } else if (term && term->is(TermKind::kNumber) && !out.steps.empty() &&
               !out.steps.back().cost) {
      out.steps.back().cost = store.value(*term);
    } else {
      errors.add(problem(file, line, "not a step", "(!name argument…) cost"));
    }
  }
  return out;
}

}  // namespace

std::vector<GivenPlan> read_plans(const std::string& file, const std::string& text,
                                  TermStore& store, Diagnostics& errors) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || text[start] != '{') {
    return {read_text(file, text, store, errors)};
  }
  std::vector<GivenPlan> out;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    JsonReader(file, number, store, errors).read(line, out);
  }
  return out;
}

}  // namespace skein::htn
