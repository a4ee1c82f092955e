// A progress line on stderr. It shows only where stderr is a terminal, and not under --quiet; NO_COLOR is honoured.
#pragma once

#include <string>

namespace slidezone {

class Progress {
 public:
  enum class Show { on_terminal, never };

  /// `what` names the work, e.g. "mpmrun".
  Progress(std::string what, Show show);
  ~Progress();  // clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Fraction done in [0, 1] and a few words on the state; repaints at most every percent.
  void update(double fraction, const std::string& state);

 private:
  std::string what_;
  bool is_shown_;
  bool has_color_;
  int last_percent_ = -1;
};

}  // namespace slidezone
