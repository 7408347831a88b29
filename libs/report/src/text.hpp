// SPDX-License-Identifier: Apache-2.0
// Numbers and text in the form that the documents need.
#pragma once

#include <string>
#include <string_view>

namespace skein::report {

/// At most `decimals` decimals, without trailing zeros and without "-0"; "0" for a non-finite
/// value.
std::string short_number(double value, int decimals = 1);

/// Exactly `decimals` decimals: "12.0". A dash for a non-finite value.
std::string fixed_number(double value, int decimals);

/// A count with a thin space between thousands: "12 345".
std::string grouped(std::size_t value);

/// Minutes and seconds, with hours when there are any: "4:05", "1:00:07", "-0:10".
std::string clock_text(double seconds);

/// A length with its unit: "850 m", "12.4 km".
std::string length_text(double metres);

/// A span of time with its unit: "35 ms", "4.2 s", "12 min 05 s".
std::string span_text(double seconds);

/// The number of characters (code points) of UTF-8 text.
std::size_t character_count(std::string_view text);

/// At most `most` characters, the last of which is "…" when some were cut.
std::string shortened(std::string_view text, std::size_t most);

/// "1 task", "2 tasks".
std::string counted(std::size_t count, std::string_view noun);

}  // namespace skein::report
