/// Who may talk to the server: those who know the token, from its own page.
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// 128 random bits as hexadecimal digits. Throws std::runtime_error if the system has none.
std::string random_token();

/// True if both are equal; takes as long whatever they have in common.
bool equal_tokens(std::string_view a, std::string_view b);

/// Value of a key in the query of a request's target: "/?token=ab&x=1". Empty if there is none.
std::string query_value(std::string_view target, std::string_view key);

/// As `query_value`, with %41 and + of an encoded value as what they stand for. A wrong code stays
/// as it is.
std::string decoded_query_value(std::string_view target, std::string_view key);

/// The target without its query.
std::string_view path_of(std::string_view target);

/// True for a Host header of a server at this port that names an IP address, or localhost: another
/// name may be another page's trick (DNS rebinding).
bool is_own_host(std::string_view host, unsigned port);

/// True for the Origin header of a page that was loaded from `host`.
bool is_own_origin(std::string_view origin, std::string_view host);

}  // namespace castaway::testbed
