/// How the drawn keys of a campaign are spread over its seeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Designs of experiments.
enum class Design : std::uint8_t {
  kIndependent,  ///< Each value is drawn by itself.
  /// Every key has one value in each of as many equally likely strata as there are seeds (M. D.
  /// McKay et al., "A comparison of three methods for selecting values of input variables",
  /// Technometrics 21, 1979).
  kLatinHypercube,
  /// A Sobol sequence, shifted at random (R. Cranley, T. Patterson, "Randomization of number
  /// theoretic methods for multiple integration", SIAM J. Numer. Anal. 13, 1976).
  kSobol,
  /// Two such samples, and the first one with one key after the other taken from the second one,
  /// the seed of the run among them, for sensitivity indices (A. Saltelli et al., "Variance based
  /// sensitivity analysis of model output", Computer Physics Communications 181, 2010).
  kSaltelli,
};

/// Of "independent", "latin_hypercube", "sobol" and "saltelli", in the order of `Design`.
extern const std::vector<std::string> kDesignNames;

/// The samples of a campaign: each combination of its grid has one cell for each.
class SampleDesign {
 public:
  SampleDesign() = default;
  /// `root`: seed of all draws. `seeds`: number of seeds. `keys`: paths of the drawn keys.
  SampleDesign(Design design, std::uint64_t root, int seeds, const std::vector<std::string>& keys);

  /// `seeds`, except for `kSaltelli`: so many for each of two samples, each key, and the seed.
  [[nodiscard]] int samples() const;
  /// The seed of a sample's runs, less the first one.
  [[nodiscard]] int seed_offset(int sample) const;
  /// Where the value of a key lies in its distribution, [0, 1); `key` is its index. Not for
  /// `kIndependent`.
  [[nodiscard]] double quantile(int sample, std::size_t key) const;

  [[nodiscard]] Design design() const { return design_; }
  [[nodiscard]] int seeds() const { return seeds_; }

 private:
  /// The block of `seeds` samples that a sample belongs to: of `kSaltelli`, 0 and 1 are the two
  /// samples, then one for each key, then that of the seed.
  [[nodiscard]] std::size_t block(int sample) const {
    return static_cast<std::size_t>(sample / seeds_);
  }
  /// True if a block takes key `key` from the second sample; `keys_` stands for the seed.
  [[nodiscard]] bool from_second(std::size_t block, std::size_t key) const;

  Design design_ = Design::kIndependent;
  int seeds_ = 1;
  std::size_t keys_ = 0;
  /// By seed, then key; of `kSaltelli`, those of the second sample follow.
  std::vector<double> quantiles_;
};

}  // namespace castaway::testbed
