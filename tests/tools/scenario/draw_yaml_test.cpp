#include "tools/scenario/draw_yaml.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using localization::substream;

Draw draw_of(const std::string& text) {
  YamlDocument document = YamlDocument::parse("x: " + text, "d.yaml");
  const Draw draw = read_draw(*document.root().find("x"));
  document.reject_unknown_keys();
  return draw;
}

std::string draw_refusal(const std::string& text) {
  return error_of([&] { draw_of(text); });
}

/// Makes `count` draws and returns them as numbers.
std::vector<double> numbers(const std::string& text, int count) {
  const Draw draw = draw_of(text);
  localization::Rng rng = substream(1, "draws");
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(read_yaml<double>(draw_value(draw, rng), "x"));
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(Draw, AFixedValueIsItself) {
  localization::Rng rng = substream(1, "draws");
  EXPECT_EQ(emit_yaml(draw_value(draw_of("office"), rng)), "office\n");
  EXPECT_EQ(emit_yaml(draw_value(draw_of("[1, 2]"), rng)), "[1, 2]\n");
  EXPECT_EQ(emit_yaml(draw_value(draw_of("{value: {count: 3}}"), rng)), "count: 3\n");
}

TEST(Draw, ChoicesComeByTheirWeights) {
  const Draw draw = draw_of("{choice: [a, b, {c: 1}], weights: [3, 0, 1]}");
  localization::Rng rng = substream(1, "draws");
  std::map<std::string, int> counts;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) ++counts[emit_yaml(draw_value(draw, rng))];
  EXPECT_EQ(counts.count("b\n"), 0U);
  // Five sigma of a binomial count.
  EXPECT_NEAR(counts["a\n"], 0.75 * kDraws, 5.0 * std::sqrt(kDraws * 0.75 * 0.25));
  EXPECT_EQ(counts["a\n"] + counts["c: 1\n"], kDraws);
}

TEST(Draw, UniformNumbersKeepTheirLimitsAndTheirMean) {
  constexpr int kDraws = 4000;
  const auto values = numbers("{uniform: [2, 4]}", kDraws);
  for (const double value : values) EXPECT_TRUE(value >= 2.0 && value <= 4.0) << value;
  EXPECT_NEAR(mean_of(values), 3.0, 5.0 * 2.0 / std::sqrt(12.0 * kDraws));
  auto logs = numbers("{log_uniform: [0.01, 100]}", kDraws);
  for (double& value : logs) value = std::log10(value);
  EXPECT_NEAR(mean_of(logs), 0.0, 5.0 * 4.0 / std::sqrt(12.0 * kDraws));
}

TEST(Draw, NormalNumbersKeepTheirLimits) {
  constexpr int kDraws = 4000;
  const auto values = numbers("{normal: {mean: 1, sd: 0.5, min: 0, max: 2}}", kDraws);
  for (const double value : values) EXPECT_TRUE(value >= 0.0 && value <= 2.0) << value;
  EXPECT_NEAR(mean_of(values), 1.0, 5.0 * 0.5 / std::sqrt(kDraws));
  EXPECT_EQ(numbers("{normal: {mean: 0, sd: 0.001, min: 5, max: 6}}", 1)[0], 5.0);
}

TEST(Draw, WholeNumbersReachBothEnds) {
  std::map<double, int> counts;
  for (const double value : numbers("{integer: [-1, 2]}", 400)) ++counts[value];
  EXPECT_EQ(counts.size(), 4U);
  EXPECT_GT(counts[-1.0], 0);
  EXPECT_GT(counts[2.0], 0);
}

double quantile_of(const std::string& text, double quantile) {
  return read_yaml<double>(value_at(draw_of(text), quantile), "x");
}

