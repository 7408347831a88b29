// SPDX-License-Identifier: Apache-2.0
// HTTP around the feed: files, server-sent events, requests.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "feed.hpp"
#include "gate.hpp"
#include "skein/console/annex.hpp"
#include "skein/foundation/result.hpp"

struct MHD_Connection;
struct MHD_Daemon;

namespace skein::console {

/// The feed and the mutex that guards it.
struct SharedFeed {
  std::mutex mutex;
  Feed feed;
};

struct ServerConfig {
  std::string address;
  std::uint16_t port = 0;
  std::vector<std::string> names;
  std::string token;  ///< empty: none is needed
  std::string world;
  std::shared_ptr<Annex> annex = {};
};

/// An answer to a request of an operator.
struct Posted {
  unsigned status = 202;
  std::string json;
};

/// Thread rule: `news` may be called from any thread; `post` is called from the server's own.
class Server {
 public:
  using Post = std::function<Posted(const std::string& body)>;

  static Result<std::unique_ptr<Server>, Failure> open(ServerConfig config, SharedFeed& feed,
                                                       Post post);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const { return port_; }
  /// Notifies waiting streams of new entries in the feed.
  void news();

  struct Stream;
  struct Call;  ///< one request under way

  // For the functions that microhttpd calls.
  static Call* begin(const Server& server, MHD_Connection* connection, const char* method,
                     const char* path);
  static bool goes_on(const Call& call);
  static void gather(Call& call, std::string_view piece);
  static void end(Call* call);
  static long read(Stream& stream, char* buffer, std::size_t most);
  static void end(Stream* stream);
  int answer(MHD_Connection* connection, Call& call);

 private:
  long read_stream(Stream& stream, char* buffer, std::size_t most);
  void end_stream(Stream* stream);
  Server(ServerConfig config, SharedFeed& feed, Post post);
  Result<void, Failure> listen();
  int serve_file(MHD_Connection* connection, const std::string& path);
  int serve_stream(MHD_Connection* connection);
  int ask_annex(MHD_Connection* connection, const Call& call);
  int open_session(MHD_Connection* connection, const std::string& body);

  ServerConfig config_;
  SharedFeed& feed_;
  Post post_;
  std::uint16_t port_ = 0;
  std::unique_ptr<Gate> gate_;
  MHD_Daemon* daemon_ = nullptr;
  std::mutex streams_mutex_;
  std::set<Stream*> streams_;
  bool closing_ = false;
};

}  // namespace skein::console
