// SPDX-License-Identifier: Apache-2.0
#include "json_document.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

namespace skein::temporal {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kDeepest = 16;
constexpr std::size_t kMostValues = 4'000'000;

// Characters that tell how many of them the parser has taken.
class CountedIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedIterator(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
  reference operator*() const { return *at_; }
  CountedIterator& operator++() {
    ++at_;
    ++*taken_;
    return *this;
  }
  CountedIterator operator++(int) {
    CountedIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountedIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* taken_;
};

// Line and column of growing offsets.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}

  std::size_t offset() const { return offset_; }

  void advance_to(std::size_t offset) {
    for (; offset_ < std::min(offset, text_.size()); ++offset_) {
      const bool line_ends = text_[offset_] == '\n';
      line_ += line_ends ? 1 : 0;
      column_ = line_ends ? 1 : column_ + 1;
    }
  }

  // To the beginning of the next token.
  void skip_separators() {
    const std::size_t found = text_.find_first_not_of(" \t\r\n,:", offset_);
    advance_to(found == std::string_view::npos ? text_.size() : found);
  }

  Place place() const { return {line_, column_, ""}; }

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  int line_ = 1;
  int column_ = 1;
};

/// Makes the tree from the events of the library's parser. Each token gives an event, so where one
/// begins is where the last one ended, and blanks.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  TreeBuilder(std::string_view text, const std::size_t& taken, Problems& problems)
      : text_(text), taken_(taken), counter_(text), problems_(problems) {}

