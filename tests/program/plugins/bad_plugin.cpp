// A localizer that throws: at its creation, or, with params {until: N}, at its N-th scan. With
// {leave: exit} or {leave: now} it ends the program at its first scan.
#include <unistd.h>
#include <castaway/plugin.hpp>
#include <cstdlib>
#include <stdexcept>

namespace {

namespace plugin = castaway::plugin;
class Bad {
 public:
  explicit Bad(const plugin::Setup& setup) {
    if (setup.params.find("leave") != std::string::npos) {
      leave_ = setup.params.find("exit") != std::string::npos ? std::exit : _exit;
      return;
    }
    const std::size_t at = setup.params.find("until");
    if (at == std::string::npos) throw std::runtime_error("no map\nto my taste");
    until_ = std::stoi(setup.params.substr(at + 7));
  }
  void initialize(const std::optional<plugin::Start>&) {}
  void on_odometry(const plugin::OdometryReading&) {}
  std::optional<plugin::Estimate> on_scan(const plugin::Scan&) {
    if (leave_ != nullptr) leave_(0);
    if (--until_ == 0) throw std::runtime_error("lost its patience");
    return std::nullopt;
  }

 private:
  int until_ = 0;
  void (*leave_)(int) = nullptr;
};

}  // namespace

CASTAWAY_LOCALIZER(Bad)
