#include "apps/wasm/ask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/answers/json_values.h"

namespace tautline::wasm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A block between the robot and its goal; the cable lies above it.
const char kBlock[] = R"({
  "world": {"outline": [[0, 0], [16, 0], [16, 10], [0, 10]],
            "obstacles": [{"name": "block", "polygon": [[4, 3], [12, 3], [12, 7], [4, 7]]}]},
  "tether": {"base": [2, 5], "length": 12.8, "laid": [[2, 5], [4, 7], [12, 7], [13, 6]]},
  "goal": [13, 4]})";

/// Two robots whose straight paths cross; the cable of r2 bends around the target of r1.
const char kTwoRobots[] = R"({"fleet": {"speed": 1, "robots": [
  {"name": "r1", "start": [0, 0], "target": [4, 4], "cable": [[0, 0], [4, 4]]},
  {"name": "r2", "start": [4, 0], "target": [0, 4], "cable": [[4, 0], [4, 4], [0, 4]]}]}})";

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
  for (const char* command : {"fleet check", "fleet layouts", "fleet plan", "fleet simulate"}) {
    EXPECT_THAT(AskAbout(command, kTwoRobots, R"({"svg": true})").svg, HasSubstr("<svg")) << command;
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

TEST(Ask, OptionsReachTheFleetCommands) {
  EXPECT_EQ(AskAbout("fleet check", kTwoRobots).status, 0);
  const Json layouts = Json::parse(AskAbout("fleet layouts", kTwoRobots, R"({"count": 1, "count_all": true})").answer);
  EXPECT_EQ(layouts["layouts"].size(), 1U);
  EXPECT_EQ(layouts["all"], 2);
  const Json bent = Json::parse(AskAbout("fleet plan", kTwoRobots, R"({"mode": "bent-sequential"})").answer);
  EXPECT_EQ(bent["mode"], "bent-sequential");
  const Json close = Json::parse(AskAbout("fleet plan", kTwoRobots).answer);
  const Json wide = Json::parse(AskAbout("fleet plan", kTwoRobots, R"({"gap": 1, "speeds": true})").answer);
  EXPECT_NEAR(wide["travel_time"].get<double>(), close["travel_time"].get<double>() + 2, 1e-9);
  EXPECT_EQ(wide["schedule"].dump().find("wait"), std::string::npos);
  EXPECT_EQ(AskAbout("fleet simulate", kTwoRobots, R"({"order": ["r2", "r1"]})").status, 0);
  EXPECT_EQ(AskAbout("fleet simulate", kTwoRobots, R"({"order": ["r1", "r2"]})").status, 3);
}

TEST(Ask, FilmsTheMotionWhereAsked) {
  for (const char* command : {"fleet plan", "fleet simulate"}) {
    const Reply reply = AskAbout(command, kTwoRobots, R"({"svg": true, "animate": true})");
    EXPECT_THAT(reply.svg, Not(HasSubstr("<animate"))) << command;
    EXPECT_THAT(reply.film, HasSubstr("<animate")) << command;
    EXPECT_THAT(AskAbout(command, kTwoRobots).film, IsEmpty()) << command;
  }
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
       "workspace pose, workspace move, workspace tour, fleet check, fleet layouts, fleet plan, fleet simulate and manifold"},
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
      {AskAbout("fleet plan", kTwoRobots, R"({"mode": "bent"})"), "options:1: mode is 'bent': it must be straight"},
      {AskAbout("fleet plan", kTwoRobots, R"({"gap": -1})"), "options:1: gap is -1"},
      {AskAbout("fleet plan", kBlock), "scene: "},
      {AskAbout("fleet simulate", kTwoRobots, R"({"order": "r1,r2"})"), "options:1: order must be a list of names"},
      {AskAbout("fleet simulate", kTwoRobots, R"({"order": ["r1", "r2"], "mode": "bent-concurrent"})"),
       "options:1: order excludes mode"},
      {AskAbout("fleet simulate", kTwoRobots, R"({"order": ["r1"]})"), "--order: 'r2' is missing"},
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
