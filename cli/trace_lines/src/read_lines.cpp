// SPDX-License-Identifier: Apache-2.0
#include "skein/trace_lines/read_lines.hpp"

#include <istream>
#include <ostream>

namespace skein::trace_lines {

namespace {

constexpr std::size_t kLongestLine = 1 << 20;  // [bytes]

enum class Got { kLine, kTooLong, kEnd, kFailed };

// A line of any length is read; of one that is too long only the beginning is kept. What cannot be
// read (a directory) shows as an exception of the stream buffer.
Got get_line(std::istream& in, std::string& line) {
  using Traits = std::char_traits<char>;
  line.clear();
  std::size_t length = 0;
  try {
    std::streambuf* buffer = in.rdbuf();
    int c = buffer->sbumpc();
    if (c == Traits::eof()) return Got::kEnd;
    for (; c != Traits::eof() && c != '\n'; c = buffer->sbumpc()) {
      if (++length <= kLongestLine) line.push_back(Traits::to_char_type(c));
    }
  } catch (const std::ios_base::failure&) {
    return Got::kFailed;
  }
  return length > kLongestLine ? Got::kTooLong : Got::kLine;
}

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

bool read_lines(std::istream& in, std::ostream& out,
                const std::function<void(std::size_t, const std::string&)>& line,
                const std::function<void(std::size_t, const std::string&)>& wrong) {
  std::string text;
  std::size_t number = 0;
  Got got = get_line(in, text);
  for (; got == Got::kLine || got == Got::kTooLong; got = get_line(in, text)) {
    ++number;
    if (got == Got::kTooLong) {
      wrong(number, "longer than " + std::to_string(kLongestLine) + " bytes");
    } else if (!is_blank(text)) {
      line(number, text);
    }
    if (in.rdbuf()->in_avail() <= 0) out.flush();
  }
  return got == Got::kEnd;
}

}  // namespace skein::trace_lines
