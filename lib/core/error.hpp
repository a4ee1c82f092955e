// Errors: the one exception type of the project, the exit codes, and places in text files.
//
// Form of a message: "file:line:column: what was found, what was expected; hint". tool_main() adds the tool's name in
// front, prints it on stderr and exits with the code. Codes follow sysexits.h.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace slidezone {

enum class ExitCode : int {
  done = 0,
  usage = 64,          // wrong command line
  data = 65,           // wrong input data
  no_input = 66,       // input missing or unreadable
  internal = 70,       // a fault of ours
  cannot_create = 73,  // output cannot be created
  io = 74,             // reading or writing failed on the way
};

class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// A place in a text file; line and column count from 1, 0 means unknown.
struct Location {
  std::string file;
  long line = 0;
  long column = 0;
};

/// "file:line:column", leaving out what is unknown.
std::string to_string(const Location& where);

/// Throws Error(ExitCode::data, "<where>: <message>").
[[noreturn]] void fail_at(const Location& where, const std::string& message);

/// "; did you mean 'x'?" for the candidate nearest to `word` by edit distance, or "" if none is near.
std::string nearest_hint(std::string_view word, std::span<const std::string> candidates);

/// "a, b or c", for messages that list what was expected.
std::string list_of(std::span<const std::string> names);

}  // namespace slidezone
