// SPDX-License-Identifier: Apache-2.0
#include "idl_text.hpp"

#include <map>
#include <set>
#include <vector>

namespace skein::spy_tool {

namespace {

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string without_comments(std::string_view idl) {
  std::string text;
  for (std::size_t i = 0; i < idl.size(); ++i) {
    if (idl.substr(i, 2) == "//") i = std::min(idl.find('\n', i), idl.size() - 1);
    text += idl[i];
  }
  return text;
}

std::set<std::string> words_of(std::string_view text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text) {
    if (is_word(c)) {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, ""));
    }
  }
  return words;
}

struct Definition {
  std::string name, text;
};

/// Structs and enumerations in the order of the text, with the annotation before a struct.
std::vector<Definition> definitions_of(const std::string& text) {
  std::vector<Definition> all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t of_struct = text.find("struct ", at), of_enum = text.find("enum ", at);
    const std::size_t begin = std::min(of_struct, of_enum);
    const std::size_t end = begin == std::string::npos ? begin : text.find("};", begin);
    if (end == std::string::npos) break;
    const std::size_t name = text.find(' ', begin) + 1;
    const std::size_t stop = text.find_first_of(" {\n", name);
    all.push_back({text.substr(name, stop - name),
                   (begin == of_struct ? "@final\n" : "") + text.substr(begin, end + 2 - begin)});
    at = end + 2;
  }
  return all;
}

}  // namespace

std::string idl_of(std::string_view type, std::string_view idl) {
  const std::vector<Definition> all = definitions_of(without_comments(idl));
  std::set<std::string> wanted{std::string(type)};
  std::vector<const Definition*> found;
  // What is used is defined before: from the last one back everything wanted is known in time.
  for (auto one = all.rbegin(); one != all.rend(); ++one) {
    if (!wanted.contains(one->name)) continue;
    found.push_back(&*one);
    wanted.merge(words_of(one->text));
  }
  if (found.empty() || found.front()->name != type) return "";
  std::string text = "module skein {\nmodule idl {\n";
  for (auto one = found.rbegin(); one != found.rend(); ++one) text += "\n" + (*one)->text + "\n";
  return text + "\n};\n};\n";
}

}  // namespace skein::spy_tool
