// SPDX-License-Identifier: Apache-2.0
// The lines of a trace, one by one, as they come.
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>

namespace skein::trace_lines {

/// Until the end of `in`: `line` gets each line that is not blank with its number from 1, `wrong`
/// those over 1 MiB and why. `out` is flushed whenever no further line waits, so that a program at
/// the other end gets its answer. False if the input cannot be read to its end.
bool read_lines(std::istream& in, std::ostream& out,
                const std::function<void(std::size_t, const std::string&)>& line,
                const std::function<void(std::size_t, const std::string&)>& wrong);

}  // namespace skein::trace_lines
