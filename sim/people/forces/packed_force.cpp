#include "sim/people/forces/packed_force.hpp"

#include <algorithm>
#include <cmath>

#include "sim/common/wide_loops.hpp"

namespace castaway::sim {
namespace {

constexpr float kTiny = 1e-12F;          // [m^2] Keeps quotients finite; nearer people do not act.
constexpr float kRoundingShare = 1e-3F;  // By which the test of the cut-off is wider.
// A smaller sine counts as 0: to the left, as in `social_force`.
constexpr float kStraight = 1e-6F;

/// `SocialForceConfig` as `packed_force` needs it.
struct Coefficients {
  explicit Coefficients(const SocialForceConfig& config)
      : lambda(static_cast<float>(config.lambda)),
        gamma(static_cast<float>(config.gamma)),
        slowing(static_cast<float>(config.n_prime * config.n_prime)),
        turning(static_cast<float>(config.n * config.n)),
        strength(static_cast<float>(config.social)) {}

  float lambda;
  float gamma;
  float slowing;
  float turning;
  float strength;
};

/// [m/s^2]
struct PackedForce {
  float x;
  float y;
};

/// Square of an angle, from the square of the sine of its half. Its quotient by the square of the
/// sine of the quarter is a polynomial, by Chebyshev interpolation within 3e-7.
inline float squared_angle(float squared_sine_of_half) {
  const float cosine_of_half = std::sqrt(std::max(1.0F - squared_sine_of_half, 0.0F));
  const float z = 0.5F * squared_sine_of_half / (1.0F + cosine_of_half);
  return z * (16.000004F +
              z * (5.332511F +
                   z * (2.869493F +
                        z * (1.547463F + z * (2.758350F + z * (-2.675318F + z * 4.694012F))))));
}

/// exp(-x) up to the cut-off, then 0. The 16th power of a Taylor polynomial, within 1e-5.
inline float packed_decay(float x) {
  constexpr auto kEnd = static_cast<float>(kNegligible);
  const float y = std::min(x, 2.0F * kEnd) * (-1.0F / 16.0F);
  float p = 1.0F + y * (1.0F / 6.0F);
  p = 1.0F + y * (1.0F / 5.0F) * p;
  p = 1.0F + y * (1.0F / 4.0F) * p;
  p = 1.0F + y * (1.0F / 3.0F) * p;
  p = 1.0F + y * (1.0F / 2.0F) * p;
  p = 1.0F + y * p;
  p *= p;
  p *= p;
  p *= p;
  p *= p;
  return p * static_cast<float>(x <= kEnd);
}

/// As `social_force`, with its names.
inline PackedForce packed_force(const Coefficients& c, PackedPerson person, PackedPerson other) {
  const float dx = other.x - person.x;
  const float dy = other.y - person.y;
  const float squared = dx * dx + dy * dy;
  const float d = std::sqrt(std::max(squared, kTiny));
  const float ex = dx / d;
  const float ey = dy / d;
  const float Dx = c.lambda * (person.vx - other.vx) + ex;
  const float Dy = c.lambda * (person.vy - other.vy) + ey;
  const float length = std::sqrt(std::max(Dx * Dx + Dy * Dy, kTiny));
  const float tx = Dx / length;
  const float ty = Dy / length;
  const float B = c.gamma * length;
  const float half = 0.25F * ((tx - ex) * (tx - ex) + (ty - ey) * (ty - ey));
  const float bend = B * B * squared_angle(half);
  const float acts = c.strength * static_cast<float>(squared > kTiny);
  const float along = -acts * packed_decay(d / B + c.slowing * bend);
  const float aside = acts * packed_decay(d / B + c.turning * bend);
  const float left = -std::copysign(aside, tx * ey - ty * ex + kStraight);
  return {along * tx - left * ty, along * ty + left * tx};
}

}  // namespace

void PackedPeople::push_back(const PackedPerson& person) {
  x.push_back(person.x);
  y.push_back(person.y);
  vx.push_back(person.vx);
  vy.push_back(person.vy);
}

void PackedPeople::gather(const PackedPeople& from, const std::vector<std::size_t>& indices) {
  const auto copy = [&indices](const std::vector<float>& source, std::vector<float>& target) {
    target.resize(indices.size());
    for (std::size_t k = 0; k < indices.size(); ++k) target[k] = source[indices[k]];
  };
  copy(from.x, x);
  copy(from.y, y);
  copy(from.vx, vx);
  copy(from.vy, vy);
}

/// The force is zero where d > reach, and where d > kNegligible * B.
CASTAWAY_WIDE_LOOPS
void cut_off(const SocialForceConfig& config, PackedPerson person, const PackedPeople& others,
             std::size_t begin, std::size_t end, std::vector<float>& margins) {
  const float* const x = others.x.data() + begin;
  const float* const y = others.y.data() + begin;
  const float* const vx = others.vx.data() + begin;
  const float* const vy = others.vy.data() + begin;
  margins.resize(end - begin);
  float* const margin = margins.data();
  const auto lambda = static_cast<float>(config.lambda);
  const auto reach = static_cast<float>(config.reach);
  const auto longest = static_cast<float>(kNegligible * config.gamma);
  const float widest = longest * longest * (1.0F + kRoundingShare);
  const std::size_t count = end - begin;
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - person.x;
    const float dy = y[k] - person.y;
    const float squared = dx * dx + dy * dy;
    const float d = std::sqrt(std::max(squared, kTiny));
    const float Dx = lambda * (person.vx - vx[k]) + dx / d;
    const float Dy = lambda * (person.vy - vy[k]) + dy / d;
    margin[k] = std::min(reach * reach, widest * (Dx * Dx + Dy * Dy)) - squared;
  }
}

CASTAWAY_WIDE_LOOPS
void packed_forces(const SocialForceConfig& config, PackedPerson person, const PackedPeople& others,
                   PackedForces& forces) {
  const std::size_t count = others.size();
  forces.x.resize(count);
  forces.y.resize(count);
  const float* const x = others.x.data();
  const float* const y = others.y.data();
  const float* const vx = others.vx.data();
  const float* const vy = others.vy.data();
  float* const fx = forces.x.data();
  float* const fy = forces.y.data();
  const Coefficients coefficients(config);
  for (std::size_t k = 0; k < count; ++k) {
    const PackedForce f = packed_force(coefficients, person, {x[k], y[k], vx[k], vy[k]});
    fx[k] = f.x;
    fy[k] = f.y;
  }
}

}  // namespace castaway::sim
