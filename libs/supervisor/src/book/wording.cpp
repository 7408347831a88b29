// SPDX-License-Identifier: Apache-2.0
#include "book/wording.hpp"

#include <cctype>
#include <charconv>

namespace skein::supervisor {

namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string in_words(const mission::ElementaryTask& task) {
  return "the " + task.type + " of goal " + to_text(task.origin);
}

std::string with_names(const std::string& text, const std::string& word,
                       const std::function<std::string(std::uint64_t)>& name) {
  const std::string head = word + " ";
  std::string result;
  std::size_t at = 0;
  for (auto found = text.find(head); found != std::string::npos; found = text.find(head, at)) {
    const std::size_t digits = found + head.size();
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + digits, end, number);
    const bool whole = found == 0 || !is_letter(text[found - 1]);
    const bool is_number = read.ec == std::errc() && (read.ptr == end || !is_letter(*read.ptr));
    const std::string named = whole && is_number ? name(number) : "";
    const bool has_it = text.compare(found, named.size(), named) == 0;
    const std::size_t after =
        has_it ? found + named.size() : static_cast<std::size_t>(read.ptr - text.data());
    const std::size_t next = named.empty() ? digits : after;
    result += text.substr(at, found - at);
    result += named.empty() ? text.substr(found, next - found) : named;
    at = next;
  }
  return result + text.substr(at);
}

}  // namespace skein::supervisor
