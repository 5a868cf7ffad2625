#include "tools/live/server/live_pages.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using PagesJson = nlohmann::ordered_json;

constexpr std::size_t kMostScansWaiting = std::size_t{4} << 20U;  // [bytes]
constexpr std::chrono::seconds kHandsKept(10);                    // After their last use.

SharedBytes shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

/// Null for an empty text.
SharedBytes shared_if_any(std::string text) {
  return text.empty() ? nullptr : shared(std::move(text));
}

}  // namespace

void LivePage::say(SharedBytes text) {
  waiting_ += text->size();
  said_.push_back(std::move(text));
  wake_();
}

void LivePage::show(SharedBytes frame, SharedBytes scans) {
  if (scans_ && waiting_ < kMostScansWaiting) {
    say(scans_);
  } else if (scans_) {
    misses_ = true;
  }
  frame_ = std::move(frame);
  scans_ = std::move(scans);
  wake_();
}

void LivePage::drop_frame() {
  frame_ = nullptr;
  scans_ = nullptr;
  misses_ = false;
}

void LivePage::say_scans(SharedBytes text) {
  misses_ = false;
  say(std::move(text));
}

std::optional<PageMessage> LivePage::take() {
  if (!said_.empty()) {
    SharedBytes text = std::move(said_.front());
    said_.pop_front();
    waiting_ -= text->size();
    return PageMessage{std::move(text), false};
  }
  if (!frame_) return std::nullopt;
  scans_ = nullptr;
  return PageMessage{std::exchange(frame_, nullptr), true};
}

void LivePages::open(const std::shared_ptr<LivePage>& page, Clock::time_point now) {
  pages_.push_back(page);
  if (hello_) page->say(hello_);
  if (scene_) page->say(scene_);
  for (const LiveHistory* history : {&scans_, &events_}) {
    if (SharedBytes message = shared_if_any(history->message())) page->say(std::move(message));
  }
  if (status_) page->say(status_);
  if (frame_) page->show(frame_, nullptr);
  if (holder_.expired()) {
    holder_ = page;
    used_ = now;
  }
  tell_hands();
}

void LivePages::close(const std::shared_ptr<LivePage>& page) {
  pages_.remove(page);
  if (holder_.lock() != page) return;
  holder_.reset();
  tell_hands();
}

void LivePages::take_hands(const std::shared_ptr<LivePage>& page, Clock::time_point now) {
  const auto holder = holder_.lock();
  const bool taken = holder && holder != page && now - used_ < kHandsKept;
  if (!taken) {
    holder_ = page;
    used_ = now;
  }
  tell_hands();
}

bool LivePages::use_hands(const std::shared_ptr<LivePage>& page, Clock::time_point now) {
  if (holder_.lock() != page) return false;
  used_ = now;
  return true;
}

void LivePages::tell_hands() const {
  const auto holder = holder_.lock();
  for (const auto& page : pages_) {
    page->say(shared(
        json_text(PagesJson{{"said", "hands"}, {"yours", page == holder}, {"free", !holder}})));
  }
}

void LivePages::begin_run() {
  scans_.clear();
  events_.clear();
  frame_ = nullptr;
  for (const auto& page : pages_) page->drop_frame();
}

void LivePages::remember(const PagesJson& said, const SharedBytes& text) {
  const std::string what = said.value("said", "");
  if (what == "hello") {
    hello_ = text;
    if (!said.value("undone", false)) begin_run();
  }
  if (what == "scene") scene_ = text;
  if (what == "status") status_ = text;
  if (what == "history") scans_.add(said);
  if (what == "events") events_.add(said);
}

void LivePages::say(const std::string& text) {
  const SharedBytes bytes = shared(text);
  const PagesJson said = PagesJson::parse(text, nullptr, false);
  if (said.is_object()) remember(said, bytes);
  for (const auto& page : pages_) page->say(bytes);
}

void LivePages::show(std::string frame) {
  SharedBytes scans;
  if (const PagesJson head = head_of_frame(frame); head.is_object()) {
    scans_.add(head);
    scans = shared_if_any(scans_.message_of(head));
  }
  frame_ = shared(std::move(frame));
  for (const auto& page : pages_) {
    if (page->misses_scans()) page->say_scans(shared(scans_.message()));
    page->show(frame_, scans);
  }
}

}  // namespace castaway::testbed
