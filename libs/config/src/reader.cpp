// SPDX-License-Identifier: Apache-2.0
#include "skein/config/reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "skein/foundation/nearest.hpp"

namespace skein::config {

namespace {

std::string number_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

std::string range_text(const Range& range) {
  const bool low = range.low > std::numeric_limits<double>::lowest();
  const bool high = range.high < std::numeric_limits<double>::max();
  std::string text = "a number";
  if (low && high) text += " from " + number_text(range.low) + " to " + number_text(range.high);
  if (low && !high) text += " of at least " + number_text(range.low);
  if (!low && high) text += " of at most " + number_text(range.high);
  return *range.unit != '\0' ? text + " " + range.unit : text;
}

// Plain decimal only: no octal, no hexadecimal, no "inf", no blanks.
template <class Number>
std::optional<Number> parsed(const std::string& text) {
  const char* first = text.data();
  const char* last = first + text.size();
  if (first != last && *first == '+') ++first;
  const char* digits = first != last && *first == '-' ? first + 1 : first;
  if (digits == last || (*digits != '.' && (*digits < '0' || *digits > '9'))) return std::nullopt;
  const bool leading_zero =
      *digits == '0' && digits + 1 != last && digits[1] >= '0' && digits[1] <= '9';
  if (leading_zero) return std::nullopt;
  Number number{};
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc{} || end != last) return std::nullopt;
  return number;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < 12; ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > 12 ? text + ", …" : text;
}

}  // namespace

Reader::Reader(const Value& root, std::string file, Diagnostics& diagnostics)
    : Reader(&root, std::move(file), "", root.line, root.column, &diagnostics) {}

Reader::Reader(const Value* value, std::string file, std::string path, int line, int column,
               Diagnostics* diagnostics)
    : value_(value),
      file_(std::move(file)),
      path_(std::move(path)),
      line_(line),
      column_(column),
      diagnostics_(diagnostics) {}

void Reader::error(std::string message, std::string expected, std::string nearest) const {
  diagnostics_->add(
      {file_, line_, column_, path_, std::move(message), std::move(expected), std::move(nearest)});
}

const Value& Reader::value() const {
  static const Value nothing;
  return value_ != nullptr ? *value_ : nothing;
}

bool Reader::keys(std::initializer_list<const char*> keys) const {
  if (!present()) return false;
  if (!is_map()) {
    error(describe(*value_) + " where a map was expected");
    return false;
  }
  const std::vector<std::string> known(keys.begin(), keys.end());
  for (const auto& [key, value] : value_->entries) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const Reader at(&value, file_, path_.empty() ? key : path_ + "." + key, value.line,
                    value.column, diagnostics_);
    at.error("unknown key '" + key + "'", "one of " + joined(known), nearest_name(key, known));
  }
  return true;
}

Reader Reader::optional(const std::string& key) const {
  const Value* found = is_map() ? value_->find(key) : nullptr;
  const std::string below = path_.empty() ? key : path_ + "." + key;
  if (found == nullptr) return {nullptr, file_, below, line_, column_, diagnostics_};
  return {found, file_, below, found->line, found->column, diagnostics_};
}

Reader Reader::required(const std::string& key) const {
  Reader found = optional(key);
  if (!found.present() && present()) found.error("missing");
  return found;
}

std::vector<std::pair<std::string, Reader>> Reader::entries() const {
  std::vector<std::pair<std::string, Reader>> result;
  if (!present()) return result;
  if (!is_map()) {
    error(describe(*value_) + " where a map was expected");
    return result;
  }
  for (const auto& [key, value] : value_->entries) result.emplace_back(key, optional(key));
  return result;
}

std::vector<Reader> Reader::items() const {
  std::vector<Reader> result;
  if (!present()) return result;
  if (!is_sequence()) {
    error(describe(*value_) + " where a list was expected");
    return result;
  }
  for (std::size_t i = 0; i < value_->items.size(); ++i) {
    const Value& item = value_->items[i];
    result.push_back(Reader(&item, file_, path_ + "[" + std::to_string(i) + "]", item.line,
                            item.column, diagnostics_));
  }
  return result;
}

std::optional<std::string> Reader::scalar_or_error(const std::string& expected) const {
  if (!present()) return std::nullopt;
  if (is_scalar()) return value_->scalar;
  error(describe(*value_), expected);
  return std::nullopt;
}

double Reader::number(double otherwise, Range range) const {
  const auto scalar = scalar_or_error(range_text(range));
  if (!scalar) return otherwise;
  const auto value = value_->quoted ? std::nullopt : parsed<double>(*scalar);
  if (value && std::isfinite(*value) && *value >= range.low && *value <= range.high) return *value;
  error(describe(*value_), range_text(range));
  return otherwise;
}

std::int64_t Reader::integer(std::int64_t otherwise, std::int64_t low, std::int64_t high) const {
  const auto scalar = scalar_or_error("a whole number");
  if (!scalar) return otherwise;
  const auto value = parsed<std::int64_t>(*scalar);
  if (value && *value >= low && *value <= high) return *value;
  std::string expected = "a whole number";
  if (low != std::numeric_limits<std::int64_t>::min()) expected += " from " + std::to_string(low);
  if (high != std::numeric_limits<std::int64_t>::max()) expected += " to " + std::to_string(high);
  error(describe(*value_), expected);
  return otherwise;
}

std::uint64_t Reader::natural(std::uint64_t otherwise) const {
  const auto scalar = scalar_or_error("a whole number, not negative");
  if (!scalar) return otherwise;
  const auto value = parsed<std::uint64_t>(*scalar);
  if (value) return *value;
  error(describe(*value_), "a whole number, not negative");
  return otherwise;
}

bool Reader::boolean(bool otherwise) const {
  const auto scalar = scalar_or_error("true or false");
  if (!scalar) return otherwise;
  if (*scalar == "true" || *scalar == "false") return *scalar == "true";
  error(describe(*value_), "true or false");
  return otherwise;
}

std::string Reader::text(std::string otherwise) const {
  const auto scalar = scalar_or_error("text");
  return scalar ? *scalar : otherwise;
}

std::size_t Reader::choice(std::initializer_list<const char*> names, std::size_t otherwise) const {
  const std::vector<std::string> known(names.begin(), names.end());
  const auto scalar = scalar_or_error("one of " + joined(known));
  if (!scalar) return otherwise;
  const auto found = std::find(known.begin(), known.end(), *scalar);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  error("'" + *scalar + "'", "one of " + joined(known), nearest_name(*scalar, known));
  return otherwise;
}

std::string Reader::name_among(const std::vector<std::string>& names,
                               const std::string& what) const {
  const auto scalar = scalar_or_error(what);
  if (!scalar) return "";
  if (std::find(names.begin(), names.end(), *scalar) != names.end()) return *scalar;
  error("unknown name '" + *scalar + "'", what, nearest_name(*scalar, names));
  return "";
}

std::vector<double> Reader::numbers(std::size_t count, Range range) const {
  std::vector<double> result;
  if (!present()) return result;
  const std::string expected =
      count == 0 ? "a list of numbers" : "a list of " + std::to_string(count) + " numbers";
  if (!is_sequence() || (count != 0 && value_->items.size() != count)) {
    error(describe(*value_), expected);
    return std::vector<double>(count, 0.0);
  }
  for (const Reader& item : items()) result.push_back(item.number(0, range));
  return result;
}

}  // namespace skein::config
