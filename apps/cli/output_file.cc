#include "apps/cli/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "apps/cli/signals_blocked.h"
#include "tautline/base/check.h"

namespace tautline::cli {
namespace {

// The one mutable global: a signal handler can reach nothing else. Empty where no temporary file exists.
using PathBuffer = std::array<char, 4096>;
std::array<PathBuffer, OutputFiles::kMost> temporary_paths{};

void RemoveTemporary(PathBuffer& path) {
  if (path[0] != '\0') unlink(path.data());
  path[0] = '\0';
}

extern "C" void OnSignal(int signal) {
  for (PathBuffer& path : temporary_paths) RemoveTemporary(path);
  _exit(128 + signal);
}

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGPIPE};

tl::unexpected<Error> CannotWrite(const std::string& what, int error) {
  return tl::unexpected<Error>(
      Error{ErrorCode::kUnreadable, std::string("cannot be written (") + std::strerror(error) + ")", what});
}

/// Writes all bytes; 0, or the system's error number.
int WriteAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// The bytes in a new file beside `target`, whose name goes to `path`; 0, or the system's error number.
int WriteTemporary(const std::string& target, std::string_view bytes, PathBuffer& path) {
  const std::string pattern = target + ".XXXXXX";
  if (pattern.size() >= path.size()) return ENAMETOOLONG;
  int file = -1;
  {
    const SignalsBlocked blocked;  // Between the file and its name.
    std::memcpy(path.data(), pattern.c_str(), pattern.size() + 1);
    file = mkstemp(path.data());
    if (file < 0) path[0] = '\0';
  }
  if (file < 0) return errno;
  int error = WriteAll(file, bytes);
  // mkstemp makes a private file; the result has the permissions of any new file.
  const mode_t mask = umask(0);
  umask(mask);
  if (error == 0 && fchmod(file, 0666 & ~mask) != 0) error = errno;
  if (close(file) != 0 && error == 0) error = errno;
  return error;
}

/// Where the file itself is, or would be made: renaming onto a link would replace the link.
std::string FollowLinks(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // As the kernel's own limit; a loop ends there and fails to open.
  std::error_code none;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, none); ++i) {
    path = path.parent_path() / std::filesystem::read_symlink(path, none);
  }
  return path.string();
}

bool IsSpecialFile(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

/// A device or pipe, such as /dev/null, cannot be replaced; it is written to.
int WriteSpecial(const std::string& path, std::string_view bytes) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return errno;
  const int error = WriteAll(file, bytes);
  return close(file) != 0 && error == 0 ? errno : error;
}

/// Exchanges two files; 0, or the system's error number.
int Exchange(const char* a, const char* b) {
  return syscall(SYS_renameat2, AT_FDCWD, a, AT_FDCWD, b, RENAME_EXCHANGE) == 0 ? 0 : errno;
}

}  // namespace

OutputFiles::~OutputFiles() {
  for (PathBuffer& path : temporary_paths) RemoveTemporary(path);
}

Expected<void> OutputFiles::Add(const std::string& path, std::string_view bytes) {
  if (IsSpecialFile(path)) {
    if (const int error = WriteSpecial(path, bytes); error != 0) return CannotWrite(path, error);
    return {};
  }
  const std::string target = FollowLinks(path);
  TAUTLINE_CHECK(files_.size() < kMost);
  PathBuffer& temporary = temporary_paths[files_.size()];
  TAUTLINE_CHECK(temporary[0] == '\0');  // Else another object has a file there, which would be left behind.
  if (const int error = WriteTemporary(target, bytes, temporary); error != 0) {
    RemoveTemporary(temporary);
    return CannotWrite(path, error);
  }
  files_.push_back({path, target, access(target.c_str(), F_OK) == 0});
  return {};
}

/// Exchanges the temporary file with the one it replaces, so that it can be taken back; 0, or the system's error
/// number.
int OutputFiles::Place(std::size_t index) {
  const char* temporary = temporary_paths[index].data();
  const char* target = files_[index].target.c_str();
  if (files_[index].existed && Exchange(temporary, target) == 0) return 0;
  // Not every file system can exchange; the last file need not be taken back, and the first ones seldom must.
  if (rename(temporary, target) != 0) return errno;
  temporary_paths[index][0] = '\0';
  return 0;
}

void OutputFiles::TakeBack(std::size_t index) {
  if (!files_[index].existed) {
    unlink(files_[index].target.c_str());
  } else if (temporary_paths[index][0] != '\0') {
    Exchange(temporary_paths[index].data(), files_[index].target.c_str());
  }
}

Expected<void> OutputFiles::Commit() {
  const SignalsBlocked blocked;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const int error = Place(i);
    if (error == 0) continue;
    for (std::size_t k = 0; k < i; ++k) TakeBack(k);
    return CannotWrite(files_[i].path, error);
  }
  for (PathBuffer& path : temporary_paths) RemoveTemporary(path);
  return {};
}

Expected<void> WriteStandardOutput(std::string_view bytes) {
  if (const int error = WriteAll(STDOUT_FILENO, bytes); error != 0) return CannotWrite("standard output", error);
  return {};
}

Expected<void> WriteWholeLine(std::string_view line) {
  // A closed pipe is no reason to wait: nobody reads the rest of the line.
  const SignalsBlocked blocked{SIGINT, SIGTERM, SIGHUP};
  return WriteStandardOutput(line);
}

void HandleSignals() {
  for (const int signal : kSignals) std::signal(signal, OnSignal);
  std::signal(SIGXFSZ, SIG_IGN);  // The write fails instead, with a reason.
}

}  // namespace tautline::cli
