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

#include <nlohmann/json.hpp>

#include "tools/live/server/live_history.hpp"

namespace castaway::testbed {

/// Bytes that several pages are sent.
using SharedBytes = std::shared_ptr<const std::string>;

/// Something to send to a page.
struct PageMessage {
  SharedBytes bytes;
  bool binary = false;
};

/// A page that is open. What it is told is never lost, frames are: a slow page gets the newest one,
/// and of the others their scans alone.
class LivePage {
 public:
  /// `wake`: called when there is something to send.
  explicit LivePage(std::function<void()> wake) : wake_(std::move(wake)) {}

  void say(SharedBytes text);
  /// `scans`: of the frame, as a message, if the frame gives way to a newer one; null: none.
  void show(SharedBytes frame, SharedBytes scans);
  /// Its frame is of a run that is over.
  void drop_frame();
  /// True if scans were left out since so much waits already. They are to be said again when it
  /// has been read.
  [[nodiscard]] bool misses_scans() const { return misses_ && said_.empty(); }
  void say_scans(SharedBytes text);
  /// The next thing to send; nothing if there is none.
  std::optional<PageMessage> take();
  /// Bytes that wait, without the frame. A page that lets much wait is to be closed.
  [[nodiscard]] std::size_t waiting() const { return waiting_; }

 private:
  std::function<void()> wake_;
  std::deque<SharedBytes> said_;
  std::size_t waiting_ = 0;
  SharedBytes frame_;
  SharedBytes scans_;  ///< Of that frame.
  bool misses_ = false;
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
  void remember(const nlohmann::ordered_json& said, const SharedBytes& text);
  void begin_run();
  void tell_hands() const;

  std::list<std::shared_ptr<LivePage>> pages_;
  std::weak_ptr<LivePage> holder_;
  Clock::time_point used_{};
  SharedBytes hello_;
  SharedBytes scene_;
  SharedBytes status_;
  SharedBytes frame_;
  LiveHistory scans_{"history", "scans", 18000};
  LiveHistory events_{"events", "events", 4000};
};

}  // namespace castaway::testbed
