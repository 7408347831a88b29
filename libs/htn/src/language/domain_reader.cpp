// SPDX-License-Identifier: Apache-2.0
#include "language/domain_reader.hpp"

#include <algorithm>

#include "skein/foundation/nearest.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kMostIncludes = 1000;

const std::vector<std::string>& item_names() {
  static const std::vector<std::string> names = {
      ":operator",  ":op",        ":method", ":pddl-method",  ":-",
      ":include",   ":static",    ":types",  ":requirements", ":predicates",
      ":functions", ":constants", ":action", ":derived"};
  return names;
}

// "dir/other.lisp" when "dir/this.lisp" includes "other.lisp".
std::string beside(const std::string& file, const std::string& from) {
  const std::size_t slash = from.rfind('/');
  if (file.starts_with('/') || slash == std::string::npos) return file;
  return from.substr(0, slash + 1) + file;
}

Expression domain_name(const ReadContext& context, Expression form) {
  const Expression name = next(first(form));
  return name && context.is_list(name) ? first(name) : name;
}

// The name in (define (domain name) …).
Expression pddl_domain_name(const ReadContext& context, Expression form) {
  const Expression head = next(first(form));
  const bool domain = head && context.is_list(head) && first(head) &&
                      context.is_name(first(head)) && context.name(first(head)) == "domain";
  return domain ? next(first(head)) : Expression{};
}

// A file name as written, or inside a form that would make a path of it when Lisp read it. The
// first argument of (system-relative-pathname system path) is no part of the path.
Expression file_name(const ReadContext& context, Expression expression) {
  std::vector<Expression> open{expression};
  while (!open.empty()) {
    const Expression at = open.back();
    open.pop_back();
    if (!(*at).list && (*at).atom.is(TermKind::kString)) return at;
    std::vector<Expression> inner = parts(at);
    const Term head = context.head(at);
    const bool system = head != kNil && context.name(head) == "system-relative-pathname";
    if (system && inner.size() > 2) inner.erase(inner.begin(), inner.begin() + 2);
    open.insert(open.end(), inner.rbegin(), inner.rend());
  }
  return {};
}

// The path with ever fewer folders before it: where the files of a Lisp system lie elsewhere, what
// they include still lies beside them.
std::vector<std::string> places_of(const std::string& path) {
  std::vector<std::string> out{path};
  for (std::size_t slash = path.find('/'); slash != std::string::npos && slash > 0;
       slash = path.find('/', slash + 1)) {
    if (slash + 1 < path.size()) out.push_back(path.substr(slash + 1));
  }
  return out;
}

}  // namespace

void DomainReader::read() {
  const std::vector<Expression> all = parts(form_);
  if (all.size() < 2 || !read_name(all[1])) {
    if (all.size() < 2)
      context_.error(form_, "a domain without a name", "(defdomain name (items…))");
    return;
  }
  if (all.size() < 3) {
    context_.error(form_, "a domain without items", "(defdomain name (items…))");
  } else {
    read_items(unquoted(all[2], context_.words));
  }
  if (all.size() > 3) {
    context_.error(all[3], "something behind the items of the domain",
                   "')' here; is there one too many before?");
  }
  check_types();
  context_.definitions.domains.push_back(std::move(domain_));
}

bool DomainReader::read_name(Expression name) {
  const Expression given = unquoted(name, context_.words);
  const Expression symbol = context_.is_list(given) ? first(given) : given;
  if (!symbol || !context_.is_name(symbol)) {
    context_.error(name, text_of(name) + " is no name for a domain", "a name or (name options…)");
    return false;
  }
  domain_.name = context_.name(symbol);
  if (!context_.is_list(given)) return true;
  for (Expression at = next(symbol); at && next(at); at = next(next(at))) {
    const Expression value = next(at);
    if (!context_.is_symbol(at) || (*at).atom != context_.words.type) continue;
    const std::string type = context_.is_name(value) ? context_.name(value) : "";
    domain_.pddl = type.find("pddl") != std::string::npos || type.find("adl") != std::string::npos;
  }
  return true;
}

void DomainReader::read_items(Expression items) {
  if (!context_.is_list(items) && !context_.is_nil(items)) {
    return context_.error(items, text_of(items) + " where the items go", "a list of items");
  }
  for (Expression at = first(items); at; at = next(at)) {
    if (context_.is_symbol(at)) {
      context_.warn(at, "a stray '" + text_of(at) + "' is left out",
                    "(:operator …), (:method …) …");
    } else {
      read_item(at);
    }
  }
}

