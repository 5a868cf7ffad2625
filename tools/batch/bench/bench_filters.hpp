/// Five particle populations in the localizer's implementation and in the plain reference, with the
/// steps that benchmarks time.
#pragma once

#include <vector>

#include "localization/filter/particle_set.hpp"
#include "localization/paper/ray_local_model.hpp"
#include "localization/sensor/evidence_model.hpp"
#include "tools/batch/bench/bench_scene.hpp"
#include "tools/batch/bench/plain_reference.hpp"

namespace castaway::testbed {

/// The localizer's own implementation. The scene must outlive it; copies are independent.
class FastFilters {
 public:
  static constexpr int kPopulations = 5;
  static constexpr int kParticles = 200;  ///< Per population.

  /// Spreads all populations around the scene's pose by 0.1 m and 0.05 rad.
  explicit FastFilters(const BenchScene& scene);

  void predict();                  ///< By the motion of 10 ms.
  void correct();                  ///< By the end point model, as in mode `improved`.
  void correct_by_rays();          ///< By the ray model, as in mode `paper`.
  void reseed();                   ///< Around the scene's pose.
  double evidence() const;         ///< Sum of the evidence at the means of the populations.
  double update();                 ///< Predicts, corrects, computes the evidence and reseeds.
  double mean_log_weight() const;  ///< Over all particles.

 private:
  const BenchScene* scene_;
  localization::EndpointModel endpoints_;
  localization::RayLocalModel rays_;
  localization::EvidenceModel evidence_;
  localization::PoseGaussian winner_;
  localization::Rng rng_;
  std::vector<localization::ParticleSet> populations_;
};

/// The same steps by the plain reference, starting from the same particles.
class PlainFilters {
 public:
  explicit PlainFilters(const BenchScene& scene);

  void predict();
  void correct();
  void correct_by_rays();
  void reseed();
  double evidence() const;
  double update();
  double mean_log_weight() const;

 private:
  const BenchScene* scene_;
  PlainScan scan_;
  localization::Rng rng_;
  std::vector<std::vector<PlainParticle>> populations_;
};

}  // namespace castaway::testbed
