#include "tools/live/server/live_history.hpp"

#include <algorithm>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "tools/files/json_text.hpp"

namespace castaway::testbed {
namespace {

constexpr double kSameTime = 1e-6;  // [s]

/// The JSON of a frame; nothing usable if it is none.
nlohmann::ordered_json head_of(std::string_view frame) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4 && i < frame.size(); ++i) {
    size |= static_cast<std::size_t>(static_cast<std::uint8_t>(frame[i])) << (8 * i);
  }
  return nlohmann::ordered_json::parse(frame.substr(std::min<std::size_t>(4, frame.size()), size),
                                       nullptr, false);
}

}  // namespace

void LiveHistory::add(std::string_view frame) {
  const nlohmann::ordered_json head = head_of(frame);
  if (!head.is_object()) return;
  for (const nlohmann::ordered_json& scan : head.at("scans")) {
    const double time_s = scan.at(0).get<double>();
    cut(time_s - 2 * kSameTime);
    scans_.push_back({time_s, json_text(scan)});
    if (scans_.size() > most_) scans_.pop_front();
  }
}

void LiveHistory::cut(double time_s) {
  while (!scans_.empty() && scans_.back().time_s > time_s + kSameTime) scans_.pop_back();
}

std::string LiveHistory::message() const {
  if (scans_.empty()) return "";
  std::string text = R"({"said":"history","scans":[)";
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    if (i > 0) text += ',';
    text += scans_[i].row;
  }
  return text + "]}";
}

}  // namespace castaway::testbed
