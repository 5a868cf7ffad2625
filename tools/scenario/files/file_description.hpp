/// The description at the top of a shipped file.
#pragma once

#include <filesystem>
#include <string>

namespace castaway::testbed {

/// The first sentence of the first comment in a YAML or XML file, without its full stop; empty if
/// no comment precedes the content. Throws FileError if the file cannot be read.
std::string first_sentence(const std::filesystem::path& file);

/// The text, cut between two words to at most `most` characters, "..." included.
std::string shorten(const std::string& text, std::size_t most);

}  // namespace castaway::testbed
