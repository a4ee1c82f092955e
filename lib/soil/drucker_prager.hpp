// Drucker-Prager plasticity with a tension cut-off, non-associated flow and softening (Eqs. 8-22).
//
// With tau = sqrt(J2) and the mean stress s_m = (s_xx + s_yy + s_zz) / 3, tension positive:
//   shear    f_s = tau + q_phi s_m - k_c <= 0,   flow  g_s = tau + q_psi s_m
//   tension  f_t = s_m - s_t <= 0,               flow  g_t = s_m
//   q_phi = 3 tan(phi) / sqrt(9 + 12 tan^2(phi)),  k_c = 3 c / sqrt(9 + 12 tan^2(phi)),  q_psi from the dilation angle
// (the cone that matches Mohr-Coulomb in plane strain for associated flow; phi = 0 gives tau <= c, the Tresca limit of pure
// shear). s_t is the smaller of the material's cut-off and the cone's apex k_c / q_phi.
// Softening beyond the threshold e_0 of the equivalent plastic strain e:
//   c = c_r + (c_p - c_r) exp(-eta (e - e_0)),   phi likewise.
// The increment of e is sqrt(2/3 de_p : de_p) = sqrt(dl_s^2 / 3 + 2/9 (q_psi dl_s + dl_t)^2) with the multipliers dl of the two
// surfaces.
//
// Deviation: where both surfaces are active the return goes to their corner by Koiter's rule; the usual bisector between the
// two regions (Itasca) leaves such states outside one of the surfaces.
// Included by code that is compiled for several instruction sets: what it calls is inlined.
// Everything is free of branches, so that a loop over points vectorises. What a trait leaves out changes no bit of the result:
// hence the product with 1 / (G + ...) and the case apart for pure shear. Valid for finite stresses and G > 0, K > 0.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/portable_math.hpp"
#include "soil/elasticity.hpp"
#include "soil/material.hpp"

