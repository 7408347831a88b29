// SPDX-License-Identifier: Apache-2.0
#include "language/scanner.hpp"

#include <algorithm>
#include <array>

#include "language/characters.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kMostErrors = 100;
constexpr int kDeepestFeature = 64;

constexpr std::array<std::string_view, 7> kDefinitions = {
    "defdomain",  "defproblem", "make-problem", "def-problem-set",
    "in-package", "defpackage", "defun"};
constexpr std::size_t kClosedDefinitions = 4;  // those that never hold another definition
constexpr std::array<std::string_view, 7> kItems = {":method", ":operator", ":op",         ":-",
                                                    ":action", ":derived",  ":pddl-method"};

bool same_without_case(std::string_view text, std::string_view lower) {
  return std::equal(text.begin(), text.end(), lower.begin(), lower.end(), [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

// No feature is set.
bool feature_holds(const Document& document, NodeIndex node, int nesting) {
  const Node& expression = document[node];
  if (!expression.list || expression.first_child == kNoNode || nesting > kDeepestFeature) {
    return false;
  }
  const Node& head = document[expression.first_child];
  const std::string_view word =
      std::string_view(document.text).substr(head.begin, head.end - head.begin);
  const bool all = same_without_case(word, "and") || same_without_case(word, ":and");
  const bool none = same_without_case(word, "not") || same_without_case(word, ":not");
  for (NodeIndex at = head.next; at != kNoNode; at = document[at].next) {
    const bool holds = feature_holds(document, at, nesting + 1);
    if (none) return !holds;
    if (holds != all) return holds;
  }
  return all;
}

// From 1; 0 if something else comes before it.
std::uint32_t column_if_first_on_line(std::string_view text, std::uint32_t at) {
  std::uint32_t begin = at;
  while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
  return begin == 0 || text[begin - 1] == '\n' ? at - begin + 1 : 0;
}

}  // namespace

Scanner::Scanner(Document& document, TermStore& store, Diagnostics& problems, bool guess_missing)
    : document_(document),
      in_{document.text},
      store_(store),
      problems_(problems),
      guess_missing_(guess_missing),
      quote_(store.symbol("quote")),
      function_(store.symbol("function")),
      backquote_(store.symbol("backquote")),
      comma_(store.symbol("comma")),
      comma_at_(store.symbol("comma-at")) {}

bool Scanner::scan() {
  if (in_.text.starts_with("\xEF\xBB\xBF")) in_.at = 3;
  if (in_.text.substr(in_.at).starts_with("#!")) skip_line();
  while (true) {
    while (!in_.at_end() && (traits_of(in_.text[in_.at]) & kSpaceByte) != 0) ++in_.at;
    if (in_.at_end() || !bounded()) return finish();
    if (!wanted_.empty() && frames_.empty() && pass_over_problem()) continue;
    next();
  }
}

// False, and nothing is left to read: one step more would be beyond what is read of any text.
bool Scanner::stop_at_bound() {
  const bool deep = frames_.size() >= kDeepestText;
  error(in_.offset(), (deep ? "nested more than " + std::to_string(kDeepestText) + " deep"
                            : "more than " + std::to_string(kMostExpressions) + " expressions") +
                          "; what follows is not read");
  cut_ = true;
  in_.at = in_.text.size();
  return false;
}

void Scanner::next() {
  switch (in_.text[in_.at]) {
    case '(':
      return open_list();
    case ')':
      return close_list();
    case ';':
      return skip_line();
    case '"':
      return read_string();
    case '\'':
      return open_prefix(quote_, 1);
    case '`':
      return open_prefix(backquote_, 1);
    case ',':
      if (in_.peek(1) == '@' || in_.peek(1) == '.') return open_prefix(comma_at_, 2);
      return open_prefix(comma_, 1);
    case '#':
      return read_hash();
    default:
      if ((traits_of(in_.text[in_.at]) & kTokenByte) != 0) return read_token();
      error(in_.offset(), "stray control character");
      ++in_.at;
  }
}

void Scanner::error(std::uint32_t where, std::string message, std::string expected) {
  if (errors_ > kMostErrors) return;
  if (errors_++ == kMostErrors) {
    message = "more than " + std::to_string(kMostErrors) + " errors; the rest is not reported";
    expected.clear();
  }
  const Place place = place_of(document_, where);
  problems_.add(clipped(
      {document_.file, place.line, place.column, "", std::move(message), std::move(expected), ""}));
}

// Lists

void Scanner::open_list() {
  if (guess_missing_) guess_missing_before(in_.at);
  Frame frame;
  frame.node = static_cast<NodeIndex>(document_.nodes.size());
  frame.node_count = document_.nodes.size();
  frame.begin = in_.offset();
  if (guess_missing_) {
    frame.construct = construct_at(in_.at);
    frame.column = column_if_first_on_line(in_.text, frame.begin);
    open_definitions_ += frame.construct == Construct::kDefinition ? 1 : 0;
    open_items_ += frame.construct == Construct::kItem ? 1 : 0;
  }
  Node node;
  node.begin = frame.begin;
  node.list = true;
  document_.nodes.push_back(node);
  frames_.push_back(frame);
  document_.depth = std::max(document_.depth, ++depth_);
  ++in_.at;
}

void Scanner::close_list() {
  while (!frames_.empty() && frames_.back().kind != Kind::kList) pop_frame();
  if (frames_.empty()) {
    error(
        in_.offset(), "unmatched ')'",
        document_.top.empty()
            ? ""
            : "one ')' fewer since line " +
                  std::to_string(place_of(document_, document_[document_.top.back()].begin).line));
    ++in_.at;
    return;
  }
  ++in_.at;
  pop_list();
}

void Scanner::pop_list() {
  Frame frame = frames_.back();
  Node& list = document_.nodes[frame.node];
  list.end = in_.offset();
  if (frame.dot == Dot::kSeen) error(list.end - 1, "no expression between '.' and ')'");
  if (frame.dot == Dot::kFilled) {
    const Node& tail = document_.nodes[frame.last];
    const bool spliced = tail.list || tail.atom == kNil;
    list.dotted = spliced ? tail.list && tail.dotted : true;
    if (spliced) {
      document_.nodes[frame.before].next = tail.list ? tail.first_child : kNoNode;
    }
  }
  open_definitions_ -= frame.construct == Construct::kDefinition ? 1 : 0;
  open_items_ -= frame.construct == Construct::kItem ? 1 : 0;
  --depth_;
  frames_.pop_back();
  datum_done(frame.node);
}

void Scanner::open_prefix(Term word, std::size_t length) {
  Frame frame;
  frame.kind = Kind::kPrefix;
  frame.node = static_cast<NodeIndex>(document_.nodes.size());
  frame.node_count = document_.nodes.size();
  frame.begin = in_.offset();
  Node list;
  list.begin = frame.begin;
  list.list = true;
  list.first_child = frame.node + 1;
  Node head;
  head.atom = word;
  head.begin = frame.begin;
  head.end = frame.begin + static_cast<std::uint32_t>(length);
  document_.nodes.push_back(list);
  document_.nodes.push_back(head);
  frames_.push_back(frame);
  document_.depth = std::max(document_.depth, ++depth_);
  in_.at += length;
}

void Scanner::open_frame(Kind kind, std::size_t length, bool plus) {
  Frame frame;
  frame.kind = kind;
  frame.plus = plus;
  frame.begin = in_.offset();
  frame.node_count = document_.nodes.size();
  frames_.push_back(frame);
  in_.at += length;
}

// A frame that waits for an expression that does not come, or a list that ends here.
void Scanner::pop_frame() {
  const Frame frame = frames_.back();
  if (frame.kind == Kind::kList) return pop_list();
  const std::size_t length = frame.kind == Kind::kPrefix && in_.text[frame.begin] != '#' ? 1 : 2;
  if (!cut_) {
    error(frame.begin, "nothing follows " + std::string(in_.text.substr(frame.begin, length)),
          "an expression");
  }
  if (frame.kind == Kind::kPrefix) --depth_;
  document_.nodes.resize(frame.node_count);
  frames_.pop_back();
}

// Expressions

void Scanner::add_atom(Term atom, std::uint32_t begin) {
  Node node;
  node.atom = atom;
  node.begin = begin;
  node.end = in_.offset();
  document_.nodes.push_back(node);
  datum_done(static_cast<NodeIndex>(document_.nodes.size() - 1));
}

void Scanner::datum_done(NodeIndex node) {
  while (!frames_.empty()) {
    Frame& frame = frames_.back();
    switch (frame.kind) {
      case Kind::kList:
        return link(frame, node);
      case Kind::kPrefix:
        close_prefix(node);
        node = frame.node;
        --depth_;
        frames_.pop_back();
        break;
      case Kind::kForm:
        frames_.pop_back();
        break;
      case Kind::kFeature:
        return feature_done(node);
      case Kind::kDiscard:
        document_.nodes.resize(frame.node_count);
        frames_.pop_back();
        return;
    }
  }
  document_.top.push_back(node);
}

void Scanner::link(Frame& frame, NodeIndex node) {
  if (frame.dot == Dot::kFilled) {
    error(document_[node].begin, "more than one expression after '.'", "')'");
    frame.dot = Dot::kNone;
  }
  if (frame.dot == Dot::kSeen) frame.dot = Dot::kFilled;
  if (frame.last == kNoNode) {
    document_.nodes[frame.node].first_child = node;
  } else {
    document_.nodes[frame.last].next = node;
  }
  frame.before = frame.last;
  frame.last = node;
}

void Scanner::close_prefix(NodeIndex node) {
  Node& list = document_.nodes[frames_.back().node];
  document_.nodes[list.first_child].next = node;
  list.end = document_[node].end;
}

void Scanner::feature_done(NodeIndex node) {
  Frame& frame = frames_.back();
  const bool kept = feature_holds(document_, node, 0) == frame.plus;
  document_.nodes.resize(frame.node_count);
  if (kept) {
    frames_.pop_back();
  } else {
    frame.kind = Kind::kDiscard;
  }
}

// Missing parentheses

Scanner::Construct Scanner::construct_at(std::size_t at) const {
  std::size_t begin = at + 1;
  std::size_t end = begin;
  while (end < in_.text.size() && (traits_of(in_.text[end]) & kTokenByte) != 0) ++end;
  std::string_view word = in_.text.substr(begin, end - begin);
  const std::size_t colon = word.rfind(':');
  if (colon != std::string_view::npos && colon > 0) word.remove_prefix(colon + 1);
  const auto is_word = [word](std::string_view known) { return same_without_case(word, known); };
  const auto closed = kDefinitions.begin() + kClosedDefinitions;
  if (std::any_of(kDefinitions.begin(), closed, is_word)) return Construct::kDefinition;
  if (std::any_of(closed, kDefinitions.end(), is_word)) return Construct::kOtherDefinition;
  if (std::any_of(kItems.begin(), kItems.end(), is_word)) return Construct::kItem;
  return Construct::kOther;
}

// A definition in a definition, or an item in an item: the outer one should have ended before.
void Scanner::guess_missing_before(std::size_t at) {
  const Construct construct = construct_at(at);
  const bool item = construct == Construct::kItem;
  const bool definition =
      construct == Construct::kDefinition || construct == Construct::kOtherDefinition;
  if (definition ? open_definitions_ > 0 : item && open_items_ > 0) {
    std::size_t index = frames_.size() - 1;
    const auto wanted = item ? Construct::kItem : Construct::kDefinition;
    while (frames_[index].construct != wanted) --index;
    close_unclosed(index);
    return;
  }
  const std::uint32_t column = column_if_first_on_line(in_.text, static_cast<std::uint32_t>(at));
  if (column > 1 && suspect_ == kNoNode && !frames_.empty() && frames_.back().column == column) {
    suspect_ = frames_.back().begin;
    suspect_before_ = static_cast<std::uint32_t>(at);
  }
}

void Scanner::close_unclosed(std::size_t frame) {
  std::size_t open = 0;
  for (std::size_t at = frame; at < frames_.size(); ++at) {
    open += frames_[at].kind == Kind::kList ? 1 : 0;
  }
  error(frames_[frame].begin, "unclosed '('",
        std::to_string(open) + (open == 1 ? " more ')'" : " more ')'s") + " before line " +
            std::to_string(place_of(document_, in_.offset()).line));
  suspect_ = kNoNode;
  while (frames_.size() > frame) pop_frame();
}

bool Scanner::finish() {
  const auto is_list = [](const Frame& frame) { return frame.kind == Kind::kList; };
  if (std::any_of(frames_.begin(), frames_.end(), is_list) && !cut_) {
    if (!guess_missing_) return false;
    report_unclosed_at_end();
  }
  while (!frames_.empty()) pop_frame();
  return true;
}

void Scanner::report_unclosed_at_end() {
  const auto outermost = std::find_if(frames_.begin(), frames_.end(),
                                      [](const Frame& frame) { return frame.kind == Kind::kList; });
  std::string expected = std::to_string(depth_) + (depth_ == 1 ? " more ')'" : " more ')'s");
  if (suspect_ != kNoNode) {
    const Place opened = place_of(document_, suspect_);
    expected += ", perhaps for the list at line " + std::to_string(opened.line) +
                " before the one at line " +
                std::to_string(place_of(document_, suspect_before_).line);
  }
  error(outermost->begin, "unclosed '('", std::move(expected));
}

}  // namespace skein::htn
