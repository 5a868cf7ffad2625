#include "sim/map/ambiguity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace castaway::sim {
namespace {

using Scan = std::vector<float>;

constexpr double kRadius = 0.2;  // [m] Smallest step of the lattice.
constexpr std::size_t kCoefficients = 12;
constexpr std::size_t kCandidates = 40;
constexpr std::size_t kRefined = 4;
constexpr int kLevels = 4;
using Signature = std::array<float, kCoefficients>;

/// Moduli of the first Fourier coefficients, which do not depend on the heading.
Signature signature_of(const Scan& scan) {
  Signature signature{};
  const auto n = static_cast<double>(scan.size());
  for (std::size_t k = 0; k < kCoefficients; ++k) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < scan.size(); ++i) {
      const double angle = -2.0 * std::numbers::pi * static_cast<double>(k * i) / n;
      sum += static_cast<double>(scan[i]) * std::polar(1.0, angle);
    }
    signature[k] = static_cast<float>(std::abs(sum) / n);
  }
  return signature;
}

float squared_distance(const Signature& a, const Signature& b) {
  float sum = 0.0F;
  for (std::size_t k = 0; k < kCoefficients; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

/// Likeness of a scan and another one that is turned by `shift` beams.
double likeness(const Scan& a, const Scan& b, std::size_t shift, double tolerance) {
  const auto limit = static_cast<float>(tolerance);
  float unlike = 0.0F;
  std::size_t j = shift;
  for (const float range : a) {
    unlike += std::min(std::abs(range - b[j]), limit);
    j = j + 1 == b.size() ? 0 : j + 1;
  }
  return 1.0 - static_cast<double>(unlike) / (tolerance * static_cast<double>(a.size()));
}

/// A pose that may resemble another one.
struct Candidate {
  Eigen::Vector2d place;
  double heading = 0.0;  ///< [rad]
  double likeness = 0.0;
};

/// A place of the lattice and its scan.
struct Seen {
  Eigen::Vector2d place;
  Scan scan;
  Signature signature;
};

class TwinSearch {
 public:
  TwinSearch(const RayScene& scene, const FreeSpace& free, const PlaceView& view,
             const AmbiguityConfig& config, double spacing)
      : scene_(scene), free_(free), view_(view), config_(config), spacing_(spacing) {
    for (const Eigen::Vector2d& place : even_places(free, spacing)) {
      Scan scan = scan_at(scene, place, 0.0, view);
      const Signature signature = signature_of(scan);
      seen_.push_back({place, std::move(scan), signature});
    }
  }

  /// Highest likeness of a pose elsewhere to the one at `place`.
  [[nodiscard]] double best(const Eigen::Vector2d& place) const {
    const Scan scan = scan_at(scene_, place, 0.0, view_);
    std::vector<Candidate> candidates = find_best_headings(scan, alike(place, signature_of(scan)));
    double result = 0.0;
    for (std::size_t i = 0; i < std::min(kRefined, candidates.size()); ++i) {
      result = std::max(result, refine(place, scan, candidates[i]).likeness);
    }
    return result;
  }

 private:
  /// Indices of the places elsewhere with the nearest signatures.
  [[nodiscard]] std::vector<std::size_t> alike(const Eigen::Vector2d& place,
                                               const Signature& signature) const {
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if ((seen_[i].place - place).norm() < config_.apart) continue;
      order.emplace_back(squared_distance(signature, seen_[i].signature), i);
    }
    const auto last =
        order.begin() + static_cast<std::ptrdiff_t>(std::min(kCandidates, order.size()));
    std::partial_sort(order.begin(), last, order.end());
    std::vector<std::size_t> result;
    for (auto it = order.begin(); it != last; ++it) result.push_back(it->second);
    return result;
  }

  /// Candidates at the places, each in its best heading, in descending order of likeness.
  [[nodiscard]] std::vector<Candidate> find_best_headings(
      const Scan& scan, const std::vector<std::size_t>& places) const {
    std::vector<Candidate> candidates;
    for (const std::size_t i : places) {
      Candidate best{seen_[i].place, 0.0, -1.0};
      for (std::size_t shift = 0; shift < scan.size(); ++shift) {
        const double like = likeness(scan, seen_[i].scan, shift, config_.tolerance);
        if (like <= best.likeness) continue;
        best.likeness = like;
        best.heading = 2.0 * std::numbers::pi * static_cast<double>(shift) / view_.beams;
      }
      candidates.push_back(best);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.likeness > b.likeness; });
    return candidates;
  }

  [[nodiscard]] Candidate make_candidate(const Scan& scan, const Eigen::Vector2d& place,
                                         double heading) const {
    return {place, heading,
            likeness(scan, scan_at(scene_, place, heading, view_), 0, config_.tolerance)};
  }

  /// Hill climbing; the step is halved where no neighbour is better.
  [[nodiscard]] Candidate refine(const Eigen::Vector2d& from, const Scan& scan,
                                 Candidate best) const {
    double step = 0.5 * spacing_;
    double turn = std::numbers::pi / view_.beams;
    for (int level = 0; level < kLevels; step *= 0.5, turn *= 0.5, ++level) {
      for (bool better = true; better;) {
        const Candidate next = best_neighbour(from, scan, best, step, turn);
        better = next.likeness > best.likeness + 1e-4;
        if (better) best = next;
      }
    }
    return best;
  }

  [[nodiscard]] Candidate best_neighbour(const Eigen::Vector2d& from, const Scan& scan,
                                         const Candidate& at, double step, double turn) const {
    Candidate best = at;
    const auto consider = [&](const Eigen::Vector2d& place, double heading) {
      if ((place - from).norm() < config_.apart || !free_.contains(place)) return;
      const Candidate next = make_candidate(scan, place, heading);
      if (next.likeness > best.likeness) best = next;
    };
    for (const auto& [dx, dy] :
         {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
      consider(at.place + step * Eigen::Vector2d(dx, dy), at.heading);
    }
    consider(at.place, at.heading + turn);
    consider(at.place, at.heading - turn);
    return best;
  }

  const RayScene& scene_;
  const FreeSpace& free_;
  PlaceView view_;
  AmbiguityConfig config_;
  double spacing_;
  std::vector<Seen> seen_;
};

}  // namespace

PlaceLikeness place_likeness(const RayScene& scene, const FreeSpace& free, const PlaceView& view,
                             const AmbiguityConfig& config) {
  const auto cells = std::count(free.grid().cells.begin(), free.grid().cells.end(), Cell::kFree);
  const double area = static_cast<double>(cells) * free.grid().resolution * free.grid().resolution;
  const double spacing = std::max(2.0 * kRadius, std::sqrt(area / config.most_places));
  const TwinSearch search(scene, free, view, config, std::max(kRadius, 0.5 * spacing));
  PlaceLikeness result{even_places(free, spacing), {}};
  for (const Eigen::Vector2d& place : result.places) result.likeness.push_back(search.best(place));
  return result;
}

Ambiguity ambiguity_of(const PlaceLikeness& places, const AmbiguityConfig& config) {
  std::vector<double> best = places.likeness;
  if (best.empty()) return {};
  std::sort(best.begin(), best.end());
  const auto count = static_cast<double>(best.size());
  const auto twins =
      std::count_if(best.begin(), best.end(), [&](double like) { return like >= config.twin; });
  return {std::accumulate(best.begin(), best.end(), 0.0) / count,
          best[static_cast<std::size_t>(0.9 * (count - 1.0))], static_cast<double>(twins) / count,
          static_cast<int>(best.size())};
}

}  // namespace castaway::sim
