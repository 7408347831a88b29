// SPDX-License-Identifier: Apache-2.0
#include "skein/operate_tool/operate.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>

#include "for_all.hpp"
#include "skein/foundation/exit_code.hpp"
#include "station.hpp"
#include "teller.hpp"

namespace skein::operate_tool {

namespace {

using wire::CommandState;

constexpr double kAskAgain = 1;  // [s]

std::string user() {
  for (const char* name : {"SKEIN_OPERATOR", "USER", "LOGNAME"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return value;
  }
  return "operator";
}

std::uint64_t number_of_now() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(since_epoch).count());
}

int verdict(const wire::OperatorReply& reply, bool wait) {
  if (!reply.accepted || !reply.problems.empty()) return kExitNegative;
  const bool all_well =
      std::all_of(reply.commands.begin(), reply.commands.end(), [wait](const auto& one) {
        return one.state == CommandState::kAcknowledged || (!wait && !wire::is_settled(one.state));
      });
  return all_well ? kExitOk : kExitNegative;
}

int ask_and_tell(Station& station, const wire::OperatorRequest& request,
                 const OperateOptions& options, std::ostream& out, std::ostream& err) {
  Teller teller(out);
  const auto answer = [&] { return station.answer(request.who, request.number); };
  const auto is_over = [&] {
    const auto reply = answer();
    if (reply && !options.json) teller.tell(*reply);
    return reply && (reply->complete || !options.wait);
  };
  const int most = static_cast<int>(std::max(options.limit, options.station.patience) / kAskAgain);
  const int unheard = static_cast<int>(options.station.patience / kAskAgain);
  for (int tries = 0; tries <= most && !station.interrupted(); ++tries) {
    if (!answer()) station.ask(request);
    if (station.listen(kAskAgain, is_over) || (!answer() && tries >= unheard)) break;
  }
  const auto reply = answer();
  if (!reply) {
    err << "no ground station answers on domain " << options.station.domain << kWhichDomain << '\n';
    return kExitTimeout;
  }
  for (const std::string& problem : reply->problems) err << problem << '\n';
  if (options.json) out << wire::to_json(*reply) << '\n';
  if (options.wait && !reply->complete) {
    err << "some commands have not come to their end\n";
    return kExitTimeout;
  }
  return verdict(*reply, options.wait);
}

}  // namespace

int operate(const OperateOptions& options, std::ostream& out, std::ostream& err) {
  wire::OperatorRequest request;
  request.who = options.who.empty() ? user() : options.who;
  request.number = options.number == 0 ? number_of_now() : options.number;
  request.request = options.request;
  if (const auto problem = wire::find_violation(request)) {
    err << problem->field << ": " << problem->why << '\n';
    return kExitBadInput;
  }
  Station station(options.station);
  if (const auto opened = station.open(); !opened) {
    err << opened.error().why << '\n';
    return kExitSystem;
  }
  if (names_all(options.request)) {
    if (!station.listen(options.station.patience, [&] { return station.boards().complete(); })) {
      err << "no ground station is heard on domain " << options.station.domain << '\n';
      return kExitTimeout;
    }
    request.request = for_all(options.request, request.who, station.boards());
  }
  return ask_and_tell(station, request, options, out, err);
}

}  // namespace skein::operate_tool
