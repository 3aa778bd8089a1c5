#include "apps/cli/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

namespace tautline::cli {
namespace {

// The one mutable global: a signal handler can reach nothing else. Empty while no temporary file exists.
std::array<char, 4096> temporary_path{};

extern "C" void OnInterrupt(int signal) {
  if (temporary_path[0] != '\0') unlink(temporary_path.data());
  _exit(128 + signal);
}

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

/// The bytes in a new file at temporary_path, on the disk; 0, or the system's error number.
int WriteTemporary(std::string_view bytes) {
  const int file = mkstemp(temporary_path.data());
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

int WriteByRename(const std::string& path, std::string_view bytes) {
  const std::string pattern = path + ".XXXXXX";
  if (pattern.size() >= temporary_path.size()) return ENAMETOOLONG;
  std::memcpy(temporary_path.data(), pattern.c_str(), pattern.size() + 1);
  int error = WriteTemporary(bytes);
  if (error == 0 && rename(temporary_path.data(), path.c_str()) != 0) error = errno;
  if (error != 0) unlink(temporary_path.data());
  temporary_path[0] = '\0';
  return error;
}

}  // namespace

Expected<void> WriteFile(const std::string& path, std::string_view bytes) {
  const std::string target = FollowLinks(path);
  const int error = IsSpecialFile(target) ? WriteSpecial(target, bytes) : WriteByRename(target, bytes);
  if (error != 0) return CannotWrite(path, error);
  return {};
}

Expected<void> WriteStandardOutput(std::string_view bytes) {
  if (const int error = WriteAll(STDOUT_FILENO, bytes); error != 0) return CannotWrite("standard output", error);
  return {};
}

void HandleSignals() {
  std::signal(SIGINT, OnInterrupt);
  std::signal(SIGTERM, OnInterrupt);
  std::signal(SIGHUP, OnInterrupt);
}

}  // namespace tautline::cli
