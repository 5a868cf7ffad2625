// castaway live, as its attackers see it.
#include <arpa/inet.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// A line to the server.
class Line {
 public:
  explicit Line(int port) : file_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{15, 0};
    setsockopt(file_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    open_ = connect(file_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  Line(Line&& other) noexcept : file_(std::exchange(other.file_, -1)), open_(other.open_) {}
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line() {
    if (file_ >= 0) close(file_);
  }

  [[nodiscard]] bool is_open() const { return open_; }
  void send_text(const std::string& text) const {
    ::send(file_, text.data(), text.size(), MSG_NOSIGNAL);
  }
  /// What comes until the server closes, `most` bytes at most.
  [[nodiscard]] std::string answer(std::size_t most = 1U << 20U) const {
    std::string text;
    std::array<char, 4096> buffer{};
    while (text.size() < most) {
      const ssize_t count = recv(file_, buffer.data(), buffer.size(), 0);
      if (count <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int file_;
  bool open_ = false;
};

/// A live run in a process of its own.
class LiveServer {
 public:
  explicit LiveServer(const fs::path& folder) : folder_(folder) {
    process_ = fork();
    if (process_ == 0) {
      const int out = open((folder / "out.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      const int err = open((folder / "err.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      dup2(out, 1);
      dup2(err, 2);
      fs::current_path(folder);
      execl(CASTAWAY_PROGRAM, "castaway", "live", "--port", "0", "--play", "--set",
            "localizers=[mh_amcl]", nullptr);
      _exit(9);
    }
    for (int tries = 0; tries < 1200 && !text_of(folder / "out.txt").ends_with('\n'); ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    url_ = text_of(folder / "out.txt");
  }
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;
  ~LiveServer() {
    if (process_ > 0) stop();
  }

  /// False if this program has no page for live runs.
  [[nodiscard]] bool has_page() const {
    return !errors().starts_with("castaway: this castaway was");
  }
  [[nodiscard]] int port() const { return std::stoi(url_.substr(url_.rfind(':') + 1)); }
  [[nodiscard]] std::string token() const { return url_.substr(url_.find('=') + 1, 32); }
  [[nodiscard]] std::string errors() const { return text_of(folder_ / "err.txt"); }
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(port()); }

  /// Exit status of an end by SIGTERM.
  int stop() {
    kill(process_, SIGTERM);
    int status = -1;
    waitpid(std::exchange(process_, -1), &status, 0);
    return status;
  }

  [[nodiscard]] std::string get(const std::string& target, const std::string& host,
                                const std::string& headers = "") const {
    const Line line(port());
    line.send_text("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n" +
                   headers + "\r\n");
    return line.answer();
  }
  /// `length`: of the body that is announced; nothing: its own.
  [[nodiscard]] std::string post(const std::string& target, const std::string& headers,
                                 const std::string& body,
                                 std::optional<std::size_t> length = std::nullopt) const {
    const Line line(port());
    line.send_text("POST " + target + " HTTP/1.1\r\nHost: " + host() +
                   "\r\nConnection: close\r\nContent-Length: " +
                   std::to_string(length.value_or(body.size())) + "\r\n" + headers + "\r\n" + body);
    return line.answer();
  }
  [[nodiscard]] std::string page() const { return get("/?token=" + token(), host()); }
  /// The request for the run's stream from a page of `origin`.
  [[nodiscard]] std::string upgrade(const std::string& origin) const {
    return "GET /live?token=" + token() + " HTTP/1.1\r\nHost: " + host() + "\r\nOrigin: " + origin +
           "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";
  }

 private:
  fs::path folder_;
  pid_t process_ = -1;
  std::string url_;
};

/// A masked text frame of a WebSocket.
std::string text_frame(const std::string& text) {
  std::string frame = "\x81";
  if (text.size() < 126) {
    frame += static_cast<char>(0x80U | text.size());
  } else {
    frame += '\xFF';
    for (int shift = 56; shift >= 0; shift -= 8) {
      frame += static_cast<char>((text.size() >> static_cast<unsigned>(shift)) & 0xFFU);
    }
  }
  return frame + std::string(4, '\0') + text;  // A mask of zeros.
}

class LiveAttack : public testing::Test {
 protected:
  void SetUp() override {
    if (!server_.has_page()) GTEST_SKIP() << "this build has no page for live runs";
  }
  /// Opens the run's stream, sends these bytes, and closes it.
  void send_as_page(const std::vector<std::string>& all) const {
    const Line line(server_.port());
    line.send_text(server_.upgrade("http://" + server_.host()));
    expect_contains(line.answer(12), "HTTP/1.1 101");
    for (const std::string& bytes : all) line.send_text(bytes);
  }
  /// Waits for a line on standard error.
  void expect_error(const std::string& text) const {
    for (int tries = 0; tries < 200 && server_.errors().find(text) == std::string::npos; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    expect_contains(server_.errors(), text);
  }
  /// The run was not harmed: its page is served, and the server ends as asked.
  void expect_unharmed() {
    expect_contains(server_.page(), "castaway-live");
    EXPECT_EQ(server_.stop(), 0) << server_.errors();
  }

  fs::path folder_ = fresh_folder();
  LiveServer server_{folder_};
};

TEST_F(LiveAttack, WithoutTheTokenNobodyGetsIn) {
  expect_contains(server_.page(), "HTTP/1.1 200");
  for (const std::string target : {"/", "/?token=", "/?token=0123456789abcdef0123456789abcdef"}) {
    expect_contains(server_.get(target, server_.host()), "HTTP/1.1 403");
  }
  expect_contains(server_.errors(), "refused: / (no token, or a wrong one)");
  expect_unharmed();
}

TEST_F(LiveAttack, OtherHostNamesAndOriginsAreRefused) {
  const std::string target = "/?token=" + server_.token();
  expect_contains(server_.get(target, "evil.example:" + std::to_string(server_.port())),
                  "HTTP/1.1 403");
  expect_contains(server_.get(target, server_.host(), "Origin: http://evil.example\r\n"),
                  "HTTP/1.1 403");
  for (const std::string origin : {"http://evil.example", "null", ""}) {
    const Line line(server_.port());
    line.send_text(server_.upgrade(origin));
    expect_contains(line.answer(), "HTTP/1.1 403");
  }
  expect_unharmed();
}

TEST_F(LiveAttack, TheTokenIsInNoErrorLine) {
  EXPECT_EQ(server_.get("/?token=" + server_.token(), "evil.example").find("200"),
            std::string::npos);
  EXPECT_EQ(server_.errors().find(server_.token()), std::string::npos) << server_.errors();
  expect_unharmed();
}

TEST_F(LiveAttack, GarbageIsRefusedWithOneLine) {
  const Line line(server_.port());
  line.send_text(std::string("\x00\xFF\x16\x03garbage\r\n\r\n", 15));
  (void)line.answer();
  const std::string errors = server_.errors();
  expect_contains(errors, "refused: no request");
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
  expect_unharmed();
}

TEST_F(LiveAttack, LongHeadersAndBodiesAreRefused) {
  const Line header(server_.port());
  header.send_text("GET / HTTP/1.1\r\nX: " + std::string(100000, 'x'));
  (void)header.answer();
  const Line body(server_.port());
  body.send_text("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 1000000000\r\n\r\n");
  (void)body.answer();
  expect_contains(server_.errors(), "refused: no request");
  expect_unharmed();
}

TEST_F(LiveAttack, FilesAreKeptOnlyFromTheOwnPageWithinLimits) {
  const std::string own = "Origin: http://" + server_.host() + "\r\n";
  const std::string file = "/file?token=" + server_.token() + "&name=";
  expect_contains(server_.post(file + "a%20b.yaml", own, "x: 1"), "HTTP/1.1 200");
  EXPECT_EQ(text_of(folder_ / "runs/live-lab-kidnap-1/files/a b.yaml"), "x: 1");
  const std::string mesh(3'000'000, 'm');
  expect_contains(server_.post(file + "robot%2Fmeshes%2Fbase.stl", own, mesh), "HTTP/1.1 200");
  EXPECT_EQ(text_of(folder_ / "runs/live-lab-kidnap-1/files/robot/meshes/base.stl"), mesh);
  expect_contains(server_.post("/file?name=b.yaml", own, "x"), "HTTP/1.1 403");
  expect_contains(server_.post(file + "b.yaml", "", "x"), "HTTP/1.1 403");
  expect_contains(server_.post(file + "b.yaml", "Origin: http://evil.example\r\n", "x"),
                  "HTTP/1.1 403");
  for (const std::string name : {"..%2Fevil", "%2Fetc%2Fpasswd", "", ".hidden", "a%00b"}) {
    expect_contains(server_.post(file + name, own, "x"), "HTTP/1.1 400");
  }
  expect_contains(server_.get("/report/1?token=" + server_.token(), server_.host()),
                  "HTTP/1.1 404");
  EXPECT_EQ(server_.post(file + "big", own, "x", 1'000'000'000).find("200"), std::string::npos);
  expect_contains(server_.errors(), "refused: no request (body limit exceeded");
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder_ / "runs"), {}), 6);
  expect_unharmed();
}

TEST_F(LiveAttack, HugeMessagesCloseThePage) {
  send_as_page({text_frame(std::string(200000, 'x'))});
  expect_error("closed a page: a message of more than 64 KiB");
  expect_unharmed();
}

TEST_F(LiveAttack, TooManyMessagesCloseThePage) {
  std::string frames;
  for (int i = 0; i < 1000; ++i) frames += text_frame("{}");
  send_as_page(std::vector<std::string>(1000, frames));
  expect_error("closed a page: more than 200 messages in a second");
  expect_unharmed();
}

TEST_F(LiveAttack, HalfOpenLinesAreLimitedInNumberAndTime) {
  std::vector<Line> lines;
  for (int i = 0; i < 100; ++i) lines.emplace_back(server_.port());
  const auto begin = std::chrono::steady_clock::now();
  expect_contains(server_.page(), "HTTP/1.1 200");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(900));
  expect_contains(server_.errors(), "refused: the oldest of 64 connections without a request");
  EXPECT_EQ(lines.back().answer(), "");  // Closed by the server after a second.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  expect_unharmed();
}

TEST(Live, RefusesWhatItCannotServe) {
  const fs::path folder = fresh_folder();
  expect_refused(castaway(folder, "live --address nowhere"), {"'nowhere' is no IP address"});
  expect_refused(castaway(folder, "live no-such-scenario"), {"no-such-scenario"});
  expect_refused(castaway(folder, "live ."), {"report.html", "castaway report"});
}

/// A bag of a run in a building of two floors, and the 3-D map of the building.
void put_mezzanine(const fs::path& folder) {
  const Outcome outcome = castaway(
      folder,
      "run mezzanine/kidnaps --duration 8 --set outputs.bag=true --set outputs.carmen=true "
      "--set outputs.snapshots=false --out run");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  ASSERT_EQ(castaway(folder, "map mezzanine --out mezzanine.map3d").exit_code, 0);
}

TEST(Live, PlaysABagOnA3dMap) {
  const fs::path folder = fresh_folder();
  put_mezzanine(folder);
  const Outcome outcome = castaway(folder,
                                   "live --port 0 --play run/bag --map3d mezzanine.map3d "
                                   "--imu-topic /imu --base-height 0 --start truth",
                                   "timeout -s INT 8");
  if (outcome.err.starts_with("castaway: this castaway was built without")) GTEST_SKIP();
  EXPECT_EQ(outcome.err, "");
  expect_contains(outcome.out, "http://127.0.0.1:");
  // What only reading the bag tells.
  const std::string on_map = "live --port 0 run/bag --map3d mezzanine.map3d ";
  expect_refused(castaway(folder, on_map + "--imu-topic /odom"), {"its type is nav_msgs/msg"});
  expect_refused(castaway(folder, on_map + "--points-topic /points"), {"there is no such topic"});
}

TEST(Live, SaysWhatALogOnA3dMapLacks) {
  const fs::path folder = fresh_folder();
  put_mezzanine(folder);
  const auto refused = [&](const std::string& arguments, const std::string& why) {
    expect_refused(castaway(folder, "live --port 0 " + arguments), {why});
  };
  refused("--map3d mezzanine.map3d", "--map3d is of a log: name one");
  refused("mezzanine/kidnaps --map3d mezzanine.map3d", "--localizer mh_amcl:3d makes its own");
  refused("lab/kidnap --imu-topic /imu", "--imu-topic is of a log: name one");
  refused("lab/kidnap --points-topic /points", "--points-topic is of a log: name one");
  refused("lab/kidnap --base-height 0.1", "--base-height is of a log: name one");
  refused("run --map3d mezzanine.map3d", "name the folder 'bag' in it");
  refused("run/bag --map3d gone.bt", "gone.bt: cannot be read");
  refused("run/bag --map mezzanine.map3d", "is a 3-D map; name it by --map3d");
  refused("run/bag --base-height 0.1", "--base-height is for 3-D maps");
  refused("run/bag --map3d mezzanine.map3d --localizer amcl", "is for mh_amcl in mode 3d");
  refused("run/log.carmen --map3d mezzanine.map3d", "does not say how high its lidar is mounted");
  std::ofstream(folder / "saved.yaml") << "log: run/bag\nmap3d: mezzanine.map3d\n";
  refused("saved.yaml --map3d other.map3d", "saved.yaml states what is played");
}

}  // namespace
}  // namespace castaway::test
