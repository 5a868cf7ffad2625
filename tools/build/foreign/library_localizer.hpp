/// A localizer in a shared library: castaway/localizer.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "castaway/localizer.h"
#include "tools/build/foreign/answer.hpp"
#include "tools/build/foreign/message_text.hpp"
#include "tools/run/foreign_config.hpp"

namespace castaway::testbed {

/// Calls the functions of a library. What goes wrong in them is thrown as LocalizerFailure; a crash
/// of the library is one of castaway.
class LibraryLocalizer final : public localization::Localizer {
 public:
  /// Throws std::runtime_error if the library cannot be loaded, has another version of the
  /// interface, or makes no localizer.
  LibraryLocalizer(const LibraryConfig& config, const Greeting& greeting);

  void initialize(const std::optional<localization::PoseWithCovariance>& start) override;
  void on_odometry(const Odometry& odometry) override;
  void on_scan(const LaserScan& scan) override;
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override;
  [[nodiscard]] localization::Diagnostics diagnostics() const override;

 private:
  struct Close {
    void operator()(void* library) const;
  };
  struct Destroy {
    void (*destroy)(void*) = nullptr;
    void operator()(void* localizer) const { destroy(localizer); }
  };

  void require(int result) const;

  std::unique_ptr<void, Close> library_;
  const castaway_localizer_functions* functions_ = nullptr;
  std::unique_ptr<void, Destroy> localizer_{nullptr, Destroy{}};
  std::optional<Odometry> before_;
  Answer answer_;
};

}  // namespace castaway::testbed
