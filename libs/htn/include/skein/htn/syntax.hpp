// SPDX-License-Identifier: Apache-2.0
// S-expressions with their places in the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// Position of a node in its Document; kNoNode: absent.
using NodeIndex = std::uint32_t;
inline constexpr NodeIndex kNoNode = 0xFFFFFFFFU;

/// One expression: an atom with its term, or a list with its children in order. 'x is read as
/// (quote x), #'f as (function f), `x as (backquote x), ,x as (comma x), ,@x as (comma-at x). A
/// dotted tail is the last child, with `dotted` set on the list; (a . (b c)) is read as (a b c) and
/// (a . nil) as (a). Variables `?x` are symbols here.
struct Node {
  Term atom;                        ///< for atoms
  NodeIndex first_child = kNoNode;  ///< for lists that are not empty
  NodeIndex next = kNoNode;         ///< the following sibling
  std::uint32_t begin = 0;          ///< first byte in the text
  std::uint32_t end = 0;            ///< behind the last byte
  bool list = false;
  bool dotted = false;
};

/// The expressions of one file. The nodes stand in the order of the text: all that is inside a list
/// follows it, up to the first node that begins behind the list's end.
struct Document {
  std::string file;  ///< as the user named it
  std::string text;
  std::vector<Node> nodes;
  std::vector<NodeIndex> top;              ///< top-level expressions in order
  std::vector<std::uint32_t> line_begins;  ///< offset of the first byte of each line
  std::vector<std::uint32_t> characters;   ///< before each block of the text, for columns
  std::uint32_t depth = 0;                 ///< of the deepest list: 0 for atoms only

  const Node& operator[](NodeIndex index) const { return nodes[index]; }
};

/// Line and column, both from 1; a column is a UTF-8 character, whatever its width.
struct Place {
  int line = 1;
  int column = 1;
};
/// Cost: logarithmic in the number of lines, whatever their length.
Place place_of(const Document& document, std::uint32_t offset);

/// Bounds of what is read [lists open at once; bytes; expressions].
inline constexpr std::uint32_t kDeepestText = 1'000'000;
inline constexpr std::size_t kLongestName = 10'000;
inline constexpr std::size_t kMostExpressions = std::size_t{1} << 25U;

/// Reads all expressions of a text. Cost: linear, without recursion, 50 MB/s and more. Errors
/// (parentheses, strings and comments without end, dots and characters out of place, bad numbers)
/// are reported together, up to a hundred; what could be read is in the document. Where a
/// parenthesis is missing, the definition or item that lacks it is found by what follows. Texts are
/// limited to 1 GiB, lists to kDeepestText open ones, names to kLongestName bytes, and all of it to
/// kMostExpressions: reading ends there with an error, so that no text takes more than some
/// gigabytes.
Document read_document(std::string file, std::string text, TermStore& store, Diagnostics& problems);

/// The children of a list, in order.
std::vector<NodeIndex> children(const Document& document, NodeIndex list);

/// [characters]
inline constexpr std::size_t kLongestExcerpt = 200;

/// The line that a diagnostic is about, and below it the marks ("   ^~~~") that underline the
/// offending expression, as far as it lies on that line. Of a line longer than kLongestExcerpt
/// characters the part around the place is shown, between "…".
struct Excerpt {
  std::string line;
  std::string marks;
};
/// Empty strings when the text has no such line.
Excerpt excerpt(const Diagnostic& diagnostic, std::string_view text);

/// The diagnostic with no part of it longer than an excerpt, whatever names it quotes.
Diagnostic clipped(Diagnostic diagnostic);

/// "file:line:column: message; expected …" with the excerpt on the two lines below; for people.
std::string underlined(const Diagnostic& diagnostic, std::string_view text);

}  // namespace skein::htn
