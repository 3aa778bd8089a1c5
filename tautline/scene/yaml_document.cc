#include "tautline/scene/yaml_document.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

Position At(const YAML::Mark& mark) { return {mark.line + 1, mark.column + 1}; }

/// Leaves the parser once the builder has failed; the failure is in the builder.
struct Stop {};

bool OneOf(std::string_view text, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), text) != names.end();
}

bool IsNotFinite(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  return OneOf(text, {".inf", ".Inf", ".INF", ".nan", ".NaN", ".NAN"});
}

/// Turns yaml-cpp's events into calls of the builder and resolves anchors.
class Handler : public YAML::EventHandler {
 public:
  explicit Handler(DocumentBuilder& builder) : builder_(builder) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (builder_.expects_key()) {
      Require(builder_.Fail("a key is missing before ':'", At(mark)));
    }
    Require(builder_.Null(At(mark)));
    Keep(anchor, At(mark));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) Require(builder_.Fail("an alias inside of its own anchor", At(mark)));
    if (!builder_.expects_key()) return Require(builder_.Copy(found->second, At(mark)));
    if (!found->second.is(Document::Kind::kString)) Require(builder_.Fail("a key must be a text", At(mark)));
    Require(builder_.Key(found->second.text, At(mark)));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    if (builder_.expects_key()) return KeyScalar(value, anchor, At(mark));
    const bool plain = tag.empty() || tag == "?";
    Require(plain ? Plain(value, At(mark)) : Tagged(tag, value, At(mark)));
    Keep(anchor, At(mark));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    RefuseAsKey(mark);
    Require(builder_.StartList(At(mark)));
    open_anchors_.push_back(anchor);
  }
  void OnSequenceEnd() override { EndCollection(); }

  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    RefuseAsKey(mark);
    Require(builder_.StartMap(At(mark)));
    open_anchors_.push_back(anchor);
  }
  void OnMapEnd() override { EndCollection(); }

 private:
  static void Require(bool ok) {
    if (!ok) throw Stop{};
  }

  bool Plain(const std::string& value, Position at) {
    if (OneOf(value, {"true", "True", "TRUE"})) return builder_.Bool(true, at);
    if (OneOf(value, {"false", "False", "FALSE"})) return builder_.Bool(false, at);
    if (IsNotFinite(value)) return builder_.Fail("the number " + Quoted(value) + " must be finite", at);
    if (const auto number = ParseNumber(value)) return builder_.Number(*number, at);
    return builder_.String(value, at);
  }

  bool Tagged(const std::string& tag, const std::string& value, Position at) {
    if (OneOf(tag, {"!", "tag:yaml.org,2002:str"})) return builder_.String(value, at);
    if (OneOf(tag, {"tag:yaml.org,2002:float", "tag:yaml.org,2002:int", "tag:yaml.org,2002:bool"})) {
      return Plain(value, at);
    }
    return builder_.Fail("the tag " + Quoted(tag) + " is not read: remove it", at);
  }

  void RefuseAsKey(const YAML::Mark& mark) {
    if (builder_.expects_key()) Require(builder_.Fail("a key must be a text, not a list or a map", At(mark)));
  }

  void EndCollection() {
    Require(builder_.End());
    const YAML::anchor_t anchor = open_anchors_.back();
    open_anchors_.pop_back();
    Keep(anchor, builder_.last().position);
  }

  void KeyScalar(const std::string& value, YAML::anchor_t anchor, Position at) {
    Require(builder_.Key(value, at));
    if (anchor == 0) return;
    Document& kept = anchors_[anchor];
    kept.kind = Document::Kind::kString;
    kept.position = at;
    kept.text = value;
  }

  void Keep(YAML::anchor_t anchor, Position at) {
    if (anchor == 0) return;
    Require(builder_.Charge(builder_.last(), at));
    anchors_[anchor] = builder_.last();
  }

  DocumentBuilder& builder_;
  std::map<YAML::anchor_t, Document> anchors_;
  std::vector<YAML::anchor_t> open_anchors_;  ///< Of the lists and maps not yet ended; 0: none.
};

/// Runs the parser over the text; every failure ends up in the builder.
void Parse(std::istream& input, Handler& handler, DocumentBuilder& builder) {
  try {
    YAML::Parser parser(input);
    if (!parser.HandleNextDocument(handler)) return;
    DocumentBuilder rest("");
    Handler ignore(rest);
    if (parser.HandleNextDocument(ignore)) builder.Fail("a file holds one document: remove what follows '---'", {});
  } catch (const YAML::Exception& error) {
    builder.Fail("not valid YAML: " + error.msg, error.mark.is_null() ? Position{} : At(error.mark));
  }
}

}  // namespace

Expected<Document> ParseYaml(std::string_view text, const std::string& file) {
  DocumentBuilder builder(file);
  if (text.size() > kMaxDocumentBytes) {
    builder.Fail("larger than 64 MiB: split the file or simplify it", {}, ErrorCode::kLimitExceeded);
    return builder.Finish();
  }
  std::istringstream input{std::string(text)};
  Handler handler(builder);
  try {
    Parse(input, handler, builder);
  } catch (const Stop&) {
    // The builder holds the failure; a second document that fails is reported as a second document.
    builder.Fail("a file holds one document: remove what follows '---'", {});
  }
  return builder.Finish();
}

}  // namespace tautline
