// SPDX-License-Identifier: Apache-2.0
// Strict reading of a parsed document: every error is collected, none stops the reading.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/config/value.hpp"
#include "skein/foundation/diagnostics.hpp"

namespace skein::config {

/// Closed range of a number with its unit, for checks and for messages.
struct Range {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  const char* unit = "";
};

/// A view of one value of a document: where it is, and typed access to what it says. A question
/// that the value cannot answer adds a diagnostic and gives a harmless default, so that one reading
/// finds every error; whether anything went wrong is asked of the Diagnostics at the end.
/// An absent optional value gives defaults in silence.
/// Lifetime: the Value and the Diagnostics must outlive the reader. Thread rule: one thread.
class Reader {
 public:
  Reader(const Value& root, std::string file, Diagnostics& diagnostics);

  bool present() const { return value_ != nullptr && value_->kind != Value::Kind::kNull; }
  bool is_map() const { return present() && value_->kind == Value::Kind::kMap; }
  bool is_sequence() const { return present() && value_->kind == Value::Kind::kSequence; }
  bool is_scalar() const { return present() && value_->kind == Value::Kind::kScalar; }
  /// As it was parsed, for what is kept without being understood here; nothing if absent.
  const Value& value() const;
  const std::string& path() const { return path_; }
  const std::string& file() const { return file_; }
  /// From 1; of the nearest value above if this one is absent.
  int line() const { return line_; }

  /// Reports every key of this map that is not among `keys`, with the nearest that is; reports that
  /// this is not a map. True if it is one.
  bool keys(std::initializer_list<const char*> keys) const;
  /// The value under a key; absent if it is not there.
  Reader optional(const std::string& key) const;
  /// The value under a key; reports if it is not there.
  Reader required(const std::string& key) const;
  /// The entries of a map whose keys are names of the user's choosing, in the order written.
  std::vector<std::pair<std::string, Reader>> entries() const;
  /// The items of a list; reports anything else.
  std::vector<Reader> items() const;

  double number(double otherwise = 0, Range range = {}) const;
  std::int64_t integer(std::int64_t otherwise = 0,
                       std::int64_t low = std::numeric_limits<std::int64_t>::min(),
                       std::int64_t high = std::numeric_limits<std::int64_t>::max()) const;
  /// An unsigned 64-bit integer, for ids and seeds.
  std::uint64_t natural(std::uint64_t otherwise = 0) const;
  bool boolean(bool otherwise = false) const;
  std::string text(std::string otherwise = "") const;
  /// One of the names, else reports with the nearest; gives its index.
  std::size_t choice(std::initializer_list<const char*> names, std::size_t otherwise = 0) const;
  /// One of the names; gives the name itself, or empty. `what` completes "expected …".
  std::string name_among(const std::vector<std::string>& names, const std::string& what) const;
  /// A list of exactly `count` numbers (any number of them if 0).
  std::vector<double> numbers(std::size_t count = 0, Range range = {}) const;

  /// Adds an error at this value.
  void error(std::string message, std::string expected = "", std::string nearest = "") const;

 private:
  Reader(const Value* value, std::string file, std::string path, int line, int column,
         Diagnostics* diagnostics);
  std::optional<std::string> scalar_or_error(const std::string& expected) const;

  const Value* value_;
  std::string file_;
  std::string path_;
  int line_;
  int column_;
  Diagnostics* diagnostics_;
};

}  // namespace skein::config
