// SPDX-License-Identifier: Apache-2.0
// Who may ask the console what.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace skein::console {

/// A request's first lines.
struct Asked {
  std::string method, path, host, origin, content_type, cookie, authorization;
  bool chunked = false;  ///< its length is not said beforehand
  std::uint64_t content_length = 0;
};

struct Verdict {
  unsigned status = 0;  ///< of HTTP; 0: it may go on
  std::string why;
  bool passes() const { return status == 0; }
};

/// Rules, in this order:
/// - Host is an address, localhost or a name that was configured, with this port: a page of another
///   name that was made to lead here (DNS rebinding) is refused, static files too;
/// - Origin, if there is one, is this host: a page from elsewhere cannot ask;
/// - what is written is written as JSON, of a length said beforehand, not beyond most_bytes();
/// - with a token: all but static files and the exchange of the token need it, by cookie or as
///   bearer; without one, a POST needs an Origin, or the header Authorization that no form sends.
class Gate {
 public:
  /// `token` empty: none is needed.
  Gate(std::uint16_t port, std::vector<std::string> names, std::string token);

  Verdict judge(const Asked& asked) const;
  bool is_token(std::string_view text) const;
  bool needs_token() const { return !token_.empty(); }
  /// Cookies do not tell ports apart: this one's name does.
  std::string cookie_name() const { return "skein-" + std::to_string(port_); }

 private:
  bool is_own_host(const std::string& host) const;
  bool has_token(const Asked& asked) const;
  Verdict judge_post(const Asked& asked) const;

  std::uint16_t port_;
  std::vector<std::string> names_;
  std::string token_;
};

}  // namespace skein::console
