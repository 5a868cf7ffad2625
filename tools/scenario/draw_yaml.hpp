/// Distributions of the values of a data set, as YAML.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "localization/geometry/random.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// A constant.
struct FixedDraw {
  YamlNode value;
};

/// One of several options, by weight.
struct ChoiceDraw {
  std::vector<YamlNode> options;  ///< At least one.
  std::vector<double> weights;    ///< One per option; their sum is positive.
};

/// Uniform between two numbers or, if `logarithmic`, between their logarithms.
struct UniformDraw {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;  ///< Requires a positive `low`.
};

/// Normal, truncated by rejection.
struct NormalDraw {
  double mean = 0.0;
  double sd = 1.0;  ///< Positive.
  double min = 0.0;
  double max = 0.0;
};

/// A uniform integer, both ends included.
struct IntegerDraw {
  int low = 0;
  int high = 1;
};

using Draw = std::variant<FixedDraw, ChoiceDraw, UniformDraw, NormalDraw, IntegerDraw>;

/// Parses a distribution:
///
///     12.5, office, [1, 2, 3]                         # fixed
///     {value: {count: 3}}                             # fixed, a map
///     {choice: [office, lab], weights: [3, 1]}
///     {uniform: [0.5, 2]}
///     {log_uniform: [0.01, 1]}
///     {normal: {mean: 1, sd: 0.2, min: 0, max: 2}}    # min and max are needed
///     {integer: [0, 8]}
///
/// Throws std::runtime_error naming file, line, key and remedy.
Draw read_draw(YamlReader value);

/// Draws a value. Numbers that are not integers are rounded to six digits. After a thousand
/// rejections, a normal value is clamped to its limits.
YamlNode draw_value(const Draw& draw, localization::Rng& rng);

/// The value below which a share `quantile`, [0, 1), of the distribution lies; of a choice, in the
/// order of its options.
YamlNode value_at(const Draw& draw, double quantile);

}  // namespace castaway::testbed
