/// Parameters of xacro macros.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace castaway::xacro {

/// A parameter of a macro.
struct Parameter {
  enum class Kind {
    kValue,    ///< `name`
    kBlock,    ///< `*name`: an element of the call.
    kContent,  ///< `**name`: the children of an element of the call.
  };

  std::string name;  ///< Without stars.
  Kind kind = Kind::kValue;
  bool from_outside = false;  ///< `:=^`: defaults to the caller's property of the same name.
  /// Text of the default; nothing: the call must give the value.
  std::optional<std::string> fallback;
};

/// Parses `params="a b:=1 c:='x y' d:=^ e:=^|2 f:=^3 *block **content"`.
/// @throws std::invalid_argument naming an invalid parameter.
std::vector<Parameter> parse_parameters(const std::string& text);

}  // namespace castaway::xacro
