#include "core/tool.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <iostream>

#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"

namespace slidezone {

static std::string tool_name;  // set once by tool_main, before anything prints
static bool quiet = false;

static const char* const exit_codes =
    "Exit codes:\n"
    "  0    done\n"
    "  64   wrong command line\n"
    "  65   wrong input data\n"
    "  66   input missing\n"
    "  70   a fault of this program\n"
    "  73   output cannot be created\n"
    "  74   reading or writing failed";

bool is_quiet() { return quiet; }

static void print_message(const std::string& message) { std::cerr << tool_name << ": " << message << std::endl; }

void note(const std::string& message) {
  if (!quiet) print_message("note: " + message);
}

void warn(const std::string& message) { print_message("warning: " + message); }

/// Stdout must have reached its reader before a tool may claim success.
static void flush_stdout() {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) throw Error(ExitCode::io, "stdout: writing failed; is the disk full?");
}

static int parse_and_run(CLI::App& app, int argc, char** argv, const std::function<void()>& run) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app.exit(error);  // --help or --version, on stdout
      flush_stdout();
      return static_cast<int>(ExitCode::done);
    }
    throw Error(ExitCode::usage, std::string(error.what()) + "; see " + tool_name + " --help");
  }
  run();
  flush_stdout();
  return static_cast<int>(ExitCode::done);
}

int tool_main(CLI::App& app, const std::string& example, int argc, char** argv, const std::function<void()>& run) {
  tool_name = app.get_name();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is then a write error, reported like any other
  app.set_version_flag("--version", tool_name + " " + std::string(version()), "Print the version and stop");
  app.add_flag("-q,--quiet", quiet, "No progress line and no notes; warnings and errors remain");
  app.get_formatter()->column_width(36);
  app.footer("Example: " + example + "\n\n" + exit_codes);
  try {
    return parse_and_run(app, argc, argv, run);
  } catch (const Error& error) {
    print_message(error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    print_message("out of memory");
  } catch (const std::exception& error) {
    print_message(std::string("internal error: ") + error.what());
  }
  return static_cast<int>(ExitCode::internal);
}

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  const std::string range = most == std::numeric_limits<std::uint64_t>::max()
                                ? "whole number >= " + std::to_string(least)
                                : "whole number in " + std::to_string(least) + ".." + std::to_string(most);
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const auto value = parse_whole(text);
        if (value && *value >= least && *value <= most) return {};
        return "found '" + text + "', expected a " + range;
      },
      "");
}

CLI::Validator real_number(double least, double most) {
  const std::string range = "number from " + format_real(least) + " to " + format_real(most);
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const auto value = parse_real(text);
        if (value && *value >= least && *value <= most) return {};
        return "found '" + text + "', expected a " + range;
      },
      "");
}

CLI::Validator text_that(const std::function<bool(const std::string&)>& is_good, const std::string& expected) {
  return CLI::Validator([=](std::string& text) -> std::string { return is_good(text) ? "" : "found '" + text + "', expected " + expected; },
                        "");
}

}  // namespace slidezone
