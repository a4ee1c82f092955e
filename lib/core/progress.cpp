#include "core/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace slidezone {

static bool color_is_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return no_color == nullptr || *no_color == '\0';
}

Progress::Progress(std::string what, Show show)
    : what_(std::move(what)), is_shown_(show == Show::on_terminal && isatty(STDERR_FILENO)), has_color_(color_is_wanted()) {}

Progress::~Progress() {
  if (is_shown_ && last_percent_ >= 0) std::fputs("\r\033[K", stderr);
}

void Progress::update(double fraction, const std::string& state) {
  if (!is_shown_) return;
  const int percent = static_cast<int>(100 * fraction);
  if (percent == last_percent_) return;
  last_percent_ = percent;
  constexpr int width = 30;
  const int filled = percent * width / 100;
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(width - filled), '.');
  const char* on = has_color_ ? "\033[36m" : "";
  const char* off = has_color_ ? "\033[0m" : "";
  std::fprintf(stderr, "\r%s %s%s%s %3d %%  %s\033[K", what_.c_str(), on, bar.c_str(), off, percent, state.c_str());
  std::fflush(stderr);
}

}  // namespace slidezone
