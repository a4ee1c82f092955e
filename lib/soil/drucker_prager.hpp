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
#include <limits>
#include <type_traits>

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
template <class Real>
struct SoilConstantsOf {
  Real bulk = 0;
  Real shear = 0;
  Real peak_friction_angle = 0;
  Real residual_friction_angle = 0;
  Real residual_cohesion = 0;
  Real softening_threshold = 0;
  Real softening_shape = 0;
  Real q_psi = 0;
  Real tension_cutoff = 0;
  Real inverse_bulk = 0;  // a product takes a tenth of the time of a quotient
  Real inverse_shear = 0;
};
using SoilConstants = SoilConstantsOf<double>;

/// Stands for an infinite cut-off: finite, so that its product with q_phi = 0 is 0.
inline constexpr double no_cutoff = 1e30;  // Pa

/// Slope of the cone, 3 tan(angle) / sqrt(9 + 12 tan^2(angle)).
inline double cone_slope(double angle) {
  const double tangent = std::tan(angle);
  return 3 * tangent / std::sqrt(9 + 12 * tangent * tangent);
}

template <class Real = double>
SoilConstantsOf<Real> soil_constants(const Material& soil) {
  const ElasticModuli moduli = elastic_moduli(soil);
  return {static_cast<Real>(moduli.bulk),
          static_cast<Real>(moduli.shear),
          static_cast<Real>(soil.peak_friction_angle),
          static_cast<Real>(soil.residual_friction_angle),
          static_cast<Real>(soil.residual_cohesion),
          static_cast<Real>(soil.softening_threshold),
          static_cast<Real>(soil.softening_shape),
          static_cast<Real>(cone_slope(soil.dilation_angle)),
          static_cast<Real>(std::min(soil.tension_cutoff, no_cutoff)),
          static_cast<Real>(1 / moduli.bulk),
          static_cast<Real>(1 / moduli.shear)};
}

/// The yield surfaces at one plastic strain.
template <class Real>
struct YieldSurfaceOf {
  Real q_phi = 0;
  Real k_c = 0;
  Real tension = 0;  // s_t
};
using YieldSurface = YieldSurfaceOf<double>;

/// Part of the peak strength that is left: 1 up to the threshold, then exp(-eta (e - e_0)).
template <class Real>
SLIDEZONE_INLINE Real unsoftened_part(const SoilConstantsOf<Real>& soil, Real plastic_strain) {
  const Real beyond = plastic_strain - soil.softening_threshold;
  return portable_exp<Fast>(-soil.softening_shape * (beyond > 0 ? beyond : 0));
}

template <SoilTraits traits, class Real>
SLIDEZONE_INLINE YieldSurfaceOf<Real> yield_surface(const SoilConstantsOf<Real>& soil, std::type_identity_t<Real> peak_cohesion,
                                                    std::type_identity_t<Real> plastic_strain) {
  Real cohesion = peak_cohesion;
  Real friction_angle = soil.peak_friction_angle;
  if constexpr (traits.has_softening) {
    const Real part = unsoftened_part(soil, plastic_strain);
    cohesion = soil.residual_cohesion + (peak_cohesion - soil.residual_cohesion) * part;
    friction_angle = soil.residual_friction_angle + (soil.peak_friction_angle - soil.residual_friction_angle) * part;
  }
  if constexpr (!traits.has_cone) return {0, cohesion, 0};
  const Real tangent = portable_tangent(friction_angle);
  const Real matched = 3 / std::sqrt(9 + 12 * tangent * tangent);
  const Real q_phi = tangent * matched;
  const Real k_c = cohesion * matched;
  const Real cut = soil.tension_cutoff;
  return {q_phi, k_c, cut * q_phi <= k_c ? cut : k_c / q_phi};
}

/// What a yield surface sees of a stress.
template <class Real>
struct InvariantsOf {
  Real mean = 0;  // s_m
  Real j2 = 0;    // J2
};

