/// Reads XML files that are not trusted.
#pragma once

#include <memory>
#include <string>

#include <tinyxml.h>

namespace castaway {

/// Returns the text of a file of at most 16 MiB.
/// @throws std::runtime_error naming the file and the remedy.
std::string read_xml_text(const std::string& path);

/// Parses XML. Document types (and so entities), zero bytes, more than 200 levels, more than 200000
/// elements, or more than 1000 attributes of one element are refused before the parser, which
/// recurses, reads them.
/// @throws std::runtime_error naming file and line.
std::unique_ptr<TiXmlDocument> parse_xml(const std::string& path, const std::string& text);

/// A tree as indented text.
std::string xml_text_of(const TiXmlDocument& document);

/// Text of an attribute; empty if it is absent.
std::string attribute(const TiXmlElement& element, const char* name);

}  // namespace castaway