  bool null() override { return add(JsonKind::kNull) != nullptr; }
  bool boolean(bool) override { return add(JsonKind::kFlag) != nullptr; }
  bool number_integer(std::int64_t) override { return number(); }
  bool number_unsigned(std::uint64_t) override { return number(); }
  bool number_float(double, const std::string&) override { return number(); }
  bool string(std::string& text) override {
    JsonValue* value = add(JsonKind::kString);
    if (value != nullptr) value->text = std::move(text);
    return value != nullptr;
  }
  bool binary(Json::binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonKind::kObject); }
  bool start_array(std::size_t) override { return open(JsonKind::kArray); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    const Place place = begin_token();
    end_token(taken_);
    if (!open_.back().keys.insert(name).second) {
      problems_.add(place, "key " + in_quotes(name) + " comes twice");
    }
    key_ = std::move(name);
    return !problems_.full();
  }

  bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
    const Place place = begin_token();
    const std::string_view rest = text_.substr(std::min(counter_.offset(), text_.size()));
    if (rest.empty()) {
      problems_.add(place, "not JSON: the text ends too early");
    } else if (rest.starts_with("NaN") || rest.starts_with("nan") || rest.starts_with("Inf")) {
      problems_.add(place, "not JSON: " + in_quotes(rest.substr(0, 3)) + " is not a number",
                    "a number of seconds, or null for a bound that is not there");
    } else if (error.id == 406) {
      problems_.add(place, "a number out of range");
    } else {
      const std::size_t length = std::min(rest.find_first_of(" \t\r\n"), std::size_t{20});
      problems_.add(place, "not JSON at " + in_quotes(rest.substr(0, length)));
    }
    return false;
  }

  JsonValue take() { return std::move(root_); }

 private:
  struct Open {
    JsonValue* value;
    std::set<std::string> keys;
  };

  Place begin_token() {
    counter_.skip_separators();
    return counter_.place();
  }

  void end_token(std::size_t end) { counter_.advance_to(end); }

  // A value that begins here; the parser has gone past the end of one that is no number. Null when
  // there are too many.
  JsonValue* add(JsonKind kind) {
    const Place place = begin_token();
    if (++count_ > kMostValues) {
      problems_.add(place, "more than " + std::to_string(kMostValues) + " values");
      return nullptr;
    }
    JsonValue value;
    value.kind = kind;
    value.line = place.line;
    value.column = place.column;
    value.key = std::move(key_);
    key_.clear();
    if (kind != JsonKind::kNumber) end_token(taken_);
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    open_.back().value->items.push_back(std::move(value));
    return &open_.back().value->items.back();
  }

  // The parser has read one character further than a number; the number itself tells its end.
  bool number() {
    JsonValue* value = add(JsonKind::kNumber);
    if (value == nullptr) return false;
    const std::size_t begin = counter_.offset();
    const std::size_t end =
        std::min(text_.find_first_not_of("+-.0123456789eE", begin), text_.size());
    value->text = text_.substr(begin, end - begin);
    end_token(end);
    return true;
  }

  bool open(JsonKind kind) {
    JsonValue* value = add(kind);
    if (value == nullptr) return false;
    if (open_.size() == kDeepest) {
      problems_.add({value->line, value->column, ""},
                    "nested more than " + std::to_string(kDeepest) + " deep");
      return false;
    }
    // Stays valid: nothing is added to the items of the parent before this one is closed.
    open_.push_back({value, {}});
    return true;
  }

  bool close() {
    begin_token();
    end_token(taken_);
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::size_t& taken_;
  LineCounter counter_;
  Problems& problems_;
  JsonValue root_;
  std::vector<Open> open_;
  std::string key_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<JsonValue> parse_json(std::string_view text, Problems& problems) {
  std::size_t taken = 0;
  TreeBuilder builder(text, taken, problems);
  const bool parsed = Json::sax_parse(CountedIterator(text.data(), &taken),
                                      CountedIterator(text.data() + text.size(), &taken), &builder);
  if (!parsed || !problems.none()) {
    if (problems.none()) problems.add({}, "not JSON");
    return std::nullopt;
  }
  return builder.take();
}

const JsonValue* JsonNode::value_of(std::string_view key) const {
  if (value_->kind != JsonKind::kObject) return nullptr;
  const auto found = std::find_if(value_->items.begin(), value_->items.end(),
                                  [&](const JsonValue& one) { return one.key == key; });
  return found == value_->items.end() ? nullptr : &*found;
}

void JsonNode::wrong_kind(std::string expected) const {
  constexpr std::string_view kKinds[] = {"null",     "true or false", "a number",
                                         "a string", "an array",      "an object"};
  wrong("this is " + std::string(kKinds[static_cast<std::size_t>(value_->kind)]),
        std::move(expected));
}

bool JsonNode::is_object() const {
  if (value_->kind != JsonKind::kObject) wrong_kind("an object");
  return value_->kind == JsonKind::kObject;
}

bool JsonNode::is_object_of(std::initializer_list<std::string_view> keys) const {
  if (!is_object()) return false;
  for (const JsonValue& one : value_->items) {
    if (std::find(keys.begin(), keys.end(), one.key) != keys.end()) continue;
    problems_->add_unknown({one.line, one.column, path_}, "key", one.key,
                           {keys.begin(), keys.end()});
  }
  return true;
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  const JsonValue* found = value_of(key);
  if (found == nullptr) return std::nullopt;
  return JsonNode(*found, path_.empty() ? std::string(key) : path_ + "." + std::string(key),
                  *problems_);
}

std::optional<JsonNode> JsonNode::at(std::string_view key) const {
  std::optional<JsonNode> found = find(key);
  if (!found) wrong("missing key " + in_quotes(key));
  return found;
}

std::vector<JsonNode> JsonNode::items() const {
  std::vector<JsonNode> all;
  if (value_->kind != JsonKind::kArray) {
    wrong_kind("an array");
    return all;
  }
  all.reserve(value_->items.size());
  for (const JsonValue& one : value_->items) {
    all.emplace_back(one, path_ + "[" + std::to_string(all.size()) + "]", *problems_);
  }
  return all;
}

std::optional<std::string> JsonNode::name() const {
  if (value_->kind != JsonKind::kString) {
    wrong_kind("a name");
    return std::nullopt;
  }
  std::string problem = name_problem(value_->text);
  if (problem.empty()) return value_->text;
  wrong(std::move(problem));
  return std::nullopt;
}

std::optional<Ticks> JsonNode::seconds() const {
  if (value_->kind != JsonKind::kNumber) {
    wrong_kind("a number of seconds");
    return std::nullopt;
  }
  const Result<Ticks, BadSeconds> ticks = seconds_from(value_->text, BelowNanosecond::kRefuse);
  if (ticks) return *ticks;
  add_bad_seconds(*problems_, place(), value_->text, ticks.error());
  return std::nullopt;
}

std::optional<Ticks> JsonNode::bound(Ticks open) const {
  if (value_->kind == JsonKind::kNull) return open;
  if (value_->kind == JsonKind::kNumber) return seconds();
  wrong_kind("a number of seconds, or null for no bound");
  return std::nullopt;
}

std::optional<std::uint32_t> JsonNode::position(std::size_t most) const {
  const std::string& text = value_->text;
  const bool whole = value_->kind == JsonKind::kNumber && text.size() <= 9 &&
                     text.find_first_not_of("0123456789") == std::string::npos;
  const unsigned long value = whole ? std::stoul(text) : most + 1;
  if (value <= most) return static_cast<std::uint32_t>(value);
  wrong("not a position" + (text.empty() ? "" : ": " + in_quotes(text)),
        "a whole number from 0 to " + std::to_string(most));
  return std::nullopt;
}

void add_bad_seconds(Problems& problems, const Place& place, std::string_view text,
                     BadSeconds why) {
  switch (why) {
    case BadSeconds::kNotANumber:
      return problems.add(place, in_quotes(text) + " is not a number", "a number of seconds");
    case BadSeconds::kOverflow:
      return problems.add(place, in_quotes(text) + " overflows",
                          "seconds within ±" + seconds_text(kLargest));
    case BadSeconds::kTooFine:
      return problems.add(place, in_quotes(text) + " is finer than a nanosecond",
                          "at most nine decimals");
  }
}

std::string json_string(std::string_view text) { return Json(text).dump(); }

std::string json_bound(Ticks ticks) {
  return ticks == kInfinite || ticks == kMinusInfinite ? "null" : seconds_text(ticks);
}

}  // namespace skein::temporal
