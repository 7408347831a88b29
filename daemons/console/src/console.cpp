// SPDX-License-Identifier: Apache-2.0
#include "skein/console/console.hpp"

#include <array>
#include <charconv>
#include <deque>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>

#include "history.hpp"
#include "limits.hpp"
#include "request_body.hpp"
#include "server.hpp"

namespace skein::console {

namespace {

using Json = nlohmann::json;

/// Steady; how often the clock and what waits in the feed go out at most.
constexpr Duration kPeriod = Duration::milliseconds(100);

bool is_loopback(const std::string& address) { return address.starts_with("127."); }

std::string new_token() {
  std::random_device random;  // the system's, which cannot be foreseen
  std::string token;
  constexpr std::string_view kDigits = "0123456789abcdefghjkmnpqrstvwxyz";
  for (int i = 0; i < 26; ++i) token += kDigits[random() % kDigits.size()];
  return token;
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Posted refused(unsigned status, std::vector<std::string> problems) {
  return {status, dumped({{"problems", problems}})};
}

/// The page shows the way to it.
std::string with_designer(const std::string& world) {
  Json json = Json::parse(world, nullptr, false);
  if (!json.is_object()) return world;
  json["designer"] = true;
  return dumped(json);
}

}  // namespace

Result<void, Failure> read_address(std::string_view text, ConsoleConfig& config) {
  const std::size_t colon = text.find(':');
  const bool only_port = colon == std::string_view::npos && text.find('.') == text.npos;
  const std::string_view address = only_port ? "" : text.substr(0, colon);
  std::string_view port = only_port ? text : std::string_view();
  if (colon != std::string_view::npos) port = text.substr(colon + 1);
  if (!address.empty()) config.address = address == "localhost" ? "127.0.0.1" : address;
  if (port.empty()) return {};
  const auto [end, error] = std::from_chars(port.begin(), port.end(), config.port);
  if (error == std::errc() && end == port.end()) return {};
  return failure("'" + std::string(text) + "': expected ADDRESS:PORT, with a port from 0 to 65535");
}

class Console::Impl {
 public:
  explicit Impl(ConsoleConfig config) : config_(std::move(config)) {
    if (!is_loopback(config_.address)) token_ = new_token();
  }

  Result<void, Failure> open() {
    if (config_.annex != nullptr) config_.world = with_designer(config_.world);
    auto server = Server::open(
        {config_.address, config_.port, config_.names, token_, config_.world, config_.annex}, feed_,
        [this](const std::string& body) { return post(body); });
    if (!server) return tl::unexpected(server.error());
    server_ = std::move(*server);
    return {};
  }

  std::uint16_t port() const { return server_->port(); }
  std::string url() const {
    const std::string host = config_.address == "0.0.0.0" ? "localhost" : config_.address;
    const std::string url = "http://" + host + ":" + std::to_string(port()) + "/" + config_.start;
    return token_.empty() ? url : url + "#token=" + token_;
  }

  void attach(std::function<void()> wake) {
    const std::lock_guard lock(requests_mutex_);
    wake_ = std::move(wake);
  }

  std::vector<wire::Sample> take() {
    const std::lock_guard lock(requests_mutex_);
    std::vector<wire::Sample> samples;
    for (wire::OperatorRequest& one : requests_) samples.emplace_back(std::move(one));
    requests_.clear();
    return samples;
  }

  void begin_again() {
    const std::lock_guard lock(feed_.mutex);
    history_ = {};
    feed_.feed.begin_again("{\"again\":true}");
  }

  void sees(const wire::Sample& sample) {
    auto more = config_.explain ? config_.explain(sample) : decltype(config_.explain(sample))();
    const std::lock_guard lock(feed_.mutex);
    history_.take(sample, feed_.feed);
    for (auto& [key, json] : more) feed_.feed.set(key, std::move(json));
  }
  void sees(const journal::Record& record) {
    const std::lock_guard lock(feed_.mutex);
    history_.take(record, feed_.feed);
  }

  void turn(const node::DaemonState& state) {
    if (told_ && state.now.steady < *told_ + kPeriod) return;
    told_ = state.now.steady;
    {
      const std::lock_guard lock(feed_.mutex);
      const Json clock{{"slot", "Clock"},
                       {"time", state.now.mission.count()},
                       {"rate", state.rate},
                       {"phase", wire::name_of(state.phase)}};
      feed_.feed.set("clock", dumped(clock));
    }
    server_->news();
  }

 private:
  Posted post(const std::string& body) {
    auto request = request_of(body);
    if (!request) return refused(400, request.error());
    const Json accepted{{"who", request->who}, {"number", request->number}};
    const std::lock_guard lock(requests_mutex_);
    if (!wake_) return refused(503, {"the mission is over"});
    if (requests_.size() >= kRequestsWaiting) return refused(503, {"too many requests at once"});
    requests_.push_back(std::move(*request));
    wake_();
    return {202, dumped(accepted)};
  }

  ConsoleConfig config_;
  std::string token_;
  SharedFeed feed_;
  History history_;
  std::mutex requests_mutex_;
  std::deque<wire::OperatorRequest> requests_;
  std::function<void()> wake_;
  std::optional<Duration> told_;
  std::unique_ptr<Server> server_;  // last: it ends before what it uses
};

Console::Console(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Console::~Console() = default;

Result<std::unique_ptr<Console>, Failure> Console::open(ConsoleConfig config) {
  auto impl = std::make_unique<Impl>(std::move(config));
  if (auto opened = impl->open(); !opened) return tl::unexpected(opened.error());
  return std::unique_ptr<Console>(new Console(std::move(impl)));
}

std::uint16_t Console::port() const { return impl_->port(); }
std::string Console::url() const { return impl_->url(); }
void Console::begin_again() { impl_->begin_again(); }
void Console::attach(std::function<void()> wake) { impl_->attach(std::move(wake)); }
void Console::detach() { impl_->attach({}); }
std::vector<wire::Sample> Console::take() { return impl_->take(); }
void Console::sees(const wire::Sample& sample) { impl_->sees(sample); }
void Console::sees(const journal::Record& record) { impl_->sees(record); }
void Console::turn(const node::DaemonState& state) { impl_->turn(state); }

}  // namespace skein::console
