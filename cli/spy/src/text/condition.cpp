// SPDX-License-Identifier: Apache-2.0
#include "condition.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

/// Deeper than this is no condition that somebody wrote.
constexpr int kDeepest = 100;

enum class Token : std::uint8_t { kEnd, kWord, kNumber, kText, kSign, kWrong };

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == '[' || c == ']' || c == '-';
}

bool begins_number(std::string_view text) {
  const std::size_t sign = text.front() == '-' ? 1 : 0;
  return text.size() > sign && text[sign] >= '0' && text[sign] <= '9';
}

/// One token at a time.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) { next(); }
  Token token() const { return token_; }
  const std::string& text() const { return value_; }
  /// Of the token, from 1.
  std::size_t column() const { return begin_ + 1; }
  bool is(std::string_view sign) const { return token_ == Token::kSign && value_ == sign; }
  void next();

 private:
  void take(Token token, std::size_t length) {
    token_ = token;
    value_ = std::string(text_.substr(begin_, length));
    at_ = begin_ + length;
  }
  void take_text();

  std::string_view text_;
  std::size_t at_ = 0, begin_ = 0;
  Token token_ = Token::kEnd;
  std::string value_;
};

void Lexer::next() {
  begin_ = std::min(text_.find_first_not_of(" \t\n", at_), text_.size());
  const std::string_view rest = text_.substr(begin_);
  if (rest.empty()) return take(Token::kEnd, 0);
  if (rest.front() == '\'' || rest.front() == '"') return take_text();
  for (const char* sign : {"&&", "||", "==", "!=", "<=", ">=", "<", ">", "!", "(", ")"})
    if (rest.starts_with(sign)) return take(Token::kSign, std::string_view(sign).size());
  std::size_t length = 0;
  const bool number = begins_number(rest);
  while (length < rest.size() && (is_word(rest[length]) || (number && rest[length] == '+')))
    ++length;
  take(length == 0 ? Token::kWrong
       : number    ? Token::kNumber
                   : Token::kWord,
       std::max<std::size_t>(length, 1));
}

void Lexer::take_text() {
  const std::size_t end = text_.find(text_[begin_], begin_ + 1);
  if (end == std::string_view::npos) return take(Token::kWrong, text_.size() - begin_);
  take(Token::kText, end + 1 - begin_);
  value_ = value_.substr(1, value_.size() - 2);
}

enum class Relation : std::uint8_t { kIs, kEqual, kUnequal, kLess, kAtMost, kMore, kAtLeast };

std::optional<Relation> relation_of(const Lexer& at) {
  constexpr std::array<std::string_view, 6> kSigns{"==", "!=", "<", "<=", ">", ">="};
  for (std::size_t i = 0; i < kSigns.size(); ++i)
    if (at.is(kSigns[i])) return static_cast<Relation>(i + 1);
  return std::nullopt;
}

