// SPDX-License-Identifier: Apache-2.0
#include "ascii_grid.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>

namespace skein::geodata {
namespace {

constexpr std::size_t kLongestShown = 40;

/// Not NaN: GDAL reads it as 0 where the other values are whole, even where it is declared.
bool is_number(const std::string& word) {
  double value = 0;
  const char* first = word.data() + (word.front() == '+' ? 1 : 0);
  const char* last = word.data() + word.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return end == last && std::isfinite(value) &&
         (error == std::errc() || error == std::errc::result_out_of_range);
}

/// The words of a file, with the line that each stands in.
class Words {
 public:
  explicit Words(const std::string& path) : in_(path, std::ios::binary) {}
  bool next(std::string& word) {
    word.clear();
    for (int c = in_.get(); c != std::char_traits<char>::eof(); c = in_.get()) {
      const bool space = std::isspace(static_cast<unsigned char>(c)) != 0;
      if (space && !word.empty()) {
        in_.unget();
        return true;
      }
      if (c == '\n') ++line_;
      if (!space) word.push_back(static_cast<char>(c));
    }
    return !word.empty();
  }
  std::size_t line() const { return line_; }

 private:
  std::ifstream in_;
  std::size_t line_ = 1;
};

std::string lower(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// The figure of a key that says how many; 0 for another key.
std::size_t count_of(const std::string& key, const std::string& figure) {
  if (key != "ncols" && key != "nrows") return 0;
  std::size_t count = 0;
  std::from_chars(figure.data(), figure.data() + figure.size(), count);
  return count;
}

}  // namespace

std::optional<RasterProblem> problem_in_ascii_grid(const std::string& path) {
  Words words(path);
  std::string word, figure;
  std::size_t wanted = 1, values = 0;
  bool is_header = true;
  while (words.next(word)) {
    if (is_header && std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
        lower(word) != "nan") {
      if (!words.next(figure)) break;
      if (const std::size_t count = count_of(lower(word), figure); count > 0) wanted *= count;
      continue;
    }
    is_header = false;
    if (!is_number(word))
      return RasterProblem{"line " + std::to_string(words.line()) + ": '" +
                               word.substr(0, kLongestShown) + "' is no number",
                           "numbers after the header of an ASCII grid"};
    ++values;
  }
  if (values == wanted) return std::nullopt;
  return RasterProblem{
      std::to_string(values) + " values for ncols × nrows = " + std::to_string(wanted) + " cells",
      "as many numbers as cells"};
}

}  // namespace skein::geodata
