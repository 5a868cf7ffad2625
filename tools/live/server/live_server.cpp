#include "tools/live/server/live_server.hpp"

#include <array>
#include <chrono>
#include <deque>
#include <list>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <boost/asio.hpp>
#include <boost/beast.hpp>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/live/lines/wire.hpp"
#include "tools/live/server/live_http.hpp"
#include "tools/live/server/live_pages.hpp"
#include "tools/live/server/live_token.hpp"

namespace castaway::testbed {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::use_awaitable;
using asio::ip::tcp;
using RunSocket = asio::local::stream_protocol::socket;
using Steady = std::chrono::steady_clock;

constexpr std::size_t kMostConnections = 64;  // That had a request with the token.
constexpr std::size_t kMostStrangers = 64;    // That had none yet.
constexpr std::chrono::seconds kStrangerPatience(1);
constexpr std::chrono::seconds kPatience(10);       // For a whole request.
constexpr std::chrono::seconds kFilePatience(120);  // For one that brings a file.
constexpr std::size_t kLongestHeader = 8192;
constexpr std::size_t kLongestCommand = std::size_t{64} << 10U;
constexpr std::size_t kMostWaiting = std::size_t{8} << 20U;  // Bytes for a page that does not read.
constexpr int kMostCommands = 200;                           // Of a page in a second.

/// Counts commands in each second.
class Rate {
 public:
  /// False if there are too many.
  bool take(Steady::time_point now) {
    if (now - begin_ > std::chrono::seconds(1)) {
      begin_ = now;
      count_ = 0;
    }
    return ++count_ <= kMostCommands;
  }

 private:
  Steady::time_point begin_{};
  int count_ = 0;
};

}  // namespace

class LiveServer::Impl {
 public:
  Impl(LiveServerOptions options, int run_socket)
      : options_(std::move(options)),
        acceptor_(context_),
        run_(context_, asio::local::stream_protocol(), run_socket),
        signals_(context_, SIGINT, SIGTERM),
        http_(options_) {
    listen();
  }

  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  [[nodiscard]] const LiveServerOptions& options() const { return options_; }

  bool serve(const std::function<void(const std::string&)>& log) {
    log_ = log;
    signals_.async_wait([this](const boost::system::error_code& error, int) {
      if (!error) context_.stop();
    });
    spawn(accept());
    spawn(hear_run());
    context_.run();
    return run_ended_;
  }

 private:
  using Awaitable = asio::awaitable<void>;

  /// An exception ends what was spawned, and nothing else.
  void spawn(Awaitable work) { asio::co_spawn(context_, std::move(work), asio::detached); }

  void listen() {
    boost::system::error_code error;
    const auto address = asio::ip::make_address(options_.address, error);
    if (error) throw std::runtime_error("'" + options_.address + "' is no IP address");
    const tcp::endpoint endpoint(address, options_.port);
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(asio::socket_base::reuse_address(true));
    acceptor_.bind(endpoint, error);
    if (error) {
      throw std::runtime_error(fmt::format("cannot listen on {}:{}: {}; choose another --port",
                                           options_.address, options_.port, error.message()));
    }
    acceptor_.listen();
  }

  Awaitable accept() {
    while (true) {
      tcp::socket socket = co_await acceptor_.async_accept(use_awaitable);
      if (strangers_.size() >= kMostStrangers) {
        log_("refused: the oldest of 64 connections without a request");
        strangers_.front()->close();
        strangers_.pop_front();
      }
      spawn(converse(std::move(socket)));
    }
  }

  /// Counts a connection while it exists.
  struct Counted {
    explicit Counted(std::size_t& count) : count_(count) { ++count_; }
    ~Counted() { --count_; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    std::size_t& count_;
  };

  /// Lists a connection until it had a request with the token.
  struct Stranger {
    Stranger(std::list<beast::tcp_stream*>& list, beast::tcp_stream& stream)
        : list_(list), stream_(&stream) {
      list_.push_back(stream_);
    }
    ~Stranger() { list_.remove(stream_); }
    Stranger(const Stranger&) = delete;
    Stranger& operator=(const Stranger&) = delete;
    std::list<beast::tcp_stream*>& list_;
    beast::tcp_stream* stream_;
  };