template <class T>
bool compares(const T& a, Relation relation, const T& b) {
  switch (relation) {
    case Relation::kEqual:
      return a == b;
    case Relation::kUnequal:
      return !(a == b);
    case Relation::kLess:
      return a < b;
    case Relation::kAtMost:
      return a <= b;
    case Relation::kMore:
      return b < a;
    case Relation::kAtLeast:
      return b <= a;
    case Relation::kIs:
      break;
  }
  return false;
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

struct Condition::Node {
  enum class Kind : std::uint8_t { kComparison, kNot, kAnd, kOr };
  Kind kind = Kind::kComparison;
  std::unique_ptr<Node> left, right;
  Path path;
  Relation relation = Relation::kIs;
  Json value;

  bool holds(const Json& sample) const;
  bool holds_of(const Json& found) const;
};

bool Condition::Node::holds_of(const Json& found) const {
  if (relation == Relation::kIs) return !found.is_boolean() || found.get<bool>();
  if (found.is_number() && value.is_number()) return compares(found, relation, value);
  return compares(text_of(found), relation, text_of(value));
}

bool Condition::Node::holds(const Json& sample) const {
  switch (kind) {
    case Kind::kNot:
      return !left->holds(sample);
    case Kind::kAnd:
      return left->holds(sample) && right->holds(sample);
    case Kind::kOr:
      return left->holds(sample) || right->holds(sample);
    case Kind::kComparison:
      break;
  }
  const auto found = values_at(sample, path);
  return std::ranges::any_of(found, [this](const Json* one) { return holds_of(*one); });
}

namespace {

using Node = Condition::Node;

class Parser {
 public:
  Parser(std::string_view text, std::vector<std::string>& paths) : lexer_(text), paths_(paths) {}

  /// Null where it is wrong; then error() says how.
  std::unique_ptr<Node> whole() {
    auto node = either();
    if (node != nullptr && lexer_.token() != Token::kEnd) return wrong("&& or || or the end");
    return node;
  }
  const std::string& error() const { return error_; }

 private:
  std::unique_ptr<Node> wrong(const std::string& expected) {
    if (error_.empty())
      error_ = "column " + std::to_string(lexer_.column()) + ": expected " + expected +
               (lexer_.token() == Token::kEnd ? ", not the end" : ", not '" + lexer_.text() + "'");
    return nullptr;
  }
  std::unique_ptr<Node> both_of(Node::Kind kind, std::unique_ptr<Node> left,
                                std::unique_ptr<Node> right) {
    if (left == nullptr || right == nullptr) return nullptr;
    auto node = std::make_unique<Node>();
    node->kind = kind;
    node->left = std::move(left);
    node->right = std::move(right);
    return node;
  }
  std::unique_ptr<Node> either() {
    auto node = both();
    while (node != nullptr && lexer_.is("||")) {
      lexer_.next();
      node = both_of(Node::Kind::kOr, std::move(node), both());
    }
    return node;
  }
  std::unique_ptr<Node> both() {
    auto node = one();
    while (node != nullptr && lexer_.is("&&")) {
      lexer_.next();
      node = both_of(Node::Kind::kAnd, std::move(node), one());
    }
    return node;
  }
  std::unique_ptr<Node> one() {
    if (++depth_ > kDeepest) return wrong("fewer parentheses");
    std::unique_ptr<Node> node;
    if (lexer_.is("!")) {
      lexer_.next();
      auto inner = one();
      if (inner != nullptr) {
        node = std::make_unique<Node>();
        node->kind = Node::Kind::kNot;
        node->left = std::move(inner);
      }
    } else if (lexer_.is("(")) {
      lexer_.next();
      node = either();
      if (node != nullptr && !lexer_.is(")")) return wrong("')'");
      lexer_.next();
    } else {
      node = comparison();
    }
    --depth_;
    return node;
  }
  std::unique_ptr<Node> comparison() {
    const auto path = lexer_.token() == Token::kWord ? parse_path(lexer_.text()) : failure("");
    if (!path) return wrong("a field");
    auto node = std::make_unique<Node>();
    node->path = *path;
    paths_.push_back(lexer_.text());
    lexer_.next();
    const auto relation = relation_of(lexer_);
    if (!relation) return node;
    node->relation = *relation;
    lexer_.next();
    const auto value = literal();
    if (!value) return wrong("a number, a word, true, false or 'text'");
    node->value = *value;
    lexer_.next();
    return node;
  }
  std::optional<Json> literal() const {
    if (lexer_.token() == Token::kText) return Json(lexer_.text());
    if (lexer_.token() == Token::kNumber) {
      Json number = Json::parse(lexer_.text(), nullptr, false);
      return number.is_number() ? std::optional(number) : std::nullopt;
    }
    if (lexer_.token() != Token::kWord) return std::nullopt;
    if (lexer_.text() == "true" || lexer_.text() == "false") return Json(lexer_.text() == "true");
    return Json(lexer_.text());
  }

  Lexer lexer_;
  std::vector<std::string>& paths_;
  std::string error_;
  int depth_ = 0;
};

}  // namespace

Condition::Condition() = default;
Condition::Condition(Condition&&) noexcept = default;
Condition& Condition::operator=(Condition&&) noexcept = default;
Condition::~Condition() = default;

Result<Condition, Failure> Condition::parse(std::string_view text) {
  Condition condition;
  Parser parser(text, condition.paths_);
  condition.root_ = parser.whole();
  if (condition.root_ == nullptr) return failure(parser.error());
  return condition;
}

bool Condition::holds(const Json& sample) const { return root_->holds(sample); }

}  // namespace skein::spy_tool
