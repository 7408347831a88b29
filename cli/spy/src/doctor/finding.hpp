// SPDX-License-Identifier: Apache-2.0
// What the doctor says.
#pragma once

#include <string>
#include <vector>

namespace skein::spy_tool {

struct Finding {
  enum class Grade : std::uint8_t {
    kGood,
    kNote,  ///< worth knowing; may be meant
    kBad    ///< it will not work, or not as it should
  };
  Grade grade = Grade::kGood;
  std::string check;  ///< what was looked at: "multicast"
  std::string text;
};
using Findings = std::vector<Finding>;

}  // namespace skein::spy_tool
