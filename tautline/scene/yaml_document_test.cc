#include "tautline/scene/yaml_document.h"

#include <gtest/gtest.h>

namespace tautline {
namespace {

using Kind = Document::Kind;

Document Parsed(std::string_view text) {
  const auto document = ParseYaml(text, "s.yaml");
  EXPECT_TRUE(document) << ToString(document.error());
  return document.value_or(Document{});
}

std::string ErrorOf(std::string_view text) {
  const auto document = ParseYaml(text, "s.yaml");
  return document ? "no error" : ToString(document.error());
}

TEST(ParseYaml, TypesPlainScalars) {
  const Document d = Parsed("a:\nb: true\nc: -1.5e2\nd: yes\ne: '12'\nf: [1, .5]\ng: {h: ~}\ni: 0x10\nj: 1e3");
  EXPECT_TRUE(d.Find("a")->is(Kind::kNull));
  EXPECT_TRUE(d.Find("b")->is(Kind::kBool));
  EXPECT_EQ(d.Find("c")->number, -150);
  EXPECT_EQ(d.Find("d")->text, "yes");
  EXPECT_EQ(d.Find("e")->text, "12");
  EXPECT_EQ(d.Find("f")->items[1].number, 0.5);
  EXPECT_TRUE(d.Find("g")->Find("h")->is(Kind::kNull));
  EXPECT_TRUE(d.Find("i")->is(Kind::kString));
  EXPECT_EQ(d.Find("j")->number, 1000);
}

TEST(ParseYaml, EveryValueHasItsLineAndColumn) {
  const Document d = Parsed("# comment\na: 1\nb:\n  - x\n  - [2,\n     3]\n");
  EXPECT_EQ(d.Find("a")->position.line, 2);
  EXPECT_EQ(d.Find("a")->position.column, 4);
  EXPECT_EQ(d.keys[1].position.line, 3);
  EXPECT_EQ(d.Find("b")->items[1].items[1].position.line, 6);
}

TEST(ParseYaml, RefusesAKeyThatStandsTwice) {
  EXPECT_EQ(ErrorOf("a: 1\nb: 2\na: 3\n"), "s.yaml:3: the key 'a' stands twice in one map: remove one");
}

TEST(ParseYaml, RefusesNumbersThatAreNotFinite) {
  EXPECT_EQ(ErrorOf("a: 1\nb: .nan"), "s.yaml:2: the number '.nan' must be finite");
  EXPECT_EQ(ErrorOf("a: -.inf"), "s.yaml:1: the number '-.inf' must be finite");
  EXPECT_EQ(ErrorOf("a: 1e999"), "s.yaml:1: a number must be finite: write one below 1e308");
}

TEST(ParseYaml, SaysWhereTheSyntaxBreaks) {
  EXPECT_EQ(ErrorOf("a: [1, 2\nb: 3\n").substr(0, 9), "s.yaml:2:");
  EXPECT_EQ(ErrorOf(""), "s.yaml:1: the file is empty");
  EXPECT_EQ(ErrorOf("a: 1\n---\nb: 2\n").substr(0, 39), "s.yaml:1: a file holds one document: re");
  EXPECT_EQ(ErrorOf("[1, 2]: 3").substr(0, 28), "s.yaml:1: a key must be a te");
  EXPECT_EQ(ErrorOf("a: !!binary x").substr(0, 16), "s.yaml:1: the ta");
}

TEST(ParseYaml, CopiesWhatAnAliasNames) {
  const Document d = Parsed("a: &p [1, 2]\nb: *p\n");
  ASSERT_EQ(d.Find("b")->items.size(), 2u);
  EXPECT_EQ(d.Find("b")->items[1].number, 2);
}

TEST(ParseYaml, StopsABombOfAliases) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 20; ++i) {
    const std::string name = "a" + std::to_string(i), last = "*a" + std::to_string(i - 1);
    text += name + ": &" + name + " [";
    for (int k = 0; k < 10; ++k) text += last + ", ";
    text += "]\n";
  }
  EXPECT_NE(ErrorOf(text).find("more than 6000000 values"), std::string::npos);
}

TEST(ParseYaml, RefusesAnAliasInsideOfItsAnchor) { EXPECT_NE(ErrorOf("&a [*a]"), "no error"); }

TEST(ParseYaml, RefusesDeepNesting) {
  EXPECT_NE(ErrorOf(std::string(100, '[')), "no error");
  EXPECT_NE(ErrorOf(std::string(100000, '[')), "no error");
}

TEST(ParseYaml, ErrorsAreOneLine) {
  EXPECT_EQ(ErrorOf("a: !<x%0Ay> b\n").find('\n'), std::string::npos);
  EXPECT_EQ(ErrorOf("? \"a\\nb\"\n: 1\n\"a\\nb\": 2\n").find('\n'), std::string::npos);
}

TEST(ParseYaml, ReadsWindowsLineEnds) { EXPECT_EQ(Parsed("a: 1\r\nb: two\r\n").Find("b")->text, "two"); }

}  // namespace
}  // namespace tautline
