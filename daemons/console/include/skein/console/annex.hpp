// SPDX-License-Identifier: Apache-2.0
// Something that the page can do beside what is about the mission.
#pragma once

#include <string>

namespace skein::console {

/// What is said to a request.
struct Answer {
  unsigned status = 200;  ///< of HTTP
  std::string json;
};

/// Answers what is asked below "/api/designer/", once the gate has let it pass. Thread rule: called
/// from the server's thread, one request after the other; while it reckons nothing else is served.
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
