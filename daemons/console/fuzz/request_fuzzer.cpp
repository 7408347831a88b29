// SPDX-License-Identifier: Apache-2.0
// Whatever a browser or another program posts: the gate has an answer, and a body is a request that
// may go over the wire, or is refused with every reason. The lines before an empty one are the
// request's line and headers in the order of Asked, what follows is its body.
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "gate.hpp"
#include "request_body.hpp"
#include "skein/blackboard/wire.hpp"

namespace {

using namespace skein::console;  // NOLINT(google-build-using-namespace): what is fuzzed

void require(bool condition) {
  if (!condition) std::abort();
}

Asked asked_in(std::istream& in) {
  Asked asked;
  for (std::string* const one : {&asked.method, &asked.path, &asked.host, &asked.origin,
                                 &asked.content_type, &asked.cookie, &asked.authorization}) {
    if (!std::getline(in, *one) || one->empty()) break;
  }
  return asked;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Gate kOpen(8080, {"station.lan"}, ""), kClosed(8080, {}, "sesame");
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  Asked asked = asked_in(in);
  const std::string body{std::istreambuf_iterator<char>(in), {}};
  asked.content_length = body.size();
  for (const Gate* gate : {&kOpen, &kClosed}) {
    const Verdict verdict = gate->judge(asked);
    require(verdict.passes() || !verdict.why.empty());
  }
  const auto request = request_of(body);
  require(request.has_value() || !request.error().empty());
  require(!request || !skein::wire::find_violation(*request));
  return 0;
}
