// SPDX-License-Identifier: Apache-2.0
// The console's server by its sockets: what browsers, and who is none, may do to it.
#include "skein/console/console.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>

namespace skein::console {
namespace {

using Json = nlohmann::json;

/// A connection to the console.
class Line {
 public:
  explicit Line(std::uint16_t port, const char* from = "127.0.0.1")
      : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in self{};
    self.sin_family = AF_INET;
    inet_pton(AF_INET, from, &self.sin_addr);
    bind(socket_, reinterpret_cast<sockaddr*>(&self), sizeof(self));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    timeval limit{10, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
    open_ = connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line() { close(socket_); }

  bool say(const std::string& text) const {
    return open_ && send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
                        static_cast<ssize_t>(text.size());
  }
  /// What comes until `wanted` is in it, or nothing more comes.
  std::string hear(const std::string& wanted) {
    std::array<char, 4096> piece{};
    std::size_t looked = 0;  // at what was heard before this, but for an end of it
    while (heard_.find(wanted, looked) == std::string::npos) {
      looked = heard_.size() - std::min(heard_.size(), wanted.size());
      const ssize_t size = recv(socket_, piece.data(), piece.size(), 0);
      if (size <= 0) break;
      heard_.append(piece.data(), static_cast<std::size_t>(size));
    }
    return heard_;
  }

 private:
  int socket_;
  bool open_ = false;
  std::string heard_;
};

class ConsoleTest : public ::testing::Test {
 protected:
  ConsoleTest() {
    ConsoleConfig config;
    config.port = 0;
    config.world = R"({"scenario":"test"})";
    auto opened = Console::open(std::move(config));
    if (!opened) ADD_FAILURE() << opened.error().why;
    console_ = std::move(*opened);
    console_->attach([this] { ++woken_; });
  }

  std::string host() const { return "127.0.0.1:" + std::to_string(console_->port()); }
  std::string get(const std::string& path) const {
    return "GET " + path + " HTTP/1.1\r\nHost: " + host() + "\r\nConnection: close\r\n\r\n";
  }
  std::string post(const std::string& body, const std::string& more = "") const {
    return "POST /api/request HTTP/1.1\r\nHost: " + host() + "\r\nOrigin: http://" + host() +
           "\r\nContent-Type: application/json\r\nConnection: close\r\nContent-Length: " +
           std::to_string(body.size()) + "\r\n" + more + "\r\n" + body;
  }
  std::string answer(const std::string& request) const {
    Line line(console_->port());
    EXPECT_TRUE(line.say(request));
    return line.hear("that never comes");
  }
  static wire::UavBoard board(const std::string& uav) {
    wire::UavBoard board;
    board.header.origin = 1;
    board.header.instance = 10;
    board.uav = uav;
    return board;
  }
  /// A turn of the daemon's loop, later than the one before.
  void turn() {
    steady_ = steady_ + Duration::milliseconds(200);
    console_->turn({{MissionTime() + steady_, steady_}, 1, wire::ClockPhase::kRunning});
  }

