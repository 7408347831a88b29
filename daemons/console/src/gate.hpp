// SPDX-License-Identifier: Apache-2.0
// Access control of the console.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace skein::console {

/// Request line and headers of a request.
struct Asked {
  std::string method, path, host, origin, content_type, cookie, authorization;
  bool chunked = false;  ///< the length of the body is not declared
  std::uint64_t content_length = 0;
};

struct Verdict {
  unsigned status = 0;  ///< HTTP status of the refusal; 0: admitted
  std::string why;
  bool passes() const { return status == 0; }
};

/// Rules, in this order:
/// - Host must be an address, localhost or a configured name, with this port: requests through a
///   foreign name (DNS rebinding) are refused, also for static files;
/// - Origin, if present, must be this host: pages of other sites are refused;
/// - bodies must be JSON, with a declared length of at most most_bytes();
/// - with a token: everything except static files and the exchange of the token needs it, by cookie
///   or as bearer; without one, a POST needs an Origin, or the header Authorization, which no form
///   sends.
class Gate {
 public:
  /// `token` empty: none is needed.
  Gate(std::uint16_t port, std::vector<std::string> names, std::string token);

  Verdict judge(const Asked& asked) const;
  bool is_token(std::string_view text) const;
  bool needs_token() const { return !token_.empty(); }
  /// Name of the cookie; it contains the port, since cookies do not distinguish ports.
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
