/// Converts messages of a bag to JSON, for the types in castaway's own bags.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// Fields of a CDR message; nothing for an unknown type. Throws std::runtime_error if the message
/// is malformed.
std::optional<nlohmann::ordered_json> message_json(const std::string& type, std::string_view data);

}  // namespace castaway::testbed
