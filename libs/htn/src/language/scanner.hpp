// SPDX-License-Identifier: Apache-2.0
// Turns a text into the nodes of a Document, in one pass with an explicit stack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "language/cursor.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/syntax.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// Scans one text once. A missing parenthesis shows only at the end of the text: the caller then
/// scans again with `guess_missing`, which takes a definition inside a definition, or an item
/// inside an item, as the sign that the outer one was never closed.
class Scanner {
 public:
  Scanner(Document& document, TermStore& store, Diagnostics& problems, bool guess_missing);

  /// Of the top-level forms (defproblem NAME …) only those of these names, if there are any; the
  /// names of the others go to passed_over().
  void want(const std::vector<std::string>& problems) { wanted_ = problems; }
  const std::vector<std::string>& passed_over() const { return passed_over_; }
  /// False: some list was still open at the end of the text (nothing was reported for it unless
  /// missing parentheses are guessed).
  bool scan();

 private:
  enum class Kind : std::uint8_t {
    kList,
    kPrefix,   ///< 'x and its like: closed by the one expression that follows
    kForm,     ///< #.x: the expression itself
    kFeature,  ///< #+f or #-f: the feature expression comes first
    kDiscard   ///< the expression that follows is left out
  };
  enum class Dot : std::uint8_t { kNone, kSeen, kFilled };
  enum class Construct : std::uint8_t { kOther, kDefinition, kOtherDefinition, kItem };
  struct Frame {
    Kind kind = Kind::kList;
    Dot dot = Dot::kNone;
    Construct construct = Construct::kOther;
    bool plus = false;           ///< #+ rather than #-
    NodeIndex node = kNoNode;    ///< of a list or prefix
    NodeIndex last = kNoNode;    ///< last child so far
    NodeIndex before = kNoNode;  ///< the child before the last
    std::uint32_t begin = 0;
    std::uint32_t column = 0;    ///< if it is the first on its line, else 0
    std::size_t node_count = 0;  ///< when the frame was opened: to leave out what it holds
  };

  // scanner.cpp: lists and what is around them
  void next();
  bool finish();
  void open_list();
  void close_list();
  void open_prefix(Term word, std::size_t length);
  void open_frame(Kind kind, std::size_t length, bool plus = false);
  void pop_frame();
  void pop_list();
  void add_atom(Term atom, std::uint32_t begin);
  void datum_done(NodeIndex node);
  void link(Frame& frame, NodeIndex node);
  void close_prefix(NodeIndex node);
  void feature_done(NodeIndex node);
  Construct construct_at(std::size_t at) const;
  void guess_missing_before(std::size_t at);
  void close_unclosed(std::size_t frame);
  void report_unclosed_at_end();

  // scanner_skip.cpp: problems that nobody wants
  bool pass_over_problem();

  // scanner_tokens.cpp: atoms and comments
  void skip_line();
  void skip_block_comment();
  void read_string();
  void read_hash();
  void read_radix(int radix);
  void read_character();
  void read_token();
  void read_escaped(std::uint32_t begin);
  Term symbol_of(std::string_view token, std::uint32_t begin);
  void take_plain(std::string_view token, std::uint32_t begin);
  void take_dots(std::string_view token, std::uint32_t begin);
  bool take_number(std::string_view token, std::uint32_t begin);
  void check_utf8(std::uint32_t begin, std::uint32_t end);

  bool bounded() {
    const bool within = frames_.size() < kDeepestText && document_.nodes.size() < kMostExpressions;
    return within || stop_at_bound();
  }
  bool stop_at_bound();
  std::string_view bounded_name(std::string_view name, std::uint32_t begin) {
    return name.size() <= kLongestName ? name : cut_name(name, begin);
  }
  std::string_view cut_name(std::string_view name, std::uint32_t begin);
  void error(std::uint32_t where, std::string message, std::string expected = "");

  Document& document_;
  Cursor in_;
  TermStore& store_;
  Diagnostics& problems_;
  bool guess_missing_;
  std::span<const std::string> wanted_;
  std::vector<std::string> passed_over_;
  std::vector<Frame> frames_;
  std::uint32_t depth_ = 0;  ///< open lists
  std::size_t open_definitions_ = 0;
  std::size_t open_items_ = 0;
  std::size_t errors_ = 0;
  bool cut_ = false;                        ///< a string or comment swallowed the rest
  std::uint32_t suspect_ = kNoNode;         ///< a list that its indentation says is over
  std::uint32_t suspect_before_ = kNoNode;  ///< where that showed
  Term quote_, function_, backquote_, comma_, comma_at_;
};

}  // namespace skein::htn
