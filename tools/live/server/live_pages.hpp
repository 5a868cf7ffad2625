/// What the server keeps for pages: the ones that are open, and what a new one must hear first.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tools/live/server/live_history.hpp"

namespace castaway::testbed {

/// Bytes that several pages are sent.
using SharedBytes = std::shared_ptr<const std::string>;

/// Something to send to a page.
struct PageMessage {
  SharedBytes bytes;
  bool binary = false;
};

/// A page that is open. What it is told is never lost, frames are: a slow page gets the newest one.
class LivePage {
 public:
  /// `wake`: called when there is something to send.
  explicit LivePage(std::function<void()> wake) : wake_(std::move(wake)) {}

  void say(SharedBytes text);
  void show(SharedBytes frame);
  /// The next thing to send; nothing if there is none.
  std::optional<PageMessage> take();
  /// Bytes that wait, without the frame. A page that lets much wait is to be closed.
  [[nodiscard]] std::size_t waiting() const { return waiting_; }

 private:
  std::function<void()> wake_;
  std::deque<SharedBytes> said_;
  std::size_t waiting_ = 0;
  SharedBytes frame_;
};

/// All open pages. One of them holds the hands.
class LivePages {
 public:
  using Clock = std::chrono::steady_clock;

  /// A page opens; it hears what the run said so far, and has the hands if nobody else has.
  void open(const std::shared_ptr<LivePage>& page, Clock::time_point now);
  void close(const std::shared_ptr<LivePage>& page);
  /// Takes the hands, unless another page used them in the last seconds. Tells the pages.
  void take_hands(const std::shared_ptr<LivePage>& page, Clock::time_point now);
  /// True if the page holds the hands; it uses them now.
  bool use_hands(const std::shared_ptr<LivePage>& page, Clock::time_point now);

  /// Passes on what the run says, as JSON, and keeps what new pages must hear.
  void say(const std::string& text);
  /// Passes a frame on.
  void show(std::string frame);
  [[nodiscard]] std::size_t count() const { return pages_.size(); }

 private:
  void remember(const nlohmann::json& said, const SharedBytes& text);
  void tell_hands() const;

  std::list<std::shared_ptr<LivePage>> pages_;
  std::weak_ptr<LivePage> holder_;
  Clock::time_point used_{};
  SharedBytes hello_;
  SharedBytes scene_;
  SharedBytes status_;
  struct Told {
    double time_s;
    SharedBytes text;
  };
  std::deque<Told> timeline_;  ///< Events of hands and of the run, the latest few thousand.
  SharedBytes frame_;
  LiveHistory history_;
};

}  // namespace castaway::testbed
