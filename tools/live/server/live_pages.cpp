#include "tools/live/server/live_pages.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "tools/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using PagesJson = nlohmann::json;

constexpr std::size_t kMostTold = 4000;
constexpr std::chrono::seconds kHandsKept(10);  // After their last use.

SharedBytes shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

/// Simulated time of something that belongs to the timeline; nothing for anything else.
std::optional<double> time_of(const PagesJson& said) {
  const std::string what = said.value("said", "");
  if (what == "done") return said.at("at_s").get<double>();
  if (what == "events") return said.at("events").back().at("time").get<double>();
  return std::nullopt;
}

}  // namespace

void LivePage::say(SharedBytes text) {
  waiting_ += text->size();
  said_.push_back(std::move(text));
  wake_();
}

void LivePage::show(SharedBytes frame) {
  frame_ = std::move(frame);
  wake_();
}

std::optional<PageMessage> LivePage::take() {
  if (!said_.empty()) {
    SharedBytes text = std::move(said_.front());
    said_.pop_front();
    waiting_ -= text->size();
    return PageMessage{std::move(text), false};
  }
  if (!frame_) return std::nullopt;
  return PageMessage{std::exchange(frame_, nullptr), true};
}

void LivePages::open(const std::shared_ptr<LivePage>& page, Clock::time_point now) {
  pages_.push_back(page);
  if (hello_) page->say(hello_);
  if (scene_) page->say(scene_);
  if (std::string history = history_.message(); !history.empty()) {
    page->say(shared(std::move(history)));
  }
  for (const Told& told : timeline_) page->say(told.text);
  if (status_) page->say(status_);
  if (frame_) page->show(frame_);
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

void LivePages::remember(const PagesJson& said, const SharedBytes& text) {
  const std::string what = said.value("said", "");
  if (what == "hello") hello_ = text;
  if (what == "scene") scene_ = text;
  if (what == "status") {
    status_ = text;
    // After the run went back, what came later never happened.
    const double now_s = said.at("now_s").get<double>();
    while (!timeline_.empty() && timeline_.back().time_s > now_s) timeline_.pop_back();
    history_.cut(now_s);
  }
  if (const auto time_s = time_of(said)) {
    timeline_.push_back({*time_s, text});
    if (timeline_.size() > kMostTold) timeline_.pop_front();
  }
}

void LivePages::say(const std::string& text) {
  const SharedBytes bytes = shared(text);
  const PagesJson said = PagesJson::parse(text, nullptr, false);
  if (said.is_object()) remember(said, bytes);
  for (const auto& page : pages_) page->say(bytes);
}

void LivePages::show(std::string frame) {
  history_.add(frame);
  frame_ = shared(std::move(frame));
  for (const auto& page : pages_) page->show(frame_);
}

}  // namespace castaway::testbed
