#include "tautline/scene/text_file.h"

#include <fstream>
#include <vector>

namespace tautline {

Expected<std::string> ReadTextFile(const std::string& path, std::size_t max_bytes) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return tl::unexpected<Error>(Error{ErrorCode::kUnreadable, "no such file, or it may not be read", path});
  }
  std::string text;
  std::vector<char> block(1 << 16);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > max_bytes) {
      const std::string limit = std::to_string(max_bytes >> 20);
      return tl::unexpected<Error>(Error{ErrorCode::kLimitExceeded, "larger than " + limit + " MiB", path});
    }
  }
  if (file.bad()) {
    return tl::unexpected<Error>(Error{ErrorCode::kUnreadable, "cannot be read: is it a file?", path});
  }
  return text;
}

}  // namespace tautline
