#include "io/file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "core/error.hpp"

namespace slidezone {

namespace {

/// An open file that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > STDERR_FILENO) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

constexpr std::array interruptions = {SIGINT, SIGTERM, SIGHUP};
char interrupted_path[PATH_MAX];  // the temporary that a signal must remove: a handler can reach only static storage

void remove_temporary_and_die(int signal_number) {
  ::unlink(interrupted_path);
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

/// While it lives, the temporary is removed by a signal; when it ends, unless `keep` was called.
class Temporary {
 public:
  explicit Temporary(const std::string& path) {
    std::strncpy(interrupted_path, path.c_str(), sizeof interrupted_path - 1);
    for (const int number : interruptions) std::signal(number, remove_temporary_and_die);
  }
  ~Temporary() {
    if (!is_kept_) ::unlink(interrupted_path);
    for (const int number : interruptions) std::signal(number, SIG_DFL);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  void keep() { is_kept_ = true; }

 private:
  bool is_kept_ = false;
};

[[noreturn]] void fail_with_reason(ExitCode code, const std::string& path, const std::string& what) {
  throw Error(code, path + ": " + what + ": " + std::strerror(errno));
}

void write_all(int descriptor, std::string_view bytes, const std::string& name) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_with_reason(ExitCode::io, name, "writing failed");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// The file behind a chain of symbolic links, so that a rename replaces the file and not the link.
std::string link_target(const std::string& path) {
  char* resolved = ::realpath(path.c_str(), nullptr);
  if (resolved == nullptr) return path;
  const std::string target = resolved;
  std::free(resolved);
  return target;
}

/// A pipe, a device: whatever is no regular file is written in place.
int open_in_place(const std::string& path) {
  const int number = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (number < 0) fail_with_reason(ExitCode::cannot_create, path, "cannot be written");
  return number;
}

/// A new file of a name like `pattern`, with the mode that the target would get; the pattern's XXXXXX are replaced.
int open_temporary(std::string& pattern, const std::string& path) {
  const int number = ::mkostemp(pattern.data(), O_CLOEXEC);
  if (number < 0) fail_with_reason(ExitCode::cannot_create, path, "cannot be created");
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(number, 0666 & ~mask);
  return number;
}

bool is_special(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return false;
  if (S_ISDIR(status.st_mode)) throw Error(ExitCode::cannot_create, path + ": is a directory, expected a file name");
  return !S_ISREG(status.st_mode);
}

}  // namespace

void refuse_terminal(const std::string& path) {
  if (path == "-" && ::isatty(STDOUT_FILENO))
    throw Error(ExitCode::usage, "the result is binary and stdout is a terminal; give a file with -o or pipe it on");
}

void refuse_binary(std::string_view bytes, const std::string& name, const std::string& expected) {
  if (bytes.find('\0') == std::string_view::npos) return;
  const std::string found = bytes.starts_with("\x89HDF") ? "an HDF5 file" : "a binary file";
  throw Error(ExitCode::data, name + ": found " + found + ", expected " + expected + "; are files and arguments in the right order?");
}

std::string input_name(const std::string& path) { return path == "-" ? "stdin" : path; }

static int open_input(const std::string& path) {
  const int number = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (number < 0) fail_with_reason(ExitCode::no_input, path, "cannot be opened");
  return number;
}

struct InputFile::State {
  std::string read;  // of what cannot be mapped
  void* mapped = MAP_FAILED;
  std::size_t size = 0;
};

InputFile::InputFile(const std::string& path) : state_(new State) {
  const Descriptor file(open_input(path));
  struct stat status {};
  const bool is_regular = ::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode);
  const bool is_at_start = ::lseek(file.number(), 0, SEEK_CUR) == 0;  // stdin may have been read in part
  if (is_regular && is_at_start && status.st_size > 0) {
    state_->size = static_cast<std::size_t>(status.st_size);
    state_->mapped = ::mmap(nullptr, state_->size, PROT_READ, MAP_PRIVATE, file.number(), 0);
  }
  if (state_->mapped == MAP_FAILED) state_->read = read_input(path);
}

InputFile::~InputFile() {
  if (state_->mapped != MAP_FAILED) ::munmap(state_->mapped, state_->size);
}

std::string_view InputFile::bytes() const {
  if (state_->mapped == MAP_FAILED) return state_->read;
  return {static_cast<const char*>(state_->mapped), state_->size};
}

std::string read_input(const std::string& path) {
  const Descriptor file(open_input(path));
  struct stat status {};
  std::string bytes;
  constexpr std::size_t chunk = 1 << 16;
  if (::fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode)) bytes.reserve(static_cast<std::size_t>(status.st_size) + chunk);
  std::size_t size = 0;
  for (;;) {
    bytes.resize(std::max(bytes.capacity(), size + chunk));
    const ssize_t got = ::read(file.number(), bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_with_reason(errno == EISDIR ? ExitCode::no_input : ExitCode::io, input_name(path), "reading failed");
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

struct OutputFile::State {
  std::string name;    // in messages
  std::string target;  // what the temporary becomes; empty where the output is written in place
  std::string temporary;
  std::unique_ptr<Descriptor> file;
  std::unique_ptr<Temporary> guard;
};

OutputFile::OutputFile(const std::string& path) : state_(new State) {
  state_->name = path == "-" ? "stdout" : path;
  if (path == "-" || is_special(path)) {
    state_->file = std::make_unique<Descriptor>(path == "-" ? STDOUT_FILENO : open_in_place(path));
    return;
  }
  state_->target = link_target(path);
  state_->temporary = state_->target + ".XXXXXX";
  state_->file = std::make_unique<Descriptor>(open_temporary(state_->temporary, path));
  state_->guard = std::make_unique<Temporary>(state_->temporary);
}

OutputFile::~OutputFile() = default;

void OutputFile::write(std::string_view bytes) { write_all(state_->file->number(), bytes, state_->name); }

void OutputFile::finish() {
  if (!state_->guard) return;
  if (::fsync(state_->file->number()) != 0) fail_with_reason(ExitCode::io, state_->name, "writing to disk failed");
  if (::rename(state_->temporary.c_str(), state_->target.c_str()) != 0)
    fail_with_reason(ExitCode::cannot_create, state_->name, "cannot be created");
  state_->guard->keep();
}

void check_can_create(const std::string& path) {
  if (path != "-" && !is_special(path)) OutputFile{path};
}

void write_output(const std::string& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.finish();
}

}  // namespace slidezone
