/// Names of nested models that Gazebo classic saved as one model.
#pragma once

#include <string>

#include <tinyxml.h>

namespace castaway::sim {

/// `name` with "/" for each "::".
std::string unscoped_name(const std::string& name);

/// Gives plain names to everything in a model that is called `inner::body` or alike, and to what
/// refers to it. To Gazebo classic, which flattens nested models, these are names like any other;
/// libsdformat 12 takes "::" for the path to a nested model, and breaks an assertion on some.
void unscope_names(TiXmlElement& model);

}  // namespace castaway::sim
