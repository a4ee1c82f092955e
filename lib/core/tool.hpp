// The frame of every tool: command line, messages, exit code.
//
// A tool declares its options on a CLI::App and hands over to tool_main(), which parses, runs, catches the one error
// type, flushes and checks stdout, and returns the exit code (core/error.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace slidezone {

/// Adds what all tools share to `app`: --version, -q/--quiet, exit codes in the help; then parses and calls `run`.
/// `example` is one command that works as written, shown by --help.
int tool_main(CLI::App& app, const std::string& example, int argc, char** argv, const std::function<void()>& run);

/// True once the command line asked for --quiet: no progress, no notes; warnings and errors remain.
bool is_quiet();

/// Prints "tool: note: <message>" on stderr, unless --quiet was given.
void note(const std::string& message);

/// Prints "tool: warning: <message>" on stderr.
void warn(const std::string& message);

/// Option values are checked as text, before CLI11 converts them: it would read "-3" as 18446744073709551613 and "010"
/// as 8, and let "nan" pass.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
CLI::Validator real_number(double least, double most);

/// A text for which `is_good` holds; `expected` says in words which that is.
CLI::Validator text_that(const std::function<bool(const std::string&)>& is_good, const std::string& expected);

}  // namespace slidezone
