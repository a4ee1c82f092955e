// Whole files in, whole files out; "-" is a standard stream.
//
// A result is written to a temporary beside its target, synced and renamed: a reader sees the old file or
// the new one, never a part. A failed or interrupted run leaves no temporary. Targets that exist and are not regular
// files (a pipe, /dev/null) are written in place.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace slidezone {

/// The bytes of the file, or of stdin for "-". Throws with ExitCode::no_input if it cannot be opened, io if not read.
std::string read_input(const std::string& path);

/// The same without a copy: a regular file is mapped, so that only the parts in use lie in memory; a stream is read. The file must
/// keep its size meanwhile, as files of this suite do: they are renamed into place.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::string_view bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws with ExitCode::cannot_create if the target cannot be created; leaves nothing. For who computes long before writing.
void check_can_create(const std::string& path);

/// Throws with ExitCode::cannot_create if the target cannot be created, io if writing fails.
void write_output(const std::string& path, std::string_view bytes);

/// The same for a result written piece by piece: the target appears with finish(), and never without it.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws ExitCode::usage if `path` is "-" and stdout is a terminal: a binary file would garble it.
void refuse_terminal(const std::string& path);

/// Throws ExitCode::data if the bytes of the file `name` are those of a binary file where text in the form `expected` is wanted.
void refuse_binary(std::string_view bytes, const std::string& name, const std::string& expected);

/// How messages call the path: "stdin" for "-".
std::string input_name(const std::string& path);

}  // namespace slidezone
