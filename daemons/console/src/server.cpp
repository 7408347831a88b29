// SPDX-License-Identifier: Apache-2.0
#include "server.hpp"

#include <arpa/inet.h>
#include <microhttpd.h>
#include <netinet/in.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "assets.hpp"
#include "limits.hpp"

namespace skein::console {

namespace {

using Json = nlohmann::json;

constexpr const char* kJson = "application/json";
constexpr const char* kPolicy =
    "default-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

/// A response, given up when it has been queued.
class Response {
 public:
  Response(std::string_view body, const char* type)
      : response_(MHD_create_response_from_buffer(
            body.size(), const_cast<char*>(body.data()),  // NOLINT: it is copied
            MHD_RESPMEM_MUST_COPY)) {
    header("Content-Type", type);
  }
  explicit Response(MHD_Response* response) : response_(response) {}
  Response(const Response&) = delete;
  Response& operator=(const Response&) = delete;
  ~Response() { MHD_destroy_response(response_); }

  void header(const char* name, const std::string& value) {
    MHD_add_response_header(response_, name, value.c_str());
  }
  int queue(MHD_Connection* connection, unsigned status) {
    header("Cache-Control", "no-store");
    header("Content-Security-Policy", kPolicy);
    header("X-Frame-Options", "DENY");
    header("X-Content-Type-Options", "nosniff");
    header("Referrer-Policy", "no-referrer");
    return MHD_queue_response(connection, status, response_);
  }

