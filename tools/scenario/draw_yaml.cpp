#include "tools/scenario/draw_yaml.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

using localization::Rng;

const std::vector<std::string> kDistributions{"choice", "integer", "log_uniform",
                                              "normal", "uniform", "value"};

Draw read_choice(YamlReader& map) {
  ChoiceDraw choice;
  for (const YamlReader& option : map.list("choice")) choice.options.push_back(option.raw());
  if (choice.options.empty()) map.fail("'choice' is empty: give at least one value");
  choice.weights = map.get_optional<std::vector<double>>("weights").value_or(
      std::vector<double>(choice.options.size(), 1.0));
  if (choice.weights.size() != choice.options.size()) {
    map.fail(fmt::format("{} 'weights' for {} choices: give one for each", choice.weights.size(),
                         choice.options.size()));
  }
  const double least = *std::min_element(choice.weights.begin(), choice.weights.end());
  const double sum = std::accumulate(choice.weights.begin(), choice.weights.end(), 0.0);
  if (!(least >= 0.0 && sum > 0.0 && std::isfinite(sum)))
    map.fail("'weights' must not be negative, nor all be 0");
  return choice;
}

Draw read_uniform(YamlReader& map, const std::string& key) {
  const auto ends = map.require<Eigen::Vector2d>(key);
  if (!(ends.x() <= ends.y())) {
    map.fail(fmt::format("'{}' is [{}, {}]: the lower end comes first", key, ends.x(), ends.y()));
  }
  const bool logarithmic = key == "log_uniform";
  if (logarithmic && !(ends.x() > 0.0)) map.fail("'log_uniform' needs positive ends");
  return UniformDraw{ends.x(), ends.y(), logarithmic};
}

Draw read_normal(YamlReader& map) {
  YamlReader body = map.child("normal");
  const NormalDraw normal{body.require<double>("mean"), body.require<double>("sd"),
                          body.require<double>("min"), body.require<double>("max")};
  if (!(normal.sd > 0.0)) body.fail("'sd' must be positive");
  if (!(normal.min <= normal.max)) body.fail("'min' must not be above 'max'");
  return normal;
}

Draw read_integer(YamlReader& map) {
  const std::vector<YamlReader> ends = map.list("integer");
  if (ends.size() != 2) map.fail("'integer' takes two whole numbers, e.g. [0, 8]");
  const IntegerDraw draw{ends[0].as<int>(), ends[1].as<int>()};
  if (draw.low > draw.high) {
    map.fail(fmt::format("'integer' is [{}, {}]: the lower end comes first", draw.low, draw.high));
  }
  return draw;
}

/// The key that names the distribution; there must be exactly one.
std::string kind_of(YamlReader& map) {
  std::string kind;
  for (auto& [key, value] : map.entries()) {
    if (key == "weights") continue;
    if (std::find(kDistributions.begin(), kDistributions.end(), key) == kDistributions.end()) {
      value.fail(fmt::format("'{}' is not a known distribution; {}", key,
                             suggestion(key, kDistributions)));
    }
    if (!kind.empty()) map.fail(fmt::format("'{}' and '{}': give one of them", kind, key));
    kind = key;
  }
  if (kind.empty()) map.fail("does not state a distribution: give choice, uniform, integer...");
  if (kind != "choice" && map.has("weights")) map.fail("'weights' go with 'choice' only");
  return kind;
}

/// Rounds to six significant digits.
YamlNode number(double value, double low, double high) {
  const std::string text = fmt::format("{:.6g}", value);
  double rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return write_yaml(std::clamp(rounded, low, high));
}

YamlNode value_of(const FixedDraw& draw, Rng&) { return draw.value; }

/// The option at a place among the weights, which `left` is a part of the sum of.
YamlNode option_at(const ChoiceDraw& draw, double left) {
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < draw.weights.size(); ++i) {
    if (draw.weights[i] <= 0.0) continue;
    chosen = i;  // If rounding leaves a rest, the last option with a positive weight is chosen.
    if (left < draw.weights[i]) break;
    left -= draw.weights[i];
  }
  return draw.options[chosen];
}

YamlNode value_of(const ChoiceDraw& draw, Rng& rng) {
  const double sum = std::accumulate(draw.weights.begin(), draw.weights.end(), 0.0);
  return option_at(draw, boost::random::uniform_real_distribution<double>(0.0, sum)(rng));
}

YamlNode value_of(const UniformDraw& draw, Rng& rng) {
  if (draw.low == draw.high) return number(draw.low, draw.low, draw.high);
  if (!draw.logarithmic) {
    boost::random::uniform_real_distribution<double> even(draw.low, draw.high);
    return number(even(rng), draw.low, draw.high);
  }
  boost::random::uniform_real_distribution<double> even(std::log(draw.low), std::log(draw.high));
  return number(std::exp(even(rng)), draw.low, draw.high);
}

YamlNode value_of(const NormalDraw& draw, Rng& rng) {
  constexpr int kTries = 1000;
  boost::random::normal_distribution<double> normal(draw.mean, draw.sd);
  double value = normal(rng);
  for (int i = 1; i < kTries && (value < draw.min || value > draw.max); ++i) value = normal(rng);
  return number(value, draw.min, draw.max);
}

YamlNode value_of(const IntegerDraw& draw, Rng& rng) {
  return write_yaml(boost::random::uniform_int_distribution<int>(draw.low, draw.high)(rng));
}

YamlNode quantile_of(const FixedDraw& draw, double) { return draw.value; }

YamlNode quantile_of(const ChoiceDraw& draw, double quantile) {
  const double sum = std::accumulate(draw.weights.begin(), draw.weights.end(), 0.0);
  return option_at(draw, quantile * sum);
}

YamlNode quantile_of(const UniformDraw& draw, double quantile) {
  if (!draw.logarithmic) {
    return number(draw.low + quantile * (draw.high - draw.low), draw.low, draw.high);
  }
  const double low = std::log(draw.low);
  return number(std::exp(low + quantile * (std::log(draw.high) - low)), draw.low, draw.high);
}

YamlNode quantile_of(const NormalDraw& draw, double quantile) {
  constexpr double kLeast = 1e-15;  // The quantile of 0 is infinite.
  const boost::math::normal normal(draw.mean, draw.sd);
  const double below = boost::math::cdf(normal, draw.min);
  const double within = boost::math::cdf(normal, draw.max) - below;
  const double share = std::clamp(below + quantile * within, kLeast, 1.0 - kLeast);
  return number(boost::math::quantile(normal, share), draw.min, draw.max);
}

YamlNode quantile_of(const IntegerDraw& draw, double quantile) {
  const double count = static_cast<double>(draw.high) - draw.low + 1.0;
  const double steps = std::min(std::floor(quantile * count), count - 1.0);
  return write_yaml(draw.low + static_cast<int>(steps));
}

}  // namespace

Draw read_draw(YamlReader value) {
  if (!value.is_map()) return FixedDraw{value.raw()};
  const std::string kind = kind_of(value);
  if (kind == "choice") return read_choice(value);
  if (kind == "normal") return read_normal(value);
  if (kind == "integer") return read_integer(value);
  if (kind != "value") return read_uniform(value, kind);
  const auto fixed = value.find("value");
  return FixedDraw{fixed ? fixed->raw() : YamlNode{}};
}

YamlNode draw_value(const Draw& draw, Rng& rng) {
  return std::visit([&rng](const auto& of) { return value_of(of, rng); }, draw);
}

YamlNode value_at(const Draw& draw, double quantile) {
  return std::visit([quantile](const auto& of) { return quantile_of(of, quantile); }, draw);
}

}  // namespace castaway::testbed
