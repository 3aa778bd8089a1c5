#include "apps/wasm/ask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/answers/json_values.h"

namespace tautline::wasm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A block between the robot and its goal; the cable lies above it.
const char kBlock[] = R"({
  "world": {"outline": [[0, 0], [16, 0], [16, 10], [0, 10]],
            "obstacles": [{"name": "block", "polygon": [[4, 3], [12, 3], [12, 7], [4, 7]]}]},
  "tether": {"base": [2, 5], "length": 12.8, "laid": [[2, 5], [4, 7], [12, 7], [13, 6]]},
  "goal": [13, 4]})";

const char kRoomWithMap[] = R"({"world": {"map": "maps/room.yaml"}, "tether": {"base": [0.5, 0.5], "length": 9},
                                "goal": [2.5, 0.5]})";

const char kSettings[] = R"({"image": "room.pgm", "resolution": 1, "origin": [0, 0, 0], "negate": 0,
                             "occupied_thresh": 0.65, "free_thresh": 0.196})";

/// Three columns and two rows; the lower middle cell is blocked.
const char kImage[] = "P2 3 2 255  255 255 255  255 0 255";

Reply AskAbout(const std::string& command, const std::string& scene, const std::string& options = "",
               const Files& files = {}) {
  return Ask({.command = command, .scene = scene, .options = options, .files = files});
}

TEST(Ask, PlansAsTheProgramDoes) {
  const Reply reply = AskAbout("plan", kBlock);
  EXPECT_EQ(reply.status, 0);
  EXPECT_THAT(reply.error, IsEmpty());
  EXPECT_THAT(reply.svg, IsEmpty());
  const Json answer = Json::parse(reply.answer);
  EXPECT_EQ(answer["command"], "plan");
  EXPECT_EQ(answer["status"], "solved");
  EXPECT_EQ(answer["path"], Json::parse("[[13, 6], [12, 7], [4, 7], [4, 3], [12, 3], [13, 4]]"));
}

TEST(Ask, DrawsWhereAsked) {
  for (const char* command : {"plan", "reach", "classes", "taut", "show"}) {
    EXPECT_THAT(AskAbout(command, kBlock, R"({"svg": true})").svg, HasSubstr("<svg")) << command;
  }
}

TEST(Ask, OptionsReachTheCommand) {
  EXPECT_EQ(Json::parse(AskAbout("classes", kBlock, R"({"count": 3})").answer)["classes"].size(), 3U);
  const Json one = Json::parse(AskAbout("classes", kBlock, R"({"word": "", "to": [2, 8]})").answer);
  EXPECT_EQ(one["classes"][0]["length"], 3);
  const Json all = Json::parse(AskAbout("plan", kBlock, R"({"all": true, "verify": true})").answer);
  EXPECT_TRUE(all.contains("all"));
  EXPECT_TRUE(all.contains("verified"));
  const Json free = Json::parse(AskAbout("plan", kBlock, R"({"crossing_free": true})").answer);
  EXPECT_TRUE(free["crossing_free"]["optimal"]);
}

TEST(Ask, InfeasibleHasAnAnswerAndStatus3) {
  const Reply reply = AskAbout("classes", kBlock, R"({"to": [8, 5]})");
  EXPECT_EQ(reply.status, 3);
  EXPECT_EQ(Json::parse(reply.answer)["reason"], "goal_blocked");
}

TEST(Ask, BadInputIsOneLineAndNothingElse) {
  const std::pair<Reply, const char*> faults[] = {
      {AskAbout("paln", kBlock),
       "there is no command 'paln'; there are plan, reach, classes, taut, show, workspace boundary, workspace best, "
       "workspace pose, "
       "workspace move and workspace tour"},
      {AskAbout("plan", "{"), "scene:1: not valid JSON"},
      {AskAbout("plan", R"({"world": 1})"), "scene:1: world must be a map"},
      {AskAbout("plan", kBlock, "[]"), "options:1: options must be a map"},
      {AskAbout("plan", kBlock, R"({"cuont": 1})"), "options:1: unknown key 'cuont'"},
      {AskAbout("plan", kBlock, R"({"count": 0})"), "options:1: count must be a whole number of 1 or more"},
      {AskAbout("plan", kBlock, R"({"count": 1.5})"), "options:1: count must be a whole number of 1 or more"},
      {AskAbout("plan", kBlock, R"({"all": 1})"), "options:1: all must be true or false, not the number 1"},
      {AskAbout("plan", kBlock, R"({"simplify": -1})"), "options:1: simplify is -1"},
      {AskAbout("plan", kBlock, R"({"unknown": "maybe"})"), "options:1: unknown is 'maybe'"},
      {AskAbout("taut", kBlock, R"({"all": true})"), "options:1: unknown key 'all'"},
      {AskAbout("classes", kBlock, R"({"word": "", "count": 1})"), "options:1: word excludes"},
      {AskAbout("classes", kBlock, R"({"word": "wall"})"), "--word: "},
      {AskAbout("classes", kBlock, R"({"from": [1]})"), "options:1: from must be a point"},
  };
  for (const auto& [reply, want] : faults) {
    EXPECT_EQ(reply.status, 2) << want;
    EXPECT_THAT(reply.error, StartsWith(want));
    EXPECT_EQ(reply.error.find('\n'), std::string::npos) << want;
    EXPECT_THAT(reply.answer, IsEmpty()) << want;
  }
}

TEST(Ask, ReadsAMapAndTheImageBesideIt) {
  const Reply reply = AskAbout("plan", kRoomWithMap, "", {{"maps/room.yaml", kSettings}, {"maps/room.pgm", kImage}});
  EXPECT_EQ(reply.error, "");
  EXPECT_EQ(Json::parse(reply.answer)["path"], Json::parse("[[0.5, 0.5], [1, 1], [2, 1], [2.5, 0.5]]"));
}

TEST(Ask, SaysWhichFileOfAMapIsMissingOrCannotBeRead) {
  EXPECT_THAT(AskAbout("plan", kRoomWithMap).error, HasSubstr("maps/room.yaml: is not among the files"));
  EXPECT_THAT(AskAbout("plan", kRoomWithMap, "", {{"maps/room.yaml", kSettings}}).error,
              HasSubstr("maps/room.pgm: is not among the files"));
  EXPECT_THAT(AskAbout("plan", kRoomWithMap, "", {{"maps/room.yaml", "image: room.pgm"}}).error,
              HasSubstr("must be JSON, not YAML"));
  EXPECT_THAT(AskAbout("plan", kRoomWithMap, "", {{"maps/room.yaml", kSettings}, {"maps/room.pgm", "\x89PNG"}}).error,
              HasSubstr("hand the image over as a PGM"));
}

TEST(Ask, RefusesAnImageWhosePixelCountWrapsAroundIn32Bits) {
  const Reply reply = AskAbout("show", kRoomWithMap, "",
                               {{"maps/room.yaml", kSettings}, {"maps/room.pgm", "P5 16777216 16777216 255\n"}});
  EXPECT_THAT(reply.error, HasSubstr("more than 8192 x 8192 pixels"));
}

}  // namespace
}  // namespace tautline::wasm
