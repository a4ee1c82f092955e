// Reads each scene named on the command line as a tool that needs all of it would; prints one line for each, "0" or the
// exit code and the message.
#include <iostream>

#include "core/error.hpp"
#include "scene/scene.hpp"

int main(int argc, char** argv) {
  using namespace slidezone;
  for (int i = 1; i < argc; ++i) {
    try {
      material_points(read_scene(argv[i], {.grid = true, .soil = true, .time = true}));
      std::cout << "0\n";
    } catch (const Error& error) {
      std::cout << static_cast<int>(error.code()) << ' ' << error.what() << '\n';
    }
  }
}
