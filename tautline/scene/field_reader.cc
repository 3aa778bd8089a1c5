#include "tautline/scene/field_reader.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

using Kind = Document::Kind;

/// The number of letters to insert, remove or replace on the way from a to b (Levenshtein). O(|a| |b|).
std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string Listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/// Blanks, control characters and '^' (bytes above 127 are parts of letters in UTF-8).
bool BreaksName(char c) { return c == '^' || c == 0x7f || static_cast<unsigned char>(c) <= ' '; }

}  // namespace

std::string_view NearestName(std::string_view name, std::span<const std::string_view> known) {
  constexpr std::size_t kLongestName = 40;
  std::string_view nearest;
  std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
  if (name.size() > kLongestName) return nearest;
  for (const std::string_view candidate : known) {
    const std::size_t distance = EditDistance(name, candidate);
    if (distance >= least || distance >= candidate.size()) continue;
    nearest = candidate;
    least = distance;
  }
  return nearest;
}

std::string Element(std::string_view what, std::size_t index) {
  return std::string(what) + "[" + std::to_string(index + 1) + "]";
}

void FieldReader::Fail(Position at, std::string message, ErrorCode code) {
  Fail(Error{code, std::move(message), Where(at)});
}

void FieldReader::Fail(Error error) {
  if (ok_) error_ = {error.code, OneLine(std::move(error.message)), OneLine(std::move(error.where))};
  ok_ = false;
}

void FieldReader::Check(const std::optional<Fault>& fault, Position at, std::string_view what) {
  if (ok_ && fault) Fail(at, std::string(what) + fault->text, fault->code);
}

bool FieldReader::IsMap(const Document& value, std::string_view what) {
  if (value.is(Kind::kMap)) return ok_;
  Fail(value.position, std::string(what) + " must be a map of keys and values, not " + Describe(value));
  return false;
}

bool FieldReader::IsList(const Document& value, std::string_view what) {
  if (value.is(Kind::kList)) return ok_;
  Fail(value.position, std::string(what) + " must be a list, not " + Describe(value) + ": write it in [ ]");
  return false;
}

void FieldReader::KnownKeys(const Document& map, std::string_view what, const std::vector<std::string_view>& known) {
  for (const DocumentKey& key : map.keys) {
    if (std::find(known.begin(), known.end(), key.name) != known.end()) continue;
    const std::string_view nearest = NearestName(key.name, known);
    const std::string hint =
        nearest.empty() ? "known are " + Listed(known) : "did you mean '" + std::string(nearest) + "'?";
    return Fail(key.position, "unknown key " + Quoted(key.name) + " in " + std::string(what) + ": " + hint);
  }
}

const Document* FieldReader::Required(const Document& map, std::string_view what, std::string_view key) {
  const Document* value = map.Find(key);
  if (value == nullptr) {
    Fail(map.position, std::string(what) + " has no '" + std::string(key) + "': add it");
  }
  return ok_ ? value : nullptr;
}

double FieldReader::ReadNumber(const Document& value, std::string_view what) {
  if (!ok_) return 0;
  if (!value.is(Kind::kNumber)) {
    const bool quoted = value.is(Kind::kString) && ParseNumber(value.text).has_value();
    Fail(value.position,
         std::string(what) + " must be a number, not " + Describe(value) + (quoted ? ": remove the quotes" : ""));
    return 0;
  }
  Check(NumberFault(value.number), value.position, what);
  return ok_ ? value.number : 0;
}

double FieldReader::ReadPositive(const Document& value, std::string_view what) {
  const double number = ReadNumber(value, what);
  Check(PositiveFault(number), value.position, what);
  return number;
}

double FieldReader::ReadNonNegative(const Document& value, std::string_view what) {
  const double number = ReadNumber(value, what);
  Check(NonNegativeFault(number), value.position, what);
  return number;
}

std::string FieldReader::ReadText(const Document& value, std::string_view what) {
  if (!ok_) return "";
  if (!value.is(Kind::kString)) {
    const bool scalar = value.is(Kind::kNumber) || value.is(Kind::kBool);
    Fail(value.position,
         std::string(what) + " must be a text, not " + Describe(value) + (scalar ? ": write it in quotes" : ""));
  } else if (value.text.empty()) {
    Fail(value.position, std::string(what) + " is empty: write a text or remove the key");
  }
  return value.text;
}

std::string FieldReader::ReadName(const Document& value, std::string_view what) {
  std::string name = ReadText(value, what);
  if (ok_ && std::any_of(name.begin(), name.end(), BreaksName)) {
    Fail(value.position, std::string(what) + " " + Quoted(name) +
                             " holds a blank or '^', which words cannot carry: write it with letters, digits or '_'");
  }
  return name;
}

void FieldReader::CountPoint(Position at) {
  if (++points_ <= kMaxScenePoints) return;
  Fail(at, "more than " + std::to_string(kMaxScenePoints) + " points: simplify the file", ErrorCode::kLimitExceeded);
}

Point FieldReader::ReadPoint(const Document& value, std::string_view what) {
  if (!ok_) return {};
  if (!value.is(Kind::kList) || value.items.size() != 2) {
    Fail(value.position, std::string(what) + " must be a point [x, y], not " + Describe(value));
    return {};
  }
  CountPoint(value.position);
  if (!ok_) return {};
  const Point point{ReadNumber(value.items[0], what), ReadNumber(value.items[1], what)};
  Check(PointFault(point), value.position, what);
  return point;
}

Polyline FieldReader::ReadPoints(const Document& value, std::string_view what, std::size_t at_least) {
  Polyline points;
  if (!ok_ || !IsList(value, what)) return points;
  if (value.items.size() < at_least) {
    Fail(value.position, std::string(what) + " has " + std::to_string(value.items.size()) + " points: it needs " +
                             std::to_string(at_least) + " or more");
    return points;
  }
  points.reserve(value.items.size());
  for (std::size_t i = 0; i < value.items.size() && ok_; ++i) {
    points.push_back(ReadPoint(value.items[i], Element(what, i)));
  }
  return points;
}

}  // namespace tautline