namespace slidezone {

/// What the soils of a scene need; a kernel is compiled for each combination and chosen once.
struct SoilTraits {
  bool has_cone = true;       // friction, dilation or a tension cut-off in some soil; otherwise tau <= c alone
  bool has_softening = true;  // residual below peak in some soil
  bool has_layers = true;     // several soils
};

/// Constants of one soil in the form that the return mapping needs.
struct SoilConstants {
  double bulk = 0;
  double shear = 0;
  double peak_friction_angle = 0;
  double residual_friction_angle = 0;
  double residual_cohesion = 0;
  double softening_threshold = 0;
  double softening_shape = 0;
  double q_psi = 0;
  double tension_cutoff = 0;
  double inverse_bulk = 0;  // a product takes a tenth of the time of a quotient
  double inverse_shear = 0;
};

/// Stands for an infinite cut-off: finite, so that its product with q_phi = 0 is 0.
inline constexpr double no_cutoff = 1e30;  // Pa

/// Slope of the cone, 3 tan(angle) / sqrt(9 + 12 tan^2(angle)).
inline double cone_slope(double angle) {
  const double tangent = std::tan(angle);
  return 3 * tangent / std::sqrt(9 + 12 * tangent * tangent);
}

inline SoilConstants soil_constants(const Material& soil) {
  const ElasticModuli moduli = elastic_moduli(soil);
  return {moduli.bulk,
          moduli.shear,
          soil.peak_friction_angle,
          soil.residual_friction_angle,
          soil.residual_cohesion,
          soil.softening_threshold,
          soil.softening_shape,
          cone_slope(soil.dilation_angle),
          std::min(soil.tension_cutoff, no_cutoff),
          1 / moduli.bulk,
          1 / moduli.shear};
}

/// The yield surfaces at one plastic strain.
struct YieldSurface {
  double q_phi = 0;
  double k_c = 0;
  double tension = 0;  // s_t
};

/// Part of the peak strength that is left: 1 up to the threshold, then exp(-eta (e - e_0)).
SLIDEZONE_INLINE double unsoftened_part(const SoilConstants& soil, double plastic_strain) {
  const double beyond = plastic_strain - soil.softening_threshold;
  return portable_exp<RoundedOnce>(-soil.softening_shape * (beyond > 0 ? beyond : 0));
}

template <SoilTraits traits>
SLIDEZONE_INLINE YieldSurface yield_surface(const SoilConstants& soil, double peak_cohesion, double plastic_strain) {
  double cohesion = peak_cohesion;
  double friction_angle = soil.peak_friction_angle;
  if constexpr (traits.has_softening) {
    const double part = unsoftened_part(soil, plastic_strain);
    cohesion = soil.residual_cohesion + (peak_cohesion - soil.residual_cohesion) * part;
    friction_angle = soil.residual_friction_angle + (soil.peak_friction_angle - soil.residual_friction_angle) * part;
  }
  if constexpr (!traits.has_cone) return {0, cohesion, 0};
  const double tangent = portable_tangent(friction_angle);
  const double matched = 3 / std::sqrt(9 + 12 * tangent * tangent);
  const double q_phi = tangent * matched;
  const double k_c = cohesion * matched;
  const double cut = soil.tension_cutoff;
  return {q_phi, k_c, cut * q_phi <= k_c ? cut : k_c / q_phi};
}

/// Takes `stress` back to the yield surface where it lies outside; returns the increment of the equivalent plastic strain.
template <SoilTraits traits>
SLIDEZONE_INLINE double return_to_yield(Stress& stress, const SoilConstants& soil, const YieldSurface& yield) {
  const double mean = (stress.xx + stress.yy + stress.zz) * (1.0 / 3.0);
  const double dev_xx = stress.xx - mean;
  const double dev_yy = stress.yy - mean;
  const double dev_zz = stress.zz - mean;
  const double tau = std::sqrt(0.5 * (dev_xx * dev_xx + dev_yy * dev_yy + dev_zz * dev_zz) + stress.xy * stress.xy);
  const double G = soil.shear;
  const double K = soil.bulk;

  double shear_multiplier = 0;
  double tension_multiplier = 0;
  if constexpr (!traits.has_cone) {
    shear_multiplier = (tau > yield.k_c ? tau - yield.k_c : 0) * soil.inverse_shear;
  } else {
    const double outside = tau + yield.q_phi * mean - yield.k_c;
    const double tau_at_cut = yield.k_c - yield.q_phi * yield.tension;
    const double shear_alone = (outside > 0 ? outside : 0) * (1 / (G + K * yield.q_phi * soil.q_psi));
    const bool is_above_cut = mean - K * soil.q_psi * shear_alone > yield.tension;
    const double to_corner = tau > tau_at_cut ? (tau - tau_at_cut) * soil.inverse_shear : 0;
    shear_multiplier = is_above_cut ? to_corner : shear_alone;
    tension_multiplier = is_above_cut ? (mean - yield.tension) * soil.inverse_bulk - soil.q_psi * shear_multiplier : 0;
  }

  const double kept = tau > 0 ? 1 - G * shear_multiplier / tau : 1;
  const double volumetric = soil.q_psi * shear_multiplier + tension_multiplier;
  const double new_mean = traits.has_cone ? mean - K * volumetric : mean;
  stress = {new_mean + kept * dev_xx, new_mean + kept * dev_yy, new_mean + kept * dev_zz, kept * stress.xy};
  const double by_shear_alone = __builtin_assoc_barrier(shear_multiplier * std::sqrt(1.0 / 3.0));
  if constexpr (!traits.has_cone) return by_shear_alone;
  return volumetric == 0 ? by_shear_alone
                         : std::sqrt(1.0 / 3.0 * shear_multiplier * shear_multiplier + 2.0 / 9.0 * volumetric * volumetric);
}

}  // namespace slidezone
