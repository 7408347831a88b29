// SPDX-License-Identifier: Apache-2.0
// Findings of the doctor.
#pragma once

#include <string>
#include <vector>

namespace skein::spy_tool {

struct Finding {
  enum class Grade : std::uint8_t {
    kGood,
    kNote,  ///< worth knowing; may be intended
    kBad    ///< communication will fail, or not work as it should
  };
  Grade grade = Grade::kGood;
  std::string check;  ///< name of the check: "multicast"
  std::string text;
};
using Findings = std::vector<Finding>;

}  // namespace skein::spy_tool