 private:
  MHD_Response* response_;
};

int reply(MHD_Connection* connection, unsigned status, const std::string& json) {
  return Response(json, kJson).queue(connection, status);
}

std::string problem(const std::string& why) {
  return Json{{"problems", {why}}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string header_of(MHD_Connection* connection, const char* name) {
  const char* value = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name);
  return value == nullptr ? "" : value;
}

std::uint64_t length_of(const std::string& text) {
  if (text.empty()) return 0;
  const bool is_number =
      text.size() <= 12 && text.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? std::stoull(text) : std::numeric_limits<std::uint64_t>::max();
}

Asked asked_by(MHD_Connection* connection, const char* method, const char* path) {
  Asked asked;
  asked.method = method;
  asked.path = path;
  asked.host = header_of(connection, MHD_HTTP_HEADER_HOST);
  asked.origin = header_of(connection, MHD_HTTP_HEADER_ORIGIN);
  asked.content_type = header_of(connection, MHD_HTTP_HEADER_CONTENT_TYPE);
  asked.cookie = header_of(connection, MHD_HTTP_HEADER_COOKIE);
  asked.authorization = header_of(connection, MHD_HTTP_HEADER_AUTHORIZATION);
  asked.chunked = !header_of(connection, MHD_HTTP_HEADER_TRANSFER_ENCODING).empty();
  asked.content_length = length_of(header_of(connection, MHD_HTTP_HEADER_CONTENT_LENGTH));
  return asked;
}

}  // namespace

struct Server::Stream {
  Server* server = nullptr;
  MHD_Connection* connection = nullptr;
  std::uint64_t cursor = 0;
  std::string text;  ///< taken from the feed, not yet written
  std::size_t written = 0;
  bool waits = false;
};

struct Server::Call {
  std::string method, path;
  Verdict verdict;
  std::string body;
};

namespace {

// The functions that microhttpd calls.

const MHD_AccessHandlerCallback kOnRequest = [](void* server, MHD_Connection* connection,
                                                const char* url, const char* method, const char*,
                                                const char* data, std::size_t* size, void** state) {
  auto* call = static_cast<Server::Call*>(*state);
  if (call == nullptr) {
    call = Server::begin(*static_cast<Server*>(server), connection, method, url);
    *state = call;
    if (Server::goes_on(*call)) return MHD_YES;
    // What is refused is so before its body is read.
  } else if (*size > 0) {
    Server::gather(*call, {data, *size});
    *size = 0;
    return MHD_YES;
  }
  return static_cast<Server*>(server)->answer(connection, *call) == MHD_YES ? MHD_YES : MHD_NO;
};

void on_completed(void*, MHD_Connection*, void** state, MHD_RequestTerminationCode) {
  Server::end(static_cast<Server::Call*>(*state));
  *state = nullptr;
}

ssize_t on_read(void* state, std::uint64_t, char* buffer, std::size_t most) {
  auto* stream = static_cast<Server::Stream*>(state);
  return Server::read(*stream, buffer, most);
}

void on_stream_end(void* state) { Server::end(static_cast<Server::Stream*>(state)); }

}  // namespace

Server::Call* Server::begin(const Server& server, MHD_Connection* connection, const char* method,
                            const char* path) {
  auto call = std::make_unique<Call>();
  call->method = method;
  call->path = path;
  call->verdict = server.gate_->judge(asked_by(connection, method, path));
  return call.release();
}

bool Server::goes_on(const Call& call) { return call.verdict.passes(); }

void Server::gather(Call& call, std::string_view piece) {
  if (!call.verdict.passes()) return;
  if (call.body.size() + piece.size() > most_bytes(call.path)) {
    call.verdict = {413, "the request is too long"};
    call.body.clear();
  } else {
    call.body += piece;
  }
}

void Server::end(Call* call) { delete call; }  // NOLINT: microhttpd kept it

long Server::read(Stream& stream, char* buffer, std::size_t most) {
  return stream.server->read_stream(stream, buffer, most);
}

void Server::end(Stream* stream) { stream->server->end_stream(stream); }

Server::Server(ServerConfig config, SharedFeed& feed, Post post)
    : config_(std::move(config)), feed_(feed), post_(std::move(post)) {}

Result<std::unique_ptr<Server>, Failure> Server::open(ServerConfig config, SharedFeed& feed,
                                                      Post post) {
  std::unique_ptr<Server> server(new Server(std::move(config), feed, std::move(post)));
  if (auto listens = server->listen(); !listens) return tl::unexpected(listens.error());
  return server;
}

Result<void, Failure> Server::listen() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(config_.port);
  if (inet_pton(AF_INET, config_.address.c_str(), &address.sin_addr) != 1) {
    return failure("'" + config_.address + "' is no IPv4 address");
  }
  // The gate knows the port, which may be chosen by the system: nothing is asked before it is
  // there.
  gate_ = std::make_unique<Gate>(config_.port, config_.names, config_.token);
  daemon_ = MHD_start_daemon(MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME | MHD_USE_ITC,
                             config_.port, nullptr, nullptr, kOnRequest, this, MHD_OPTION_SOCK_ADDR,
                             &address, MHD_OPTION_NOTIFY_COMPLETED, &on_completed, nullptr,
                             MHD_OPTION_CONNECTION_LIMIT, kConnections,
                             MHD_OPTION_PER_IP_CONNECTION_LIMIT, kConnectionsOfOneAddress,
                             MHD_OPTION_CONNECTION_TIMEOUT, kSecondsOfSilence, MHD_OPTION_END);
  if (daemon_ == nullptr) {
    return failure("the console cannot listen at " + config_.address + ":" +
                   std::to_string(config_.port) + ": " + std::strerror(errno));
  }
  const MHD_DaemonInfo* info = MHD_get_daemon_info(daemon_, MHD_DAEMON_INFO_BIND_PORT);
  port_ = info == nullptr ? config_.port : info->port;
  if (port_ != config_.port) {
    gate_ = std::make_unique<Gate>(port_, config_.names, config_.token);
  }
  return {};
}

Server::~Server() {
  {
    const std::lock_guard lock(streams_mutex_);
    closing_ = true;
  }
  news();
  if (daemon_ != nullptr) MHD_stop_daemon(daemon_);
}

void Server::news() {
  const std::lock_guard lock(streams_mutex_);
  for (Stream* stream : streams_) {
    if (std::exchange(stream->waits, false)) MHD_resume_connection(stream->connection);
  }
}

int Server::answer(MHD_Connection* connection, Call& call) {
  if (!call.verdict.passes()) {
    return reply(connection, call.verdict.status, problem(call.verdict.why));
  }
  if (call.path.starts_with(kAnnexPaths)) return ask_annex(connection, call);
  if (call.method == "POST") {
    if (call.path == "/api/session") return open_session(connection, call.body);
    if (call.path != "/api/request") return reply(connection, 404, problem("nothing is here"));
    const Posted posted = post_(call.body);
    return reply(connection, posted.status, posted.json);
  }
  if (call.path == "/api/events") return serve_stream(connection);
  if (call.path == "/api/world") return reply(connection, 200, config_.world);
  return serve_file(connection, call.path);
}

int Server::ask_annex(MHD_Connection* connection, const Call& call) {
  if (config_.annex == nullptr) return reply(connection, 404, problem("nothing is here"));
  const Answer answer = config_.annex->answer(call.method, call.path, call.body);
  return reply(connection, answer.status, answer.json);
}

int Server::serve_file(MHD_Connection* connection, const std::string& path) {
  const Asset* asset = find_asset(path);
  if (asset == nullptr) return reply(connection, 404, problem("nothing is here"));
  return Response(asset->bytes, std::string(asset->type).c_str()).queue(connection, 200);
}

int Server::open_session(MHD_Connection* connection, const std::string& body) {
  const Json said = Json::parse(body, nullptr, false);
  const bool has_token = said.is_object() && said.contains("token") && said["token"].is_string();
  if (!gate_->needs_token()) return reply(connection, 200, "{}");
  if (!has_token || !gate_->is_token(said["token"].get<std::string>())) {
    return reply(connection, 401, problem("that is not the token"));
  }
  Response response("{}", kJson);
  response.header("Set-Cookie", gate_->cookie_name() + "=" + config_.token +
                                    "; HttpOnly; SameSite=Strict; Path=/");
  return response.queue(connection, 200);
}

int Server::serve_stream(MHD_Connection* connection) {
  auto stream = std::make_unique<Stream>();
  stream->server = this;
  stream->connection = connection;
  stream->text = "retry: 1000\n\nevent: hello\ndata: {}\n\n";
  {
    const std::lock_guard lock(streams_mutex_);
    if (streams_.size() >= kStreams) return reply(connection, 503, problem("too many streams"));
    streams_.insert(stream.get());
  }
  Response response(MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, 16'384, &on_read,
                                                      stream.release(), &on_stream_end));
  response.header("Content-Type", "text/event-stream");
  return response.queue(connection, 200);
}

// Nothing to write: the connection sleeps until there are news. Whether there are is looked at
// under the same mutex that news() takes, so that none comes in between.
long Server::read_stream(Stream& stream, char* buffer, std::size_t most) {
  if (stream.written == stream.text.size()) {
    const std::lock_guard lock(streams_mutex_);
    if (closing_) return MHD_CONTENT_READER_END_OF_STREAM;
    const std::lock_guard feed_lock(feed_.mutex);
    stream.text = feed_.feed.take(stream.cursor, kChunk);
    stream.written = 0;
    if (stream.text.empty()) {
      stream.waits = true;
      MHD_suspend_connection(stream.connection);
      return 0;
    }
  }
  const std::size_t size = std::min(most, stream.text.size() - stream.written);
  std::memcpy(buffer, stream.text.data() + stream.written, size);
  stream.written += size;
  return static_cast<long>(size);
}

void Server::end_stream(Stream* stream) {
  const std::lock_guard lock(streams_mutex_);
  streams_.erase(stream);
  delete stream;  // NOLINT: microhttpd kept it
}

}  // namespace skein::console