  void refuse(const std::string& what) const { log_("refused: " + what); }

  /// Reads the header of a request that may be answered; nothing if there is none.
  asio::awaitable<bool> read_header(beast::tcp_stream& stream, beast::flat_buffer& buffer,
                                    http::request_parser<http::string_body>& parser) {
    parser.header_limit(kLongestHeader);
    parser.body_limit(kLargestUpload);  // Checked with the header.
    boost::system::error_code error;
    co_await http::async_read_header(stream, buffer, parser,
                                     asio::redirect_error(use_awaitable, error));
    if (error && !parser.got_some()) co_return false;  // Browsers open lines for later.
    if (error) {
      refuse("no request (" + error.message() + ")");
      co_return false;
    }
    const char* wrong = http_.refusal_of(parser.get(), port());
    if (wrong == nullptr) co_return true;
    refuse(fmt::format("{} ({})", path_of(to_view(parser.get().target())).substr(0, 80), wrong));
    co_await http::async_write(
        stream, LiveHttp::answer(parser.get(), http::status::forbidden, std::string(wrong) + "\n"),
        use_awaitable);
    co_return false;
  }

  Awaitable converse(tcp::socket socket) {
    beast::tcp_stream stream(std::move(socket));
    std::optional<Stranger> stranger(std::in_place, strangers_, stream);
    std::optional<Counted> counted;
    beast::flat_buffer buffer;
    while (true) {
      stream.expires_after(counted ? kPatience : kStrangerPatience);
      http::request_parser<http::string_body> parser;
      if (!co_await read_header(stream, buffer, parser)) co_return;
      if (!counted && connections_ >= kMostConnections) {
        co_return refuse("more than 64 connections");
      }
      if (!counted) counted.emplace(connections_);
      stranger.reset();
      stream.expires_after(kPatience);
      const std::uint64_t limit = LiveHttp::body_limit(parser.get());
      if (parser.content_length().value_or(0) > limit) co_return refuse("a body that is too long");
      parser.body_limit(limit);
      boost::system::error_code error;
      if (limit > 0) stream.expires_after(kFilePatience);
      co_await http::async_read(stream, buffer, parser, asio::redirect_error(use_awaitable, error));
      if (error) co_return refuse("no request (" + error.message() + ")");
      const LiveRequest request = parser.release();
      if (websocket::is_upgrade(request)) {
        co_await stream_to(std::move(stream), request);
        co_return;
      }
      const LiveResponse response = http_.respond(request);
      co_await http::async_write(stream, response, use_awaitable);
      if (!response.keep_alive()) co_return;
    }
  }

  using Stream = websocket::stream<beast::tcp_stream>;

  /// A page with its stream.
  struct Line {
    explicit Line(beast::tcp_stream stream)
        : socket(std::move(stream)), bell(socket.get_executor(), Steady::time_point::max()) {}
    Stream socket;
    asio::steady_timer bell;  ///< Cancelled when there is something to send.
    bool over = false;
  };

  Awaitable stream_to(beast::tcp_stream stream, const LiveRequest& request) {
    if (path_of(to_view(request.target())) != "/live") co_return;
    stream.expires_never();
    auto line = std::make_shared<Line>(std::move(stream));
    line->socket.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    line->socket.read_message_max(0);  // `read_from` limits it: then it is known why a line broke.
    co_await line->socket.async_accept(request, use_awaitable);
    auto page = std::make_shared<LivePage>([bell = std::weak_ptr<Line>(line)] {
      if (const auto there = bell.lock()) there->bell.cancel();
    });
    pages_.open(page, Steady::now());
    spawn(write_to(line, page));
    const std::string why = co_await read_from(line, page);
    if (!why.empty()) log_("closed a page: " + why);
    pages_.close(page);
    line->over = true;
    line->bell.cancel();
  }

