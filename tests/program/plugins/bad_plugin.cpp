// A localizer that throws: at its creation, or, with params {until: N}, at its N-th scan.
#include <castaway/localizer.hpp>
#include <stdexcept>

namespace {

class Bad {
 public:
  explicit Bad(const castaway::Setup& setup) {
    const std::size_t at = setup.params.find("until");
    if (at == std::string::npos) throw std::runtime_error("no map\nto my taste");
    until_ = std::stoi(setup.params.substr(at + 7));
  }
  void initialize(const std::optional<castaway::Start>&) {}
  void on_odometry(const castaway::OdometryReading&) {}
  std::optional<castaway::Estimate> on_scan(const castaway::Scan&) {
    if (--until_ == 0) throw std::runtime_error("lost its patience");
    return std::nullopt;
  }

 private:
  int until_ = 0;
};

}  // namespace

CASTAWAY_LOCALIZER(Bad)
