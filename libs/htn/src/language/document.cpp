// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>

#include "language/scanner.hpp"
#include "language/wanted_document.hpp"
#include "skein/htn/syntax.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kBytesPerNode = 6;  // about what domains and problems have
constexpr std::size_t kLargestText = std::size_t{1} << 30U;

std::vector<std::uint32_t> line_begins_of(std::string_view text) {
  std::vector<std::uint32_t> begins = {0};
  for (std::size_t at = text.find('\n'); at != std::string_view::npos;
       at = text.find('\n', at + 1)) {
    begins.push_back(static_cast<std::uint32_t>(at + 1));
  }
  return begins;
}

constexpr std::size_t kBlock = std::size_t{1} << 16U;  // bytes

std::vector<std::uint32_t> characters_before_blocks(std::string_view text) {
  std::vector<std::uint32_t> before = {0};
  for (; text.size() > kBlock; text.remove_prefix(kBlock)) {
    const std::size_t here = count_characters(text.substr(0, kBlock));
    before.push_back(before.back() + static_cast<std::uint32_t>(here));
  }
  return before;
}

std::size_t characters_before(const Document& document, std::uint32_t offset) {
  const std::size_t block = std::min(offset / kBlock, document.characters.size() - 1);
  const std::string_view rest =
      std::string_view(document.text).substr(block * kBlock, offset - block * kBlock);
  return document.characters[block] + count_characters(rest);
}

}  // namespace

Place place_of(const Document& document, std::uint32_t offset) {
  const auto& begins = document.line_begins;
  if (begins.empty()) return {};
  const auto behind = std::upper_bound(begins.begin(), begins.end(), offset);
  const std::uint32_t begin = *(behind - 1);
  const std::size_t column =
      characters_before(document, offset) - characters_before(document, begin);
  return {static_cast<int>(behind - begins.begin()), static_cast<int>(column) + 1};
}

Document read_document(std::string file, std::string text, TermStore& store,
                       Diagnostics& problems) {
  WantedProblems all;
  return read_document(std::move(file), std::move(text), store, problems, all);
}

Document read_document(std::string file, std::string text, TermStore& store, Diagnostics& problems,
                       WantedProblems& wanted) {
  Document document;
  document.file = std::move(file);
  if (text.size() > kLargestText) {
    problems.add({document.file, 0, 0, "", "a text of more than 1 GiB", "a smaller file", ""});
    return document;
  }
  document.text = std::move(text);
  document.line_begins = line_begins_of(document.text);
  document.characters = characters_before_blocks(document.text);
  document.nodes.reserve(document.text.size() / kBytesPerNode);
  Diagnostics found;
  Scanner scanner(document, store, found, false);
  scanner.want(wanted.names);
  if (scanner.scan()) {
    wanted.passed_over.insert(wanted.passed_over.end(), scanner.passed_over().begin(),
                              scanner.passed_over().end());
  } else {
    found = {};
    document.nodes.clear();
    document.top.clear();
    document.depth = 0;
    Scanner(document, store, found, true).scan();
  }
  problems.append(found);
  return document;
}

std::vector<NodeIndex> children(const Document& document, NodeIndex list) {
  std::vector<NodeIndex> out;
  if (list == kNoNode || !document[list].list) return out;
  for (NodeIndex at = document[list].first_child; at != kNoNode; at = document[at].next) {
    out.push_back(at);
  }
  return out;
}

}  // namespace skein::htn