  std::unique_ptr<Console> console_;
  std::atomic<int> woken_ = 0;
  Duration steady_;
};

TEST_F(ConsoleTest, ServesThePageWithAPolicyThatLetsNothingElseIn) {
  const std::string page = answer(get("/"));

  EXPECT_NE(page.find("200 OK"), std::string::npos);
  EXPECT_NE(page.find("<title>Skein</title>"), std::string::npos);
  EXPECT_NE(page.find("Content-Security-Policy: default-src 'self'"), std::string::npos);
  EXPECT_NE(answer(get("/app.js")).find("text/javascript"), std::string::npos);
  EXPECT_NE(answer(get("/api/world")).find(R"({"scenario":"test"})"), std::string::npos);
  EXPECT_NE(answer(get("/etc/passwd")).find("404"), std::string::npos);
  EXPECT_NE(answer(get("/../src/server.cpp")).find("404"), std::string::npos);
}

TEST_F(ConsoleTest, TellsWhoComesLateWhatIsSo) {
  console_->sees(wire::Sample(board("marvin")));
  console_->sees(journal::Record({}, "ground", "phase").with("name", "Going"));
  turn();
  Line line(console_->port());
  line.say(get("/api/events"));

  EXPECT_NE(line.hear("Going").find(R"("uav":"marvin")"), std::string::npos);
}

TEST_F(ConsoleTest, TellsWhatComesWhileABrowserListens) {
  Line line(console_->port());
  line.say(get("/api/events"));
  line.hear("hello");

  console_->sees(wire::Sample(board("heliv")));
  turn();

  EXPECT_NE(line.hear("heliv").find(R"("slot":"UavBoard")"), std::string::npos);
}

TEST_F(ConsoleTest, HandsARequestToItsNodeAndWakesIt) {
  const std::string said = answer(
      post(R"({"who": "ada", "number": 7, "actions": [{"take_in_hand": {"uav": "marvin"}}]})"));

  EXPECT_NE(said.find("202"), std::string::npos) << said;
  EXPECT_EQ(woken_, 1);
  const std::vector<wire::Sample> samples = console_->take();
  ASSERT_EQ(samples.size(), 1U);
  const auto& request = std::get<wire::OperatorRequest>(samples[0]);
  EXPECT_EQ(request.who, "ada");
  EXPECT_EQ(request.number, 7U);
  EXPECT_EQ(request.request, R"([{"take_in_hand":{"uav":"marvin"}}])");
  EXPECT_TRUE(console_->take().empty());
}

TEST_F(ConsoleTest, RefusesWhatIsNoRequestWithEveryProblem) {
  const std::string said = answer(post(R"({"number": -1})"));
  EXPECT_NE(said.find("400"), std::string::npos);
  for (const char* problem : {"who: ", "number: ", "actions: "}) {
    EXPECT_NE(said.find(problem), std::string::npos) << problem;
  }
  for (const std::string& body :
       {std::string(), std::string("[]"), std::string("{{{"), std::string(60'000, '['),
        std::string("{\"who\":\"\xff\",\"number\":1,\"actions\":[]}")}) {
    EXPECT_NE(answer(post(body)).find("400"), std::string::npos) << body.substr(0, 20);
  }
  EXPECT_TRUE(console_->take().empty());
}

TEST_F(ConsoleTest, RefusesWhatIsTooLongBeforeItIsThere) {
  const std::string head = "POST /api/request HTTP/1.1\r\nHost: " + host() + "\r\nOrigin: http://" +
                           host() + "\r\nContent-Type: application/json\r\n";
  Line declared(console_->port());
  declared.say(head + "Content-Length: 300000000\r\n\r\n" + std::string(10'000, 'x'));
  EXPECT_NE(declared.hear("413").find("413"), std::string::npos);
  Line chunked(console_->port());
  chunked.say(head + "Transfer-Encoding: chunked\r\n\r\n5\r\nabcde\r\n0\r\n\r\n");
  EXPECT_NE(chunked.hear("411").find("411"), std::string::npos);
}

TEST_F(ConsoleTest, RefusesARequestOfAPageFromElsewhereAndAnotherName) {
  const std::string foreign =
      "POST /api/request HTTP/1.1\r\nHost: " + host() +
      "\r\nOrigin: http://evil.example\r\nContent-Type: application/json\r\n"
      "Connection: close\r\nContent-Length: 2\r\n\r\n{}";
  EXPECT_NE(answer(foreign).find("403"), std::string::npos);
  const std::string rebound =
      "GET / HTTP/1.1\r\nHost: evil.example:80\r\nConnection: close\r\n\r\n";
  EXPECT_NE(answer(rebound).find("421"), std::string::npos);
}

TEST_F(ConsoleTest, LivesOnThroughGarbageAndMoreConnectionsThanItTakes) {
  std::vector<std::unique_ptr<Line>> lines;
  for (int i = 0; i < 400; ++i) {
    lines.push_back(std::make_unique<Line>(console_->port()));
    lines.back()->say(i % 2 == 0 ? "GET /api/events HTTP/1.1\r\nHost: " + host() + "\r\n\r\n"
                                 : std::string("\x16\x03\x01garbage\r\n\r\n"));
  }
  lines.clear();

  // Connections are let go of soon after they were closed.
  std::string page;
  for (int tries = 0; tries < 50 && page.find("200 OK") == std::string::npos; ++tries) {
    turn();
    Line line(console_->port());
    if (line.say(get("/"))) page = line.hear("</html>");
  }
  EXPECT_NE(page.find("200 OK"), std::string::npos);
}

/// [byte] of this process in memory.
std::size_t resident() {
  std::ifstream in("/proc/self/statm");
  std::size_t whole = 0, pages = 0;
  in >> whole >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// As many as the system lets one process have open at once, in waves.
TEST_F(ConsoleTest, TenThousandConnectionsKeepNobodyElseOutAndTakeNoMemory) {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, 12'000);
  setrlimit(RLIMIT_NOFILE, &limit);
  constexpr std::size_t kAll = 10'000;
  const std::size_t at_once = std::min<std::size_t>(kAll, limit.rlim_cur - 300);
  const std::size_t before = resident();
  std::size_t opened = 0;
  for (std::size_t left = kAll; left > 0;) {
    std::vector<std::unique_ptr<Line>> lines;
    for (std::size_t i = 0; i < std::min(left, at_once); ++i) {
      lines.push_back(std::make_unique<Line>(console_->port()));
      opened += lines.back()->say("GET / HTTP/1.1\r\n") ? 1 : 0;
    }
    left -= lines.size();

    Line other(console_->port(), "127.0.0.9");  // another machine has its own share
    other.say(get("/"));
    EXPECT_NE(other.hear("</html>").find("200 OK"), std::string::npos);
  }

  EXPECT_GT(opened, 90U) << "some were taken";
  EXPECT_LT(resident(), before + 50'000'000) << "most of it is this test's own";
}

TEST_F(ConsoleTest, AReaderThatDoesNotReadHoldsNobodyUp) {
  Line slow(console_->port());
  slow.say(get("/api/events"));  // and never reads
  Line reader(console_->port());
  reader.say(get("/api/events"));
  reader.hear("hello");

  const std::string text(10'000, 'x');
  for (int i = 0; i < 2000; ++i) {
    console_->sees(
        journal::Record({}, "ground", "notice").with("text", text + "nr" + std::to_string(i)));
    if (i % 100 == 0) turn();
  }
  turn();

  EXPECT_NE(reader.hear("nr1999\"").find("nr1999\""), std::string::npos);
}

TEST_F(ConsoleTest, TakesNoMoreRequestsThanItsNodeCanBeGiven) {
  std::string said;
  for (int i = 1; i < 200 && said.find("503") == std::string::npos; ++i) {
    said = answer(post(R"({"who":"a","number":)" + std::to_string(i) + R"(,"actions":[]})"));
  }
  EXPECT_NE(said.find("503"), std::string::npos);
  EXPECT_EQ(console_->take().size(), 64U);
}

TEST_F(ConsoleTest, NamesOfObjectsReachThePageAsJsonText) {
  wire::UavTasks tasks;
  tasks.uav = "marvin";
  tasks.tasks.push_back({});
  tasks.tasks.back().type = "\"}</script><script>alert(1)</script>";
  console_->sees(wire::Sample(tasks));
  turn();
  Line line(console_->port());
  line.say(get("/api/events"));
  const std::string heard = line.hear("mark");

  std::istringstream stream(line.hear("\"at\":"));
  int parsed = 0;
  for (std::string text; std::getline(stream, text);) {
    if (!text.starts_with("data: ")) continue;
    if (text.find("alert") == std::string::npos) continue;
    const Json json = Json::parse(text.substr(6), nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << text;
    ++parsed;
  }
  EXPECT_GE(parsed, 1);
}

TEST_F(ConsoleTest, TellsWhereUavsStandInEachOfTheirJointTasks) {
  for (const std::uint32_t instance : {1U, 2U}) {
    wire::JointTaskState state;
    state.header.origin = 11;
    state.header.instance = instance;
    state.uav = "marvin";
    state.subject = "watch " + std::to_string(instance);
    console_->sees(wire::Sample(state));
  }
  turn();
  Line line(console_->port());
  line.say(get("/api/events"));

  const std::string heard = line.hear("watch 2");
  EXPECT_NE(heard.find("\"subject\":\"watch 1\""), std::string::npos);
  EXPECT_NE(heard.find("\"subject\":\"watch 2\""), std::string::npos);
}

TEST(ConsoleToken, IsNeededWhereOthersCanReachItAndIsInItsUrl) {
  ConsoleConfig config;
  config.address = "0.0.0.0";
  config.port = 0;
  auto console = Console::open(std::move(config));
  ASSERT_TRUE(console) << console.error().why;
  const std::uint16_t port = (*console)->port();
  const std::string host = "127.0.0.1:" + std::to_string(port);
  const std::string url = (*console)->url();
  const std::string token = url.substr(url.find("#token=") + 7);
  ASSERT_EQ(token.size(), 26U);
  const auto asked = [&](const std::string& text) {
    Line line(port);
    line.say(text);
    return line.hear("that never comes");
  };

  EXPECT_NE(asked("GET /api/world HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n")
                .find("401"),
            std::string::npos);
  EXPECT_NE(asked("GET /api/world HTTP/1.1\r\nHost: " + host + "\r\nAuthorization: Bearer " +
                  token + "\r\nConnection: close\r\n\r\n")
                .find("200 OK"),
            std::string::npos);
  const std::string body = R"({"token":")" + token + "\"}";
  const std::string session =
      asked("POST /api/session HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
            "\r\nContent-Type: application/json\r\nConnection: close\r\nContent-Length: " +
            std::to_string(body.size()) + "\r\n\r\n" + body);
  EXPECT_NE(session.find("HttpOnly; SameSite=Strict"), std::string::npos) << session;
}

TEST(ConsoleAddress, IsAnAddressAPortOrBoth) {
  const auto read = [](const std::string& text) {
    ConsoleConfig config;
    const auto done = read_address(text, config);
    return done ? config.address + ":" + std::to_string(config.port) : "refused";
  };
  EXPECT_EQ(read("9000"), "127.0.0.1:9000");
  EXPECT_EQ(read(":9000"), "127.0.0.1:9000");
  EXPECT_EQ(read("0.0.0.0:80"), "0.0.0.0:80");
  EXPECT_EQ(read("10.0.0.1"), "10.0.0.1:8080");
  EXPECT_EQ(read("localhost:1"), "127.0.0.1:1");
  EXPECT_EQ(read("0.0.0.0:99999"), "refused");
  EXPECT_EQ(read("9000x"), "refused");
}

TEST(ConsoleAddress, OfNoPortIsRefusedWithTheRangeOfPorts) {
  ConsoleConfig config;

  const auto done = read_address("99999", config);

  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().why, "'99999': expected ADDRESS:PORT, with a port from 0 to 65535");
}

TEST(ConsoleAddress, ThatIsTakenIsSaid) {
  ConsoleConfig config;
  config.port = 0;
  const auto first = Console::open(config);
  ASSERT_TRUE(first);
  config.port = (*first)->port();

  const auto second = Console::open(config);

  ASSERT_FALSE(second);
  EXPECT_NE(second.error().why.find("cannot listen"), std::string::npos);
}

}  // namespace
}  // namespace skein::console
