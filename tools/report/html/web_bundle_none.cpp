// Built instead of the bundle where there is no Node.js.
#include "tools/report/html/web_bundle.hpp"

namespace castaway::testbed {

std::optional<WebBundle> web_bundle() { return std::nullopt; }

}  // namespace castaway::testbed
