/// Parameters of xacro macros.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace castaway::sim::xacro {

/// A parameter of a macro.
struct Parameter {
  enum class Kind {
    kValue,    ///< `name`
    kBlock,    ///< `*name`: an element of the call.
    kContent,  ///< `**name`: what is inside of an element of the call.
  };

  std::string name;  ///< Without stars.
  Kind kind = Kind::kValue;
  bool from_outside = false;            ///< `:=^`: the caller's property of the same name, if any.
  std::optional<std::string> fallback;  ///< Its text; nothing: the call must give it.
};

/// Parses `params="a b:=1 c:='x y' d:=^ e:=^|2 f:=^3 *block **content"`.
/// @throws std::invalid_argument naming a parameter that makes no sense.
std::vector<Parameter> parse_parameters(const std::string& text);

}  // namespace castaway::sim::xacro
