// SPDX-License-Identifier: Apache-2.0
// Extension of the page's server beyond the mission (the designer).
#pragma once

#include <string>

namespace skein::console {

/// An answer to a request.
struct Answer {
  unsigned status = 200;  ///< of HTTP
  std::string json;
};

/// Answers requests below "/api/designer/" that the gate has admitted. Thread rule: called from the
/// server's thread, one request after the other; nothing else is served meanwhile.
class Annex {
 public:
  Annex() = default;
  Annex(const Annex&) = delete;
  Annex& operator=(const Annex&) = delete;
  virtual ~Annex() = default;

  virtual Answer answer(const std::string& method, const std::string& path,
                        const std::string& body) = 0;
};

}  // namespace skein::console
