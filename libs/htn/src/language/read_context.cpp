// SPDX-License-Identifier: Apache-2.0
#include "language/read_context.hpp"

#include <algorithm>

#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {
constexpr std::size_t kLongestText = 40;
constexpr std::size_t kMostCollected = 10'000;  // of each kind: a text may have one at every byte
}  // namespace

Diagnostic diagnostic_at(Expression where, std::string message, std::string expected,
                         std::string nearest) {
  const Place place = place_of(*where.document, (*where).begin);
  return clipped({where.document->file, place.line, place.column, "", std::move(message),
                  std::move(expected), std::move(nearest)});
}

void ReadContext::error(Expression where, std::string message, std::string expected,
                        std::string nearest) const {
  if (errors.size() >= kMostCollected) return;
  errors.add(diagnostic_at(where, std::move(message), std::move(expected), std::move(nearest)));
}

void ReadContext::warn(Expression where, std::string message, std::string expected,
                       std::string nearest) const {
  if (warnings.size() >= kMostCollected) return;
  warnings.add(diagnostic_at(where, std::move(message), std::move(expected), std::move(nearest)));
}

void ReadContext::enclose(Expression list, Expression from) const {
  for (const std::unique_ptr<Document>& document : definitions.documents) {
    if (document.get() != list.document) continue;
    Node made;
    made.list = true;
    made.first_child = from.node;
    made.begin = (*from).begin;
    made.end = (*list).end - 1;
    // A list that the text does not close has no ')' behind the last.
    for (NodeIndex at = from.node; at != kNoNode; at = document->nodes[at].next)
      made.end = std::max(made.end, document->nodes[at].end);
    NodeIndex* link = &document->nodes[list.node].first_child;
    while (*link != from.node) link = &document->nodes[*link].next;
    *link = static_cast<NodeIndex>(document->nodes.size());
    document->nodes.push_back(made);
  }
}

bool ReadContext::is_nil(Expression expression) const {
  const Node& node = *expression;
  return node.list ? node.first_child == kNoNode : node.atom == kNil;
}

bool ReadContext::is_symbol(Expression expression) const {
  const Node& node = *expression;
  return !node.list && node.atom.is(TermKind::kSymbol);
}

bool ReadContext::is_variable(Expression expression) const {
  return is_symbol(expression) && variable((*expression).atom);
}

bool ReadContext::is_name(Expression expression) const {
  return is_symbol(expression) && (*expression).atom != kNil && !variable((*expression).atom);
}

Term ReadContext::head(Expression expression) const {
  const Expression begin = first(expression);
  return begin && is_symbol(begin) ? (*begin).atom : kNil;
}

std::string text_of(Expression expression) {
  const Node& node = *expression;
  std::string out;
  const std::string_view text(expression.document->text);
  for (const char byte : text.substr(node.begin, node.end - node.begin)) {
    const bool space = byte == ' ' || byte == '\t' || byte == '\n' || byte == '\r';
    if (space && !out.empty() && out.back() == ' ') continue;
    if (out.size() >= kLongestText && !continues_character(byte)) return out + "…";
    out += space ? ' ' : byte;
  }
  return out;
}

std::string counted(std::size_t number, const char* what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

Expression first(Expression list) {
  if (!list) return {};
  const Node& node = *list;
  return {list.document, node.list ? node.first_child : kNoNode};
}

Expression next(Expression expression) { return {expression.document, (*expression).next}; }

std::vector<Expression> parts(Expression list) {
  std::vector<Expression> out;
  out.reserve(count(list));
  for (Expression at = first(list); at; at = next(at)) out.push_back(at);
  return out;
}

std::size_t count(Expression list) {
  const Expression begin = first(list);
  if (!begin) return 0;
  const Node* const nodes = list.document->nodes.data();
  std::size_t out = 0;
  for (NodeIndex at = begin.node; at != kNoNode; at = nodes[at].next) ++out;
  return out;
}

Expression unquoted(Expression expression, const Words& words) {
  while (true) {
    const Expression begin = first(expression);
    if (!begin || (*begin).list) return expression;
    const Term word = (*begin).atom;
    if (word != words.quote && word != words.backquote) return expression;
    const Expression inner = next(begin);
    if (!inner || next(inner)) return expression;
    expression = inner;
  }
}

}  // namespace skein::htn
