/// Reliability diagrams as inline SVG: stated probability against observed frequency, and how often
/// each was stated.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed {

/// The outputs of a localizer with nearly the same stated probability.
struct ReliabilityPoint {
  double stated = 0.0;    ///< In [0, 1]: their mean stated probability.
  double observed = 0.0;  ///< In [0, 1]: share that is right...
  double low = 0.0;       ///< ...and its confidence interval.
  double high = 1.0;
  std::int64_t scans = 0;
};

/// One localizer's points, by stated probability.
struct ReliabilityCurve {
  std::string name;
  std::size_t color = 0;  ///< Index of the style's colours.
  std::vector<ReliabilityPoint> points;
};

/// An `<svg>` element that fits its container. On the dotted diagonal a statement is what comes of
/// it; above it the localizer doubts too much, below it too little.
std::string render_reliability(const std::vector<ReliabilityCurve>& curves);

}  // namespace castaway::testbed