TEST(Draw, HasQuantiles) {
  EXPECT_DOUBLE_EQ(quantile_of("{uniform: [2, 4]}", 0.25), 2.5);
  EXPECT_DOUBLE_EQ(quantile_of("{log_uniform: [1, 100]}", 0.5), 10.0);
  EXPECT_EQ(quantile_of("{integer: [3, 6]}", 0.0), 3.0);
  EXPECT_EQ(quantile_of("{integer: [3, 6]}", 0.74), 5.0);
  EXPECT_EQ(quantile_of("{integer: [3, 6]}", 0.9999), 6.0);
  EXPECT_EQ(quantile_of("{choice: [7, 8, 9], weights: [1, 0, 3]}", 0.2), 7.0);
  EXPECT_EQ(quantile_of("{choice: [7, 8, 9], weights: [1, 0, 3]}", 0.3), 9.0);
  EXPECT_EQ(quantile_of("12.5", 0.3), 12.5);
  // 0.8954 = 0.1587 + 0.9 (0.9772 - 0.1587), the normal distribution at 1.2557, -1, 2 and -1.
  EXPECT_NEAR(quantile_of("{normal: {mean: 0, sd: 1, min: -1, max: 2}}", 0.9), 1.2557, 1e-3);
  EXPECT_EQ(quantile_of("{normal: {mean: 0, sd: 1, min: 50, max: 60}}", 0.5), 50.0);
}

TEST(Draw, QuantilesAreThoseOfItsDraws) {
  for (const char* text : {"{uniform: [2, 4]}", "{log_uniform: [1, 100]}", "{integer: [0, 9]}",
                           "{normal: {mean: 1, sd: 2, min: -1, max: 2}}"}) {
    const std::vector<double> drawn = numbers(text, 4000);
    std::vector<double> even;
    for (int i = 0; i < 4000; ++i) even.push_back(quantile_of(text, (i + 0.5) / 4000.0));
    double squares = 0.0;
    for (const double value : even) squares += std::pow(value - mean_of(even), 2.0);
    const double sigma = std::sqrt(squares) / 4000.0;
    EXPECT_NEAR(mean_of(drawn), mean_of(even), 5.0 * sigma) << text;
  }
}

TEST(Draw, NumbersAreWrittenShort) {
  for (const double value : numbers("{uniform: [0, 1]}", 100)) {
    EXPECT_LE(write_yaml(value).scalar.size(), 12U);
  }
}

TEST(Draw, RefusesWhatCannotBeDrawn) {
  EXPECT_TRUE(contains(
      draw_refusal("{unifrom: [0, 1]}"),
      "d.yaml:1: x.unifrom: 'unifrom' is not a known distribution; did you mean 'uniform'?"));
  EXPECT_TRUE(contains(draw_refusal("{uniform: [2, 1]}"), "the lower end comes first"));
  EXPECT_TRUE(contains(draw_refusal("{log_uniform: [0, 1]}"), "needs positive ends"));
  EXPECT_TRUE(contains(draw_refusal("{integer: [1]}"), "takes two whole numbers"));
  EXPECT_TRUE(contains(draw_refusal("{integer: [1.5, 2]}"), "expected a whole number"));
  EXPECT_TRUE(contains(draw_refusal("{integer: [3, 2]}"), "the lower end comes first"));
  EXPECT_TRUE(contains(draw_refusal("{choice: []}"), "'choice' is empty"));
  EXPECT_TRUE(
      contains(draw_refusal("{choice: [1, 2], weights: [1]}"), "1 'weights' for 2 choices"));
  EXPECT_TRUE(contains(draw_refusal("{choice: [1], weights: [0]}"), "nor all be 0"));
  EXPECT_TRUE(contains(draw_refusal("{uniform: [0, 1], weights: [1]}"), "go with 'choice' only"));
  EXPECT_TRUE(contains(draw_refusal("{uniform: [0, 1], integer: [0, 1]}"), "give one of them"));
  EXPECT_TRUE(contains(draw_refusal("{normal: {mean: 1, sd: 0, min: 0, max: 1}}"), "'sd' must be"));
  EXPECT_TRUE(contains(draw_refusal("{normal: {mean: 1, sd: 1, min: 0}}"), "needs the key 'max'"));
  EXPECT_TRUE(contains(draw_refusal("{}"), "does not state a distribution"));
}

}  // namespace
}  // namespace castaway::testbed
