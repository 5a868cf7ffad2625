#include "tools/build/foreign/answer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using localization::Estimate;
using localization::PopulationView;
using localization::SE2;

[[noreturn]] void fail(const std::string& what) { throw std::invalid_argument(what); }

/// The beginning of a line, for messages.
std::string quoted(const std::string& line) {
  constexpr std::size_t kLongest = 60;
  std::string text;
  for (const char c : line.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : '?';
  return "'" + text + (line.size() > kLongest ? "...'" : "'");
}

Json parse(const std::string& line, const std::string& type) {
  if (nests_too_deep(line)) fail("nests its answer too deeply");
  Json message = Json::parse(line, nullptr, false);
  if (message.is_discarded()) fail("answered with a line that is not JSON: " + quoted(line));
  const auto found = message.is_object() ? message.find("type") : message.end();
  if (!message.is_object() || found == message.end()) {
    fail("answered without a 'type': " + quoted(line));
  }
  if (*found != type) fail(fmt::format("answered {} instead of \"{}\"", json_text(*found), type));
  return message;
}

void require_known(const Json& object, std::initializer_list<const char*> keys) {
  for (const auto& [key, value] : object.items()) {
    const bool known =
        std::any_of(keys.begin(), keys.end(), [&name = key](const char* k) { return name == k; });
    if (!known) fail(fmt::format("answered with an unknown key {}", quoted(key)));
  }
}

double number(const Json& value, const std::string& key) {
  if (!value.is_number())
    fail(fmt::format("'{}' must be of numbers, not {}", key, quoted(json_text(value))));
  return value.get<double>();
}

SE2 pose(const Json& value, const std::string& key) {
  if (!value.is_array() || value.size() != 3) fail("'" + key + "' must be [x, y, yaw]");
  return {number(value[0], key), number(value[1], key), number(value[2], key)};
}

/// Nine numbers row by row, or three rows of three.
Eigen::Matrix3d covariance(const Json& value) {
  Json flat = Json::array();
  for (const Json& item : value) {
    if (item.is_array()) {
      flat.insert(flat.end(), item.begin(), item.end());
    } else {
      flat.push_back(item);
    }
  }
  if (!value.is_array() || flat.size() != 9) fail("'covariance' must be 9 numbers, row by row");
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) {
    matrix(i / 3, i % 3) = number(flat[static_cast<std::size_t>(i)], "covariance");
  }
  return matrix;
}

bool flag(const Json& message, const char* key) {
  const auto found = message.find(key);
  if (found == message.end()) return false;
  if (!found->is_boolean()) fail(fmt::format("'{}' must be true or false", key));
  return found->get<bool>();
}

/// A missing number, or null, is one that is not stated.
double stated(const Json& message, const char* key, double otherwise) {
  const auto found = message.find(key);
  return found == message.end() || found->is_null() ? otherwise : number(*found, key);
}

PopulationView hypothesis(const Json& value, int id) {
  constexpr double kNone = 0.0;
  if (!value.is_object()) fail("'hypotheses' must be objects {pose, probability}");
  require_known(value, {"pose", "probability", "particles"});
  PopulationView view;
  view.id = id;
  if (!value.contains("pose")) fail("a hypothesis has no 'pose'");
  view.T_map_base = pose(value.at("pose"), "hypotheses.pose");
  view.share = stated(value, "probability", kNone);
  if (value.contains("particles")) {
    for (const Json& particle : value.at("particles")) {
      view.particles.push_back(pose(particle, "hypotheses.particles"));
    }
  }
  return view;
}

std::vector<PopulationView> hypotheses(const Json& message) {
  std::vector<PopulationView> views;
  const auto found = message.find("hypotheses");
  if (found == message.end()) return views;
  if (!found->is_array()) fail("'hypotheses' must be a list");
  for (const Json& value : *found)
    views.push_back(hypothesis(value, static_cast<int>(views.size())));
  return views;
}

void require_finite(const SE2& pose, const char* what) {
  constexpr double kFarthest = 1e7;  // [m]
  const bool good = std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw) &&
                    std::abs(pose.x) <= kFarthest && std::abs(pose.y) <= kFarthest;
  if (!good)
    fail(fmt::format("states {} ({}, {}, {}), which is not finite or beyond 1e7 m", what, pose.x,
                     pose.y, pose.yaw));
}

/// Sums of weights may be off by a rounding error.
double require_share(double share, const char* what) {
  constexpr double kRounding = 1e-9;
  if (share >= -kRounding && share <= 1.0 + kRounding) return std::clamp(share, 0.0, 1.0);
  fail(fmt::format("states {} {}, which is not in [0, 1]", what, share));
}

void make_sound(Estimate& estimate) {
  require_finite(estimate.T_map_base, "the pose");
  if (!estimate.covariance.allFinite() || estimate.covariance.diagonal().minCoeff() < 0.0) {
    fail("states a covariance that is not finite or has a negative variance");
  }
  if (!std::isnan(estimate.probability)) {
    estimate.probability = require_share(estimate.probability, "the probability");
  }
  if (!std::isnan(estimate.quality)) {
    estimate.quality = require_share(estimate.quality, "the quality");
  }
}

}  // namespace

void read_ready(const std::string& line) {
  const Json message = parse(line, "ready");
  require_known(message, {"type", "protocol"});
}

void complete(Answer& answer) {
  for (PopulationView& view : answer.populations) {
    require_finite(view.T_map_base, "a hypothesis at");
    view.share = require_share(view.share, "the probability of a hypothesis");
    for (const SE2& particle : view.particles) require_finite(particle, "a particle at");
  }
  if (!answer.estimate) return;
  make_sound(*answer.estimate);
  const SE2& output = answer.estimate->T_map_base;
  for (PopulationView& view : answer.populations) {
    view.selected = view.T_map_base == output;
    if (!view.selected) answer.estimate->alternatives.push_back({view.T_map_base, view.share});
  }
  std::stable_sort(answer.estimate->alternatives.begin(), answer.estimate->alternatives.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
}

Answer read_estimate(const std::string& line, localization::Stamp stamp) {
  constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();
  const Json message = parse(line, "estimate");
  require_known(message, {"type", "stamp_ns", "pose", "covariance", "probability", "quality",
                          "lost", "hypotheses"});
  if (!message.contains("stamp_ns")) fail("answered without 'stamp_ns'");
  const auto& answered = message.at("stamp_ns");
  if (answered != stamp.count()) {
    fail(fmt::format("answered for stamp {} instead of {}", quoted(json_text(answered)),
                     stamp.count()));
  }
  Answer answer;
  answer.populations = hypotheses(message);
  const auto output = message.find("pose");
  if (output != message.end() && !output->is_null()) {
    Estimate& estimate = answer.estimate.emplace();
    estimate.stamp = stamp;
    estimate.T_map_base = pose(*output, "pose");
    if (message.contains("covariance")) estimate.covariance = covariance(message.at("covariance"));
    estimate.probability = stated(message, "probability", kNotStated);
    estimate.quality = stated(message, "quality", kNotStated);
    estimate.lost = flag(message, "lost");
  }
  complete(answer);
  return answer;
}

}  // namespace castaway::testbed
