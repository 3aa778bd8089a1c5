#include "tautline/scene/json_document.h"

#include <gtest/gtest.h>

namespace tautline {
namespace {

using Kind = Document::Kind;

Document Parsed(std::string_view text) {
  const auto document = ParseJson(text, "s.json");
  EXPECT_TRUE(document) << ToString(document.error());
  return document.value_or(Document{});
}

std::string ErrorOf(std::string_view text) {
  const auto document = ParseJson(text, "s.json");
  return document ? "no error" : ToString(document.error());
}

TEST(ParseJson, ReadsEveryKind) {
  const Document d = Parsed(R"({"a": null, "b": true, "c": -1.5e2, "d": "x\n", "e": [1, 2], "f": {}})");
  ASSERT_EQ(d.keys.size(), 6u);
  EXPECT_TRUE(d.Find("a")->is(Kind::kNull));
  EXPECT_TRUE(d.Find("b")->boolean);
  EXPECT_EQ(d.Find("c")->number, -150);
  EXPECT_EQ(d.Find("d")->text, "x\n");
  EXPECT_EQ(d.Find("e")->items.size(), 2u);
  EXPECT_TRUE(d.Find("f")->is(Kind::kMap));
  EXPECT_EQ(d.Find("g"), nullptr);
}

TEST(ParseJson, KeepsTheOrderOfKeys) {
  const Document d = Parsed(R"({"z": 1, "a": 2})");
  EXPECT_EQ(d.keys[0].name, "z");
  EXPECT_EQ(d.keys[1].name, "a");
}

TEST(ParseJson, EveryValueHasItsLineAndColumn) {
  const Document d = Parsed("{\n  \"a\": 12\n,\n  \"b\": [\n    1\n  ,2],\n\"c\":\"q\\\"r\"}");
  EXPECT_EQ(d.position.line, 1);
  EXPECT_EQ(d.keys[0].position.line, 2);
  EXPECT_EQ(d.keys[0].position.column, 3);
  EXPECT_EQ(d.Find("a")->position.line, 2);
  EXPECT_EQ(d.Find("a")->position.column, 8);
  EXPECT_EQ(d.Find("b")->position.line, 4);
  EXPECT_EQ(d.Find("b")->items[0].position.line, 5);
  EXPECT_EQ(d.Find("b")->items[1].position.line, 6);
  EXPECT_EQ(d.Find("b")->items[1].position.column, 4);
  EXPECT_EQ(d.Find("c")->position.line, 7);
  EXPECT_EQ(d.Find("c")->text, "q\"r");
}

TEST(ParseJson, RefusesAKeyThatStandsTwice) {
  EXPECT_EQ(ErrorOf("{\"a\": 1,\n\"a\": 2}"), "s.json:2: the key 'a' stands twice in one map: remove one");
}

TEST(ParseJson, RefusesNumbersThatAreNotFinite) {
  EXPECT_EQ(ErrorOf("{\n\"a\": 1e999\n}"), "s.json:2: the number '1e999' is too large: write one below 1e308");
  EXPECT_EQ(ErrorOf("{\n\"a\": NaN}").substr(0, 25), "s.json:2: not valid JSON:");
}

TEST(ParseJson, SaysWhereTheSyntaxBreaks) {
  EXPECT_EQ(ErrorOf("{\n\"a\": ]}").substr(0, 25), "s.json:2: not valid JSON:");
  EXPECT_EQ(ErrorOf("").substr(0, 9), "s.json:1:");
  EXPECT_EQ(ErrorOf("{} {}").substr(0, 9), "s.json:1:");
  EXPECT_EQ(ErrorOf("{\n\"a\": \"x\n\"}").substr(0, 9), "s.json:2:");
}

TEST(ParseJson, RefusesDeepNesting) {
  EXPECT_NE(ErrorOf(std::string(1000, '[')).find("nested deeper"), std::string::npos);
  EXPECT_NE(ErrorOf(std::string(100000, '[')).find("nested deeper"), std::string::npos);
}

TEST(ParseJson, SkipsAByteOrderMark) { EXPECT_TRUE(Parsed("\xEF\xBB\xBF{}").is(Kind::kMap)); }

}  // namespace
}  // namespace tautline
