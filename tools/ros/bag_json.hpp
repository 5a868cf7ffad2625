/// Messages of a bag as JSON, for those types that our own bags hold.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// The fields of a CDR message; nothing of a type that is not known. Throws std::runtime_error
/// where the message is broken.
std::optional<nlohmann::ordered_json> message_json(const std::string& type, std::string_view data);

}  // namespace castaway::testbed
