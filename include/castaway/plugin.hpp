/// A localizer for castaway as a C++17 class, in a shared library. Header-only; needs nothing but
/// the standard library.
///
///     #include <castaway/plugin.hpp>
///
///     class Mine {
///      public:
///       explicit Mine(const castaway::plugin::Setup& setup);
///       void initialize(const std::optional<castaway::plugin::Start>& start);
///       void on_odometry(const castaway::plugin::OdometryReading& odometry);
///       std::optional<castaway::plugin::Estimate> on_scan(const castaway::plugin::Scan& scan);
///     };
///     CASTAWAY_LOCALIZER(Mine)
///
///     g++ -O2 -shared -fPIC mine.cpp -o libmine.so
///     castaway run --localizer library:./libmine.so
///
/// An exception ends the localizer in its run; its text is in the message.
#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <castaway/localizer.h>

namespace castaway::plugin {

using Pose = castaway_pose;              ///< x, y [m], yaw [rad]
using Hypothesis = castaway_hypothesis;  ///< pose, probability
using LidarModel = castaway_lidar;       ///< Valid as long as the call.
using Scan = castaway_scan;              ///< Valid as long as the call.
using OdometryReading = castaway_odometry;
using Covariance = std::array<double, 9>;  ///< Of (x, y, yaw), row by row.

/// What a localizer is created with.
struct Setup {
  std::string name;
  std::uint64_t seed = 0;
  std::string map_file;     ///< Empty: there is none.
  int width = 0;            ///< [cells]
  int height = 0;           ///< [cells]
  double resolution = 0.0;  ///< [m]
  Pose origin{};            ///< Lower left corner of cell 0 in map.
  std::vector<std::int8_t>
      cells;           ///< Rows from the smallest y: -1 unknown, 0 free ... 100 occupied.
  std::string params;  ///< JSON object.
};

/// A known start.
struct Start {
  Pose pose{};
  Covariance covariance{};
};

/// The answer to a scan.
struct Estimate {
  Pose pose{};  ///< Of base in map, at the scan's stamp.
  Covariance covariance{};
  /// In [0, 1] that the pose is right; NaN: not stated.
  double probability = std::numeric_limits<double>::quiet_NaN();
  double quality = std::numeric_limits<double>::quiet_NaN();  ///< In [0, 1]; NaN: not stated.
  bool lost = false;                                          ///< The pose must not be used.
  std::vector<Hypothesis> hypotheses;
};

/// The C functions of a class. Errors are kept as text.
template <typename Localizer>
class LocalizerFunctions {
 public:
  static const castaway_localizer_functions* table() {
    static const castaway_localizer_functions functions{sizeof(castaway_localizer_functions),
                                                        CASTAWAY_LOCALIZER_VERSION,
                                                        create,
                                                        destroy,
                                                        initialize,
                                                        on_odometry,
                                                        on_scan,
                                                        error};
    return &functions;
  }

 private:
  struct Instance {
    explicit Instance(const Setup& setup) : localizer(setup) {}
    Localizer localizer;
    std::vector<Hypothesis> hypotheses;
    std::string error;
  };

  static std::string& creation_error() {
    static thread_local std::string text;
    return text;
  }

  /// Runs `body`; its exception becomes `text`.
  template <typename Body>
  static bool succeeds(std::string& text, Body&& body) {
    try {
      body();
      return true;
    } catch (const std::exception& exception) {
      text = exception.what();
    } catch (...) {
      text = "threw something that is no std::exception";
    }
    return false;
  }

  static Setup setup_of(const castaway_setup& c) {
    const auto cells =
        static_cast<std::size_t>(c.map.width) * static_cast<std::size_t>(c.map.height);
    return {c.name,
            c.seed,
            c.map.file == nullptr ? "" : c.map.file,
            c.map.width,
            c.map.height,
            c.map.resolution,
            c.map.origin,
            {c.map.cells, c.map.cells + cells},
            c.params};
  }

  static void* create(const castaway_setup* setup) {
    Instance* made = nullptr;
    succeeds(creation_error(), [&] { made = new Instance(setup_of(*setup)); });
    return made;
  }

  static void destroy(void* instance) { delete static_cast<Instance*>(instance); }

  template <typename Body>
  static int call(void* instance, Body&& body) {
    auto& made = *static_cast<Instance*>(instance);
    return succeeds(made.error, [&] { body(made); }) ? 0 : 1;
  }

  static int initialize(void* instance, const castaway_start* start) {
    return call(instance, [&](Instance& made) {
      std::optional<Start> known;
      if (start != nullptr) {
        known.emplace();
        known->pose = start->pose;
        for (std::size_t i = 0; i < 9; ++i) known->covariance[i] = start->covariance[i];
      }
      made.localizer.initialize(known);
    });
  }

  static int on_odometry(void* instance, const castaway_odometry* odometry) {
    return call(instance, [&](Instance& made) { made.localizer.on_odometry(*odometry); });
  }

  static int on_scan(void* instance, const castaway_scan* scan, castaway_estimate* answer) {
    return call(instance, [&](Instance& made) {
      std::optional<Estimate> estimate = made.localizer.on_scan(*scan);
      if (!estimate) return;
      answer->has_pose = 1;
      answer->lost = estimate->lost ? 1 : 0;
      answer->pose = estimate->pose;
      for (std::size_t i = 0; i < 9; ++i) answer->covariance[i] = estimate->covariance[i];
      answer->probability = estimate->probability;
      answer->quality = estimate->quality;
      made.hypotheses = std::move(estimate->hypotheses);
      answer->hypotheses = made.hypotheses.data();
      answer->hypothesis_count = made.hypotheses.size();
    });
  }

  static const char* error(void* instance) {
    return instance == nullptr ? creation_error().c_str()
                               : static_cast<Instance*>(instance)->error.c_str();
  }
};

}  // namespace castaway::plugin

/// Makes a class the localizer of its library.
#define CASTAWAY_LOCALIZER(Class)                                                       \
  extern "C" CASTAWAY_EXPORT const castaway_localizer_functions* castaway_localizer() { \
    return castaway::plugin::LocalizerFunctions<Class>::table();                        \
  }
