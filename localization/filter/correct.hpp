/// Correction: every particle's weight is multiplied by the likelihood of the scan (paper, eq. 6,
/// in logarithms).
#pragma once

#include "localization/filter/particle_set.hpp"
#include "localization/sensor/endpoint_model.hpp"

namespace castaway::localization {

/// Weighs all particles by the scan.
void correct(ParticleSet& particles, const EndpointModel& model, const ScanPoints& points);

}  // namespace castaway::localization