  /// Until the page ends, or does what it may not. Returns why, or nothing.
  asio::awaitable<std::string> read_from(std::shared_ptr<Line> line,
                                         std::shared_ptr<LivePage> page) {
    Rate rate;
    beast::flat_buffer buffer;
    while (true) {
      do {
        boost::system::error_code error;
        co_await line->socket.async_read_some(buffer, kLongestCommand + 1 - buffer.size(),
                                              asio::redirect_error(use_awaitable, error));
        if (error) co_return "";  // The page was closed, or its line broke.
        if (buffer.size() > kLongestCommand) co_return "a message of more than 64 KiB";
      } while (!line->socket.is_message_done());
      if (!rate.take(Steady::now())) co_return "more than 200 messages in a second";
      obey(beast::buffers_to_string(buffer.data()), page);
      buffer.consume(buffer.size());
      if (page->waiting() > kMostWaiting) co_return "it does not read";
    }
  }

  Awaitable write_to(std::shared_ptr<Line> line, std::shared_ptr<LivePage> page) {
    while (!line->over) {
      const auto message = page->take();
      if (!message) {
        boost::system::error_code rung;
        co_await line->bell.async_wait(asio::redirect_error(use_awaitable, rung));
        continue;
      }
      line->socket.binary(message->binary);
      co_await line->socket.async_write(asio::buffer(*message->bytes), use_awaitable);
    }
    boost::system::error_code ignored;
    co_await line->socket.async_close(websocket::close_code::policy_error,
                                      asio::redirect_error(use_awaitable, ignored));
  }

  static void complain(const std::shared_ptr<LivePage>& page, const char* text) {
    const nlohmann::json error = {{"said", "error"}, {"text", text}};
    page->say(std::make_shared<const std::string>(json_text(error)));
  }

  /// Passes a command on to the run.
  void obey(const std::string& text, const std::shared_ptr<LivePage>& page) {
    const auto command = nlohmann::json::parse(text, nullptr, false);
    if (!command.is_object()) return complain(page, "not a command");
    if (command.contains("do") && command["do"] == "hands") {
      return pages_.take_hands(page, Steady::now());
    }
    if (!pages_.use_hands(page, Steady::now())) {
      return complain(page, "another page holds the hands");
    }
    const bool idle = to_run_.empty();
    to_run_.push_back(to_wire(WireKind::kCommand, text));
    if (idle) spawn(tell_run());
  }

  Awaitable tell_run() {
    while (!to_run_.empty()) {
      co_await asio::async_write(run_, asio::buffer(to_run_.front()), use_awaitable);
      to_run_.pop_front();
    }
  }

  Awaitable hear_run() {
    WireReader reader;
    std::array<char, 65536> buffer{};
    while (true) {
      boost::system::error_code error;
      const std::size_t count = co_await run_.async_read_some(
          asio::buffer(buffer), asio::redirect_error(use_awaitable, error));
      if (error) break;
      reader.take({buffer.data(), count});
      while (auto message = reader.next()) {
        if (message->kind == WireKind::kFrame) {
          pages_.show(std::move(message->body));
        } else {
          pages_.say(message->body);
        }
      }
    }
    run_ended_ = true;
    context_.stop();
  }

  LiveServerOptions options_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  RunSocket run_;
  asio::signal_set signals_;
  LiveHttp http_;
  LivePages pages_;
  std::deque<std::string> to_run_;
  std::size_t connections_ = 0;
  std::list<beast::tcp_stream*> strangers_;  ///< The oldest first.
  bool run_ended_ = false;
  std::function<void(const std::string&)> log_;
};

LiveServer::LiveServer(LiveServerOptions options, int run_socket)
    : impl_(std::make_unique<Impl>(std::move(options), run_socket)) {}

LiveServer::~LiveServer() = default;

std::uint16_t LiveServer::port() const { return impl_->port(); }

std::string LiveServer::url() const {
  const LiveServerOptions& options = impl_->options();
  const bool v6 = options.address.find(':') != std::string::npos;
  return fmt::format("http://{}:{}/?token={}", v6 ? "[" + options.address + "]" : options.address,
                     port(), options.token);
}

bool LiveServer::serve(const std::function<void(const std::string&)>& log) {
  return impl_->serve(log);
}

}  // namespace castaway::testbed
