// SPDX-License-Identifier: Apache-2.0
#include "compile/network_compiler.hpp"

#include <algorithm>
#include <array>

#include "language/read_context.hpp"

namespace skein::htn {

namespace {

constexpr std::string_view kNothing = "!!inop";
constexpr std::size_t kDeepestNetwork = 500;

std::string_view head_name(const TermStore& store, Expression list) {
  const Expression head = first(list);
  if (!head || (*head).list) return {};
  const Term atom = (*head).atom;
  return atom.is(TermKind::kSymbol) ? store.name(atom) : std::string_view{};
}

bool mentions_call(const TermStore& store, Expression expression) {
  std::vector<Expression> open;
  for (Expression at = expression;; open.pop_back()) {
    if (head_name(store, at) == "call") return true;
    for (Expression part = first(at); part; part = next(part)) {
      if ((*part).list) open.push_back(part);
    }
    if (open.empty()) return false;
    at = open.back();
  }
}

/// Reads the text of a network into body nodes.
class NetworkCompiler {
 public:
  NetworkCompiler(ConditionCompiler& compiler, CompiledDomain& domain, ClauseScope& scope)
      : compiler_(compiler), domain_(domain), scope_(scope) {}

  std::vector<BodyNode> body;

  // Parents come before their children and children in order, without recursion: a network still
  // to be read is put where its parent says.
  void read(Expression tasks) {
    std::vector<std::pair<Expression, std::uint32_t>> open{{tasks, kAbsent}};
    while (!open.empty()) {
      const auto [at, parent] = open.back();
      open.pop_back();
      const std::string_view name = head_name(domain_.store, at);
      if (name == ":ordered" || name == ":unordered" || (head_is_list(at))) {
        const std::uint32_t self = add_group(name == ":unordered", parent);
        std::vector<Expression> inner = parts(at);
        if (!name.empty()) inner.erase(inner.begin());
        if (inner.empty()) add_nothing(self);
        for (auto part = inner.rbegin(); part != inner.rend(); ++part)
          open.push_back({*part, self});
      } else if (name.empty() && !first(at)) {
        add_nothing(parent);
      } else {
        add_task(at, name, parent);
      }
    }
  }

 private:
  bool head_is_list(Expression at) const {
    const Expression head = first(at);
    return head && (*head).list;
  }
  std::uint32_t add_group(bool unordered, std::uint32_t parent) {
    BodyNode node;
    node.kind = unordered ? NetworkKind::kUnordered : NetworkKind::kOrdered;
    node.parent = parent;
    body.push_back(node);
    return static_cast<std::uint32_t>(body.size() - 1);
  }
  void add_nothing(std::uint32_t parent) {
    BodyNode node;
    node.parent = parent;
    const std::array<Term, 1> task{domain_.store.symbol(kNothing)};
    node.task = domain_.store.list(task);
    body.push_back(node);
  }
  // (name argument…), (:task [:immediate] name …), (:immediate name …)
  void add_task(Expression at, std::string_view name, std::uint32_t parent) {
    BodyNode node;
    node.parent = parent;
    std::size_t skip = 0;
    const std::vector<Expression> all = parts(at);
    if (name == ":task") ++skip;
    const bool marked = all.size() > skip && !(*all[skip]).list &&
                        (*all[skip]).atom == domain_.store.symbol(":immediate");
    if (marked) ++skip;
    node.immediate = marked;
    if (mentions_call(domain_.store, at)) {
      node.code = domain_.lisp.compile_template(at, scope_.slot_of(), compiler_errors());
    }
    const Term whole = compiler_.pattern(at, scope_);
    node.task = whole;
    for (; skip > 0; --skip) node.task = domain_.store.cdr(node.task);
    node.skipped = static_cast<std::uint8_t>(name == ":task") + static_cast<std::uint8_t>(marked);
    body.push_back(node);
  }
  Diagnostics& compiler_errors() { return compiler_.errors(); }

  ConditionCompiler& compiler_;
  CompiledDomain& domain_;
  ClauseScope& scope_;
};

std::size_t deepest(const std::vector<BodyNode>& body) {
  std::vector<std::size_t> depth(body.size(), 1);
  std::size_t most = 0;
  for (std::size_t node = 0; node < body.size(); ++node) {
    if (body[node].parent != kAbsent) depth[node] = depth[body[node].parent] + 1;
    most = std::max(most, depth[node]);
  }
  return most;
}

/// The leaves of a network that come first. A node is on the way to them if everything above it
/// comes first too.
class FirstLeaves {
 public:
  explicit FirstLeaves(const std::vector<BodyNode>& body) : body_(body), begun_(body.size()) {
    for (std::uint32_t node = 0; node < body.size(); ++node) {
      if (comes_first(node) && body[node].kind == NetworkKind::kTask) leaves.push_back(node);
    }
  }

  std::vector<std::uint32_t> leaves;

 private:
  struct Begun {
    bool first = false;     // of all that come first
    bool children = false;  // one of them was met
  };

  // Parents come before their children.
  bool comes_first(std::uint32_t node) {
    const std::uint32_t parent = body_[node].parent;
    if (parent == kAbsent) return begun_[node].first = node == 0;
    const bool later = body_[parent].kind == NetworkKind::kOrdered && begun_[parent].children;
    begun_[parent].children = true;
    return begun_[node].first = begun_[parent].first && !later;
  }

  const std::vector<BodyNode>& body_;
  std::vector<Begun> begun_;
};

}  // namespace

std::vector<Forcing> forcings(const std::vector<BodyNode>& body) {
  Forcing given;
  for (std::uint32_t node = 0; node < body.size(); ++node) {
    if (body[node].immediate) given.push_back(node);
  }
  const std::vector<std::uint32_t> firsts = FirstLeaves(body).leaves;
  const bool immediate_already = std::any_of(
      firsts.begin(), firsts.end(), [&](std::uint32_t node) { return body[node].immediate; });
  if (immediate_already) return {given};
  std::vector<Forcing> out;
  out.reserve(firsts.size());
  for (const std::uint32_t node : firsts) {
    out.push_back(given);
    out.back().push_back(node);
  }
  return out;
}

void compile_network(Expression tasks, ConditionCompiler& compiler, CompiledDomain& domain,
                     ClauseScope& scope, Branch& branch) {
  // SHOP1's '(…) and `(…) mean the list itself.
  const std::string_view name = head_name(domain.store, tasks);
  if (name == "quote" || name == "backquote") tasks = parts(tasks).back();
  NetworkCompiler network(compiler, domain, scope);
  network.read(tasks);  // absent tasks are none
  branch.body = std::move(network.body);
  if (branch.body.size() > kDeepestNetwork && deepest(branch.body) > kDeepestNetwork) {
    compiler.error(tasks, "the task network is nested too deeply", "at most 500 levels");
    return;
  }
  for (std::uint32_t node = 0; node < branch.body.size(); ++node) {
    if (branch.body[node].kind == NetworkKind::kTask) branch.leaves.push_back(node);
  }
  branch.forcings = forcings(branch.body);
}

}  // namespace skein::htn
