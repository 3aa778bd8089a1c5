#include "tautline/scene/document.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

using Kind = Document::Kind;

std::size_t CountValues(const Document& value) {
  std::size_t count = 1;
  for (const Document& item : value.items) count += CountValues(item);
  return count;
}

std::size_t DepthOf(const Document& value) {
  std::size_t depth = 0;
  for (const Document& item : value.items) depth = std::max(depth, DepthOf(item));
  return depth + 1;
}

/// The later one of two equal keys of a map, if there are any.
std::optional<DocumentKey> RepeatedKey(const std::vector<DocumentKey>& keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&keys](std::size_t a, std::size_t b) {
    return keys[a].name != keys[b].name ? keys[a].name < keys[b].name : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (keys[order[i]].name == keys[order[i - 1]].name) return keys[order[i]];
  }
  return std::nullopt;
}

Document Scalar(Kind kind, Position at) {
  Document value;
  value.kind = kind;
  value.position = at;
  return value;
}

}  // namespace

const Document* Document::Find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].name == key) return &items[i];
  }
  return nullptr;
}

std::string OneLine(std::string text) {
  for (char& c : text) c = static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  return text;
}

std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  return "'" + OneLine(std::string(text.substr(0, kLongest))) + (text.size() > kLongest ? "...'" : "'");
}

std::string Describe(const Document& value) {
  switch (value.kind) {
    case Kind::kNull:
      return "nothing";
    case Kind::kBool:
      return value.boolean ? "true" : "false";
    case Kind::kNumber:
      return "the number " + FormatNumber(value.number);
    case Kind::kString:
      return "the text " + Quoted(value.text);
    case Kind::kList:
      return value.items.empty() ? "an empty list" : "a list of " + std::to_string(value.items.size());
    case Kind::kMap:
      return "a map";
  }
  return "nothing";
}

bool DocumentBuilder::Null(Position at) { return Count(1, at) && Add(Scalar(Kind::kNull, at)); }

bool DocumentBuilder::Bool(bool value, Position at) {
  if (!Count(1, at)) return false;
  Document scalar = Scalar(Kind::kBool, at);
  scalar.boolean = value;
  return Add(std::move(scalar));
}

bool DocumentBuilder::Number(double value, Position at) {
  if (!std::isfinite(value)) return Fail("a number must be finite: write one below 1e308", at);
  if (!Count(1, at)) return false;
  Document scalar = Scalar(Kind::kNumber, at);
  scalar.number = value;
  return Add(std::move(scalar));
}

bool DocumentBuilder::String(std::string value, Position at) {
  if (!Count(1, at)) return false;
  Document scalar = Scalar(Kind::kString, at);
  scalar.text = std::move(value);
  return Add(std::move(scalar));
}

bool DocumentBuilder::Key(std::string name, Position at) {
  if (failed_) return false;
  TAUTLINE_CHECK(expects_key());
  open_.back().keys.push_back({std::move(name), at});
  return true;
}

bool DocumentBuilder::Start(Kind kind, Position at) {
  if (!Count(1, at)) return false;
  if (open_.size() >= kMaxDocumentDepth) {
    return Fail("lists and maps are nested deeper than " + std::to_string(kMaxDocumentDepth) + ": flatten them", at,
                ErrorCode::kLimitExceeded);
  }
  open_.push_back(Scalar(kind, at));
  return true;
}

bool DocumentBuilder::End() {
  if (failed_) return false;
  TAUTLINE_CHECK(!open_.empty());
  if (const auto key = RepeatedKey(open_.back().keys)) {
    return Fail("the key " + Quoted(key->name) + " stands twice in one map: remove one", key->position);
  }
  Document done = std::move(open_.back());
  open_.pop_back();
  return Add(std::move(done));
}

bool DocumentBuilder::Copy(const Document& value, Position at) {
  if (!Charge(value, at)) return false;
  if (open_.size() + DepthOf(value) > kMaxDocumentDepth) {
    return Fail("aliases are nested too deep: flatten them", at, ErrorCode::kLimitExceeded);
  }
  return Add(value);
}

bool DocumentBuilder::Charge(const Document& value, Position at) { return Count(CountValues(value), at); }

bool DocumentBuilder::Fail(std::string message, Position at, ErrorCode code) {
  if (!failed_) error_ = {code, OneLine(std::move(message)), file_ + ":" + std::to_string(at.line)};
  failed_ = true;
  return false;
}

bool DocumentBuilder::expects_key() const {
  return !open_.empty() && open_.back().is(Kind::kMap) && open_.back().keys.size() == open_.back().items.size();
}

const Document& DocumentBuilder::last() const { return open_.empty() ? root_ : open_.back().items.back(); }

Expected<Document> DocumentBuilder::Finish() {
  if (!failed_ && !has_root_) Fail("the file is empty", {});
  if (failed_) return tl::unexpected<Error>(error_);
  TAUTLINE_CHECK(open_.empty());
  return std::move(root_);
}

bool DocumentBuilder::Add(Document value) {
  if (open_.empty()) {
    TAUTLINE_CHECK(!has_root_);
    root_ = std::move(value);
    has_root_ = true;
    return true;
  }
  TAUTLINE_CHECK(open_.back().is(Kind::kList) || !expects_key());
  open_.back().items.push_back(std::move(value));
  return true;
}

bool DocumentBuilder::Count(std::size_t values, Position at) {
  if (failed_) return false;
  values_ += values;
  if (values_ <= kMaxDocumentValues) return true;
  return Fail("more than " + std::to_string(kMaxDocumentValues) + " values: split the file or simplify it", at,
              ErrorCode::kLimitExceeded);
}

}  // namespace tautline
