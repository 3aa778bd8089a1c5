#include "tautline/homotopy/word.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tautline/base/rng.h"

namespace tautline {
namespace {

const std::vector<std::string> kNames{"a", "b", "tank"};

Word W(std::string_view text) { return ParseWord(text, kNames).value(); }

std::string Text(const Word& word) { return ToString(word, kNames); }

Word RandomWord(Rng& rng) {
  Word word;
  for (int i = rng.UniformInt(0, 12); i > 0; --i) {
    word.Append({ObstacleId(rng.UniformInt(0, 2)), rng.UniformInt(0, 1) == 1});
  }
  return word;
}

TEST(Word, IsWrittenAsItIsRead) {
  for (const std::string text : {"", "a", "a^-1", "a b^-1 tank tank", "tank^-1 a b a^-1"}) {
    EXPECT_EQ(Text(W(text)), text);
  }
  EXPECT_EQ(ToStrings(W("a b^-1"), kNames), (std::vector<std::string>{"a", "b^-1"}));
  EXPECT_TRUE(ToStrings(Word(), kNames).empty());
}

TEST(Word, IsReduced) {
  EXPECT_EQ(Text(W("a a^-1")), "");
  EXPECT_EQ(Text(W("a^-1 a")), "");
  EXPECT_EQ(Text(W("a b b^-1 a^-1 tank")), "tank");
  EXPECT_EQ(Text(W("a b a^-1 b^-1")), "a b a^-1 b^-1");
}

TEST(Word, ProductsCancelWhereTheyMeet) {
  EXPECT_EQ(Text(W("a b") * W("b^-1 a")), "a a");
  EXPECT_EQ(Text(W("a b") * W("b^-1 a^-1")), "");
  EXPECT_EQ(Text(W("a b") * W("")), "a b");
  EXPECT_EQ(Text(W("a b^-1 tank").Inverse()), "tank^-1 b a^-1");
}

TEST(Word, IsAGroup) {
  Rng rng(1);
  for (int round = 0; round < 1000; ++round) {
    const Word u = RandomWord(rng), v = RandomWord(rng), w = RandomWord(rng);
    EXPECT_TRUE((u * u.Inverse()).empty());
    EXPECT_TRUE((u.Inverse() * u).empty());
    EXPECT_EQ(u.Inverse().Inverse(), u);
    EXPECT_EQ((u * v) * w, u * (v * w));
    EXPECT_EQ((u * v).Inverse(), v.Inverse() * u.Inverse());
    EXPECT_EQ(W(Text(u)), u);
    EXPECT_EQ(u.empty(), u.size() == 0);
    EXPECT_LE((u * v).size(), u.size() + v.size());
  }
}

TEST(Word, AppendsItself) {
  Word word = W("a b");
  word = word * word;
  EXPECT_EQ(Text(word), "a b a b");
  Word squared = W("a b");
  squared.Append(squared);
  EXPECT_EQ(Text(squared), "a b a b");
}

TEST(ParseWord, ForgivesSpaces) { EXPECT_EQ(Text(W("  a   b^-1 ")), "a b^-1"); }

TEST(ParseWord, NamesWhatItDoesNotKnow) {
  for (const std::string text : {"a c", "a^-2", "a^-1^-1", "^-1", "ab", "A", "a,b"}) {
    const Expected<Word> word = ParseWord(text, kNames);
    ASSERT_FALSE(word) << text;
    EXPECT_EQ(word.error().code, ErrorCode::kInvalidInput);
  }
  EXPECT_NE(ParseWord("a c^-1", kNames).error().message.find("'c'"), std::string::npos);
  EXPECT_FALSE(ParseWord("a", {}));
  EXPECT_TRUE(ParseWord("", {})->empty());
}

}  // namespace
}  // namespace tautline
