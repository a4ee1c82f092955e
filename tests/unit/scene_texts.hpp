// Texts of scenes that the tests of lib/scene share.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/error.hpp"
#include "scene/scene.hpp"

namespace slidezone {

inline constexpr Needs no_needs{};
inline constexpr Needs run_needs{.grid = true, .soil = true, .time = true};

/// The message of the Error that `act` throws; fails the test if it throws none.
inline std::string message_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::data) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

/// A scene of its own tables only: those that the others need, with every optional key left out.
inline const std::string slope_text = "[slope]\nheight = \"2 m\"\nlength = \"6 m\"\nangle = \"45 deg\"\n";
inline const std::string grid_text = "[grid]\ncell = \"0.5 m\"\nwidth = \"10 m\"\nheight = \"3 m\"\n";
inline const std::string soil_text =
    "[[soil]]\nname = \"clay\"\ndensity = \"2000 kg/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.3\ncohesion = \"20 kPa\"\n";
inline const std::string run_text = "[base]\nfriction = 0.3\n[time]\nend = \"5 s\"\n";
inline const std::string least = slope_text + grid_text + soil_text + run_text;

inline Scene parse(const std::string& text, Needs needs = no_needs) { return parse_scene(text, "s.toml", needs); }

}  // namespace slidezone
