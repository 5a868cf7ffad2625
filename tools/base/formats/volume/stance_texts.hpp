/// How a robot stands, as texts of the record `run` of a bag.
#pragma once

#include <map>
#include <string>

#include "localization/space/map3d/wheel_stance.hpp"

namespace castaway::testbed {

using Texts = std::map<std::string, std::string>;

/// `wheels`: x and y of each contact with the ground, `centre_of_mass`: x, y and z, in base [m], in
/// full precision. Nothing if wheels are not known.
Texts texts_of(const localization::WheelStance& wheels);

/// What `texts_of` wrote among other texts; unknown wheels if it is not there. Throws
/// std::runtime_error naming the text that is malformed.
localization::WheelStance wheels_in(const Texts& texts);

}  // namespace castaway::testbed
