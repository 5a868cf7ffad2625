/// The elementary functions are those of `elementary`, in castaway and in the libraries beside it.
#include <dlfcn.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// FNV-1a of the bits of `function` at 4000 arguments in (0, `to`).
template <typename Number>
std::uint64_t hash_of(const std::function<Number(Number)>& function, Number to) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (int i = 1; i <= 4000; ++i) {
    const double value = function(to * static_cast<Number>(i) / Number{4001});
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
  }
  return hash;
}

TEST(ElementaryFunctions, HaveTheSameBitsOnEveryCpu) {
  using D = double;
  EXPECT_EQ(hash_of<D>([](D x) { return std::exp(x - 20.0); }, 40.0), 3190418688121839510U);
  EXPECT_EQ(hash_of<D>([](D x) { return std::log(x); }, 40.0), 6236932617130318682U);
  EXPECT_EQ(hash_of<D>([](D x) { return std::sin(x) + 2.0 * std::cos(x); }, 40.0),
            7216010938766273370U);
  EXPECT_EQ(hash_of<D>([](D x) { return std::tan(x); }, 1.5), 2241427296465552945U);
  EXPECT_EQ(hash_of<D>([](D x) { return std::atan2(x, 1.3) + std::acos(x); }, 1.0),
            10028317169901734085U);
  EXPECT_EQ(hash_of<D>([](D x) { return std::pow(x, 1.7) + std::hypot(x, 0.3); }, 9.0),
            16837547222341859460U);
  EXPECT_EQ(hash_of<float>([](float x) { return std::sin(x) + std::exp(x); }, 9.0F),
            14344723516968430501U);
}

/// File that the process has a function from.
std::string file_of(const char* function) {
  Dl_info info{};
  void* address = dlsym(RTLD_DEFAULT, function);
  return address != nullptr && dladdr(address, &info) != 0 ? info.dli_fname : "";
}

TEST(ElementaryFunctions, AreTheProgramsOwnForEveryLibrary) {
  Dl_info here{};
  static const int kHere = 0;
  ASSERT_NE(dladdr(&kHere, &here), 0);
  for (const char* name :
       {"exp", "log", "sin", "cos", "sincos", "atan2", "acosf", "powf", "hypot"}) {
    EXPECT_EQ(file_of(name), here.dli_fname) << name;
  }
}

}  // namespace
}  // namespace castaway::localization