void DomainReader::read_item(Expression item) {
  const Term word = context_.head(item);
  const Words& words = context_.words;
  if (word == words.op_long) return read_operator(item);
  if (word == words.op_short) return read_op(item);
  if (word == words.action) return read_action(item);
  if (word == words.method) return read_method(item, false);
  if (word == words.pddl_method) return read_method(item, true);
  if (word == words.axiom) return read_axiom(item);
  if (word == words.derived) return read_derived(item);
  if (read_declaration(item, word)) return;
  std::string message = text_of(item) + " is no item of a domain";
  if (word == kNil) return context_.error(item, std::move(message), "(:operator …), (:method …) …");
  message = "unknown item " + context_.name(word);
  context_.error(item, std::move(message), ":operator, :method, :- or another item",
                 nearest_name(context_.name(word), item_names()));
}

bool DomainReader::read_declaration(Expression item, Term word) {
  const Words& words = context_.words;
  if (word == words.requirements) return true;
  if (word == words.types) {
    read_types(item);
  } else if (word == words.predicates || word == words.functions) {
    read_predicates(item);
  } else if (word == words.constants) {
    read_constants(item);
  } else if (word == words.statics) {
    read_static(item);
  } else if (word == words.include) {
    read_include(item);
  } else {
    return false;
  }
  return true;
}

void DomainReader::read_static(Expression item) {
  for (Expression at = next(first(item)); at; at = next(at)) {
    if (!context_.is_name(at)) {
      context_.error(at, text_of(at) + " in :static", "the name of a predicate");
      continue;
    }
    domain_.static_predicates.push_back((*at).atom);
  }
}

// Inclusion

void DomainReader::read_include(Expression item) {
  const Expression name = next(first(item));
  const Expression file = name ? next(name) : Expression{};
  const bool named = name && context_.is_name(name);
  const Expression path_text = file ? file_name(context_, file) : Expression{};
  const bool filed = !file || path_text;
  if (!named || !filed || (file && next(file))) {
    return context_.error(item, "malformed inclusion", "(:include name [\"file\"])");
  }
  const std::string wanted = context_.name(name);
  std::string given = file ? context_.store.text((*path_text).atom) : wanted + ".lisp";
  if (++includes_ > kMostIncludes) {
    if (includes_ == kMostIncludes + 1) context_.error(item, "more than 1000 inclusions");
    return;
  }
  if (including_.empty()) including_.push_back(item.document->file);
  const Result<std::string, Failure> text = included_text(given, file && context_.is_list(file));
  const std::string path = beside(given, including_.back());
  if (std::find(including_.begin(), including_.end(), path) != including_.end()) {
    return context_.error(item, "'" + given + "' includes itself");
  }
  if (!text) return context_.error(item, "cannot include '" + given + "': " + text.error().why);
  including_.push_back(path);
  context_.definitions.documents.push_back(
      std::make_unique<Document>(read_document(path, *text, context_.store, context_.errors)));
  read_included(item, wanted, given);
  including_.pop_back();
}

// A name that Lisp computes is looked for beside the file too; `name` becomes that which was found.
Result<std::string, Failure> DomainReader::included_text(std::string& name, bool computed) const {
  if (!context_.include) return failure("files are not included here");
  Result<std::string, Failure> first = context_.include(name, including_.back());
  if (first || !computed) return first;
  for (const std::string& other : places_of(name)) {
    Result<std::string, Failure> text = context_.include(other, including_.back());
    if (!text) continue;
    name = other;
    return text;
  }
  return first;
}

void DomainReader::read_included(Expression item, const std::string& name,
                                 const std::string& file) {
  const Document& document = *context_.definitions.documents.back();
  if (document.depth > kDeepestNesting) {
    return context_.error(
        item, "'" + file + "' is nested more than " + std::to_string(kDeepestNesting) + " deep");
  }
  std::vector<std::string> found;
  for (const NodeIndex top : document.top) {
    const Expression form{&document, top};
    const bool pddl = context_.head(form) == context_.words.define;
    if (!pddl && context_.head(form) != context_.words.defdomain) continue;
    const Expression symbol = pddl ? pddl_domain_name(context_, form) : domain_name(context_, form);
    if (!symbol || !context_.is_name(symbol)) continue;
    found.push_back(context_.name(symbol));
    if (found.back() != name) continue;
    const Expression items = next(next(first(form)));
    if (pddl) {
      for (Expression at = items; at; at = next(at)) read_item(at);
    } else if (items) {
      read_items(unquoted(items, context_.words));
    }
    return;
  }
  context_.error(item, "no domain '" + name + "' in '" + file + "'", "(defdomain " + name + " …)",
                 nearest_name(name, found));
}

}  // namespace skein::htn