template <class Real>
SLIDEZONE_INLINE InvariantsOf<Real> invariants(const StressOf<Real>& stress) {
  constexpr Real third = Real{1} / 3;
  constexpr Real half = 0.5;
  const Real mean = (stress.xx + stress.yy + stress.zz) * third;
  const Real dev_xx = stress.xx - mean;
  const Real dev_yy = stress.yy - mean;
  const Real dev_zz = stress.zz - mean;
  return {mean, half * (dev_xx * dev_xx + dev_yy * dev_yy + dev_zz * dev_zz) + stress.xy * stress.xy};
}

/// tau = sqrt(J2) and its reciprocal, which is finite where tau is 0.
template <class Real>
struct ShearOf {
  Real tau = 0;
  Real inverse = 0;
};

template <class Real>
SLIDEZONE_INLINE ShearOf<Real> shear_of(Real j2) {
  const Real tau = std::sqrt(j2);
  return {tau, 1 / (tau > std::numeric_limits<Real>::min() ? tau : std::numeric_limits<Real>::min())};
}

/// What the return to the yield surface leaves of a trial stress, and what it costs.
template <class Real>
struct ReturnOf {
  Real kept = 1;            // part of the deviatoric stress
  Real mean = 0;            // s_m
  Real plastic_strain = 0;  // increment of the equivalent plastic strain
};

/// The way back to the yield surface for stresses outside it; others keep everything.
template <SoilTraits traits, class Real>
SLIDEZONE_INLINE ReturnOf<Real> way_back(Real mean, ShearOf<Real> shear, const SoilConstantsOf<Real>& soil,
                                         const YieldSurfaceOf<Real>& yield) {
  constexpr Real third = Real{1} / 3;
  const Real tau = shear.tau;
  const Real G = soil.shear;
  const Real K = soil.bulk;

  Real shear_multiplier = 0;
  Real tension_multiplier = 0;
  if constexpr (!traits.has_cone) {
    const Real outside = tau - yield.k_c;
    shear_multiplier = (outside > 0 ? outside : 0) * soil.inverse_shear;
  } else {
    const Real outside = tau + yield.q_phi * mean - yield.k_c;
    const Real tau_at_cut = yield.k_c - yield.q_phi * yield.tension;
    const Real shear_alone = (outside > 0 ? outside : 0) * (1 / (G + K * yield.q_phi * soil.q_psi));
    const bool is_above_cut = mean - K * soil.q_psi * shear_alone > yield.tension;
    const Real to_corner = tau > tau_at_cut ? (tau - tau_at_cut) * soil.inverse_shear : 0;
    shear_multiplier = is_above_cut ? to_corner : shear_alone;
    tension_multiplier = is_above_cut ? (mean - yield.tension) * soil.inverse_bulk - soil.q_psi * shear_multiplier : 0;
  }

  const Real kept = 1 - G * shear_multiplier * shear.inverse;
  const Real by_shear_alone = __builtin_assoc_barrier(shear_multiplier * std::sqrt(third));
  if constexpr (!traits.has_cone) return {kept, mean, by_shear_alone};
  const Real volumetric = soil.q_psi * shear_multiplier + tension_multiplier;
  const Real by_both = std::sqrt(third * shear_multiplier * shear_multiplier + Real{2} / 9 * volumetric * volumetric);
  return {kept, mean - K * volumetric, volumetric == 0 ? by_shear_alone : by_both};
}

template <class Real>
SLIDEZONE_INLINE StressOf<Real> returned(const StressOf<Real>& trial, Real trial_mean, const ReturnOf<Real>& back) {
  return {back.mean + back.kept * (trial.xx - trial_mean), back.mean + back.kept * (trial.yy - trial_mean),
          back.mean + back.kept * (trial.zz - trial_mean), back.kept * trial.xy};
}

/// Takes `stress` back to the yield surface where it lies outside; returns the increment of the equivalent plastic strain.
template <SoilTraits traits, class Real>
SLIDEZONE_INLINE Real return_to_yield(StressOf<Real>& stress, const SoilConstantsOf<Real>& soil, const YieldSurfaceOf<Real>& yield) {
  const InvariantsOf<Real> trial = invariants(stress);
  const ReturnOf<Real> back = way_back<traits>(trial.mean, shear_of(trial.j2), soil, yield);
  stress = returned(stress, trial.mean, back);
  return back.plastic_strain;
}

}  // namespace slidezone
