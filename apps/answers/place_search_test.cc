#include "apps/answers/place_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "apps/answers/place_answer.h"

namespace tautline {
namespace {

std::vector<std::size_t> Left(const PlaceSearch& search, const Shard& shard, std::span<const PlaceJob> done) {
  std::vector<std::size_t> numbers;
  for (const PlaceJob& job : done) numbers.push_back(job.job);
  return JobsLeft(search.jobs(), shard, numbers);
}

using testing::HasSubstr;

Scene Hall() {
  Scene scene;
  scene.path = "hall.yaml";
  scene.world.outline = {{0, 0}, {20, 0}, {20, 12}, {0, 12}};
  for (const Point low : {Point{4, 4}, {12, 7}}) {
    Obstacle block;
    block.name = "b" + std::to_string(scene.world.obstacles.size() + 1);
    block.polygon = PolygonWithHoles{{low, low + Point{2, 0}, low + Point{2, 1.5}, low + Point{0, 1.5}}, {}};
    scene.world.obstacles.push_back(block);
  }
  scene.tasks = {{3, 6}, {10, 6}};
  return scene;
}

const PlaceQuestion kQuestion = {.jobs = 7, .evaluations = 25, .seed = 3};

PlaceSearch Search(const Scene& scene = Hall(), const PlaceQuestion& question = kQuestion) {
  return PreparePlaceSearch(scene, question).value();
}

std::vector<PlaceJob> RunJobs(const PlaceSearch& search, const std::vector<std::size_t>& numbers) {
  std::vector<PlaceJob> jobs;
  for (const std::size_t job : numbers) {
    jobs.push_back(
        RunPlaceJob(search.ground, {.evaluations = search.question.evaluations, .seed = search.question.seed}, job)
            .value());
  }
  return jobs;
}

std::string Answer(const PlaceSearch& search, std::vector<PlaceJob> jobs) {
  return AnswerPlace(search, std::move(jobs), true).value().json.dump(1);
}

std::string FaultOf(const PlaceSearch& search, const std::string& part) {
  const auto jobs = ReadPart(search, part, "part.json");
  return jobs ? "" : ToString(jobs.error());
}

TEST(PlaceSearch, APartReadsBackToTheBit) {
  const PlaceSearch search = Search();
  const std::vector<PlaceJob> jobs = RunJobs(search, {1, 4, 6});
  const std::string text = PartJson(search, jobs, true).dump(1);
  EXPECT_EQ(ReadPart(search, text, "part.json").value(), jobs);
  EXPECT_EQ(ReadPartQuestion(text, "part.json").value(), search.question);
  EXPECT_EQ(PartJson(search, {jobs[2], jobs[0], jobs[1]}, true).dump(1), text) << "sorted";
}

TEST(PlaceSearch, ShardsJoinToTheBytesOfOneRun) {
  const PlaceSearch search = Search();
  const std::string whole = Answer(search, RunJobs(search, {0, 1, 2, 3, 4, 5, 6}));
  for (const std::size_t count : {1u, 2u, 3u, 7u, 9u}) {
    std::vector<NamedPart> parts;
    for (std::size_t index = count; index-- > 0;) {
      // Each shard as another machine would run it, and through its file.
      const PlaceSearch there = Search();
      const auto jobs = RunJobs(there, Left(there, {index, count}, {}));
      const std::string text = PartJson(there, jobs, true).dump(1);
      parts.push_back({"part" + std::to_string(index), ReadPart(search, text, "part").value()});
    }
    EXPECT_EQ(Answer(search, JoinParts(search, std::move(parts), false).value()), whole) << count;
  }
}

TEST(PlaceSearch, GoesOnFromWhatIsDone) {
  const PlaceSearch search = Search();
  const std::vector<PlaceJob> all = RunJobs(search, {0, 1, 2, 3, 4, 5, 6});
  const std::vector<PlaceJob> some = {all[5], all[0], all[3]};
  EXPECT_EQ(Left(search, {}, some), (std::vector<std::size_t>{1, 2, 4, 6}));
  EXPECT_EQ(Left(search, {1, 3}, some), (std::vector<std::size_t>{1, 4}));
  std::vector<PlaceJob> jobs = some;
  for (PlaceJob& job : RunJobs(search, Left(search, {}, some))) jobs.push_back(std::move(job));
  EXPECT_EQ(Answer(search, jobs), Answer(search, all));
}

TEST(PlaceSearch, RefusesPartsOfOtherSearches) {
  const PlaceSearch search = Search();
  const auto part_of = [](const Scene& scene, const PlaceQuestion& question) {
    const PlaceSearch other = Search(scene, question);
    return PartJson(other, RunJobs(other, {1}), true).dump(1);
  };
  PlaceQuestion question = kQuestion;
  question.seed = 4;
  EXPECT_THAT(FaultOf(search, part_of(Hall(), question)),
              HasSubstr("part.json: belongs to another search: its seed is 4 instead of 3"));
  question = kQuestion;
  question.objective = PlaceObjective::kCable;
  EXPECT_THAT(FaultOf(search, part_of(Hall(), question)), HasSubstr("its objective is \"cable\" instead of \"area\""));
  question = kQuestion;
  question.evaluations = 26;
  EXPECT_THAT(FaultOf(search, part_of(Hall(), question)), HasSubstr("its evaluations is 26 instead of 25"));
  Scene moved = Hall();
  moved.tasks[0].x += 1e-9;
  EXPECT_THAT(FaultOf(search, part_of(moved, kQuestion)), HasSubstr("another scene"));
  Scene grown = Hall();
  grown.world.obstacles[1].polygon->outer[0].x -= 1e-9;
  EXPECT_THAT(FaultOf(search, part_of(grown, kQuestion)), HasSubstr("another scene"));
  Scene moving = Hall();
  moving.futures = {{1, {{"b1", {{5, 4.75}, {5, 5}}}}}};
  EXPECT_THAT(FaultOf(search, part_of(moving, kQuestion)), HasSubstr("another scene"));
}

TEST(PlaceSearch, RefusesWhatIsNoPart) {
  const PlaceSearch search = Search();
  for (const char* text :
       {"", "[]", "{", "{}", "null", "{\"part\": 1}", "{\"part\": 1, \"search\": 3, \"scene\": {}}"}) {
    EXPECT_NE(FaultOf(search, text), "") << text;
    EXPECT_FALSE(ReadPartQuestion(text, "part.json").has_value()) << text;
  }
  EXPECT_THAT(FaultOf(search, "world: {}"), HasSubstr("part.json: is no part of `tautline workspace place`"));
  EXPECT_THAT(FaultOf(search, "{\"part\": 99}"), HasSubstr("another version"));
}

TEST(PlaceSearch, RefusesJobsThatCannotBeItsOwn) {
  const PlaceSearch search = Search();
  const Json good = PartJson(search, RunJobs(search, {1, 2}), true);
  ASSERT_EQ(FaultOf(search, good.dump()), "");
  const std::vector<std::pair<std::string, Json>> changes = {
      {"/done/0/job", 7},           {"/done/0/positions/0", -1.0}, {"/done/0/positions/0", 1e9},
      {"/done/0/positions", {}},    {"/done/0/start", {1.0}},      {"/done/0/gains/0/0", 0},
      {"/done/0/evaluations", 26},  {"/done/0/incomplete", 26},    {"/done/0/gains/0/1", -1.0},
      {"/done/0/positions", "far"}, {"/done/0/gains/0", 7}};
  for (const auto& [where, value] : changes) {
    Json changed = good;
    changed[Json::json_pointer(where)] = value;
    EXPECT_NE(FaultOf(search, changed.dump()), "") << where << " " << value;
  }
  Json better = good;
  for (const int i : {0, 1}) better["done"][i]["gains"].back()[2] = 1000.0;
  const auto answer = AnswerPlace(search, ReadPart(search, better.dump(), "part.json").value(), false);
  ASSERT_FALSE(answer.has_value());
  EXPECT_THAT(answer.error().message, HasSubstr("job 1 found a placement worth 1000"));
}

TEST(PlaceSearch, RefusesMissingAndRepeatedJobs) {
  const PlaceSearch search = Search();
  const auto fault_of = [&](std::vector<NamedPart> parts) {
    const auto joined = JoinParts(search, std::move(parts), false);
    return joined ? "" : ToString(joined.error());
  };
  const std::vector<PlaceJob> some = RunJobs(search, {0, 1, 2, 4, 5});
  EXPECT_THAT(fault_of({{"a", some}}), HasSubstr("of 7 jobs 2 stand in no part, job 3 first"));
  EXPECT_THAT(fault_of({{"a", some}, {"b", {some[1]}}}), HasSubstr("b: holds job 1, which a holds as well"));
  EXPECT_THAT(fault_of({{"a", {some[1], some[1]}}}), HasSubstr("a: holds job 1, which it holds twice"));
  const auto unfinished = JoinParts(search, {{"a", some}}, true);
  ASSERT_TRUE(unfinished);
  const PlaceAnswer answer = AnswerPlace(search, *unfinished, false).value();
  EXPECT_EQ(answer.json["jobs"], 7);
  EXPECT_EQ(answer.json["jobs_done"], 5);
}

TEST(PlaceSearch, TakesTheLimitOfTheSceneUnlessAsked) {
  Scene scene = Hall();
  EXPECT_EQ(Search(scene).ground.max_boundary(), 80) << "a quarter more than the outline";
  scene.max_boundary = 70;
  EXPECT_EQ(Search(scene).ground.max_boundary(), 70);
  PlaceQuestion question = kQuestion;
  question.max_boundary = 60;
  EXPECT_EQ(Search(scene, question).ground.max_boundary(), 60);
}

TEST(PlaceSearch, NeedsNoJobsWhereATaskIsLost) {
  Scene scene = Hall();
  scene.tasks.push_back({5, 5});
  const PlaceSearch search = Search(scene);
  EXPECT_TRUE(Left(search, {}, {}).empty());
  const PlaceAnswer answer = AnswerPlace(search, JoinParts(search, {}, false).value(), false).value();
  EXPECT_EQ(answer.status, kExitInfeasible);
  EXPECT_EQ(answer.json["status"], "infeasible");
  EXPECT_EQ(answer.json["reason"], "task_outside");
}

TEST(PlaceSearch, RefusesTooMuch) {
  PlaceQuestion question = kQuestion;
  question.jobs = 1'000'001;
  EXPECT_FALSE(PreparePlaceSearch(Hall(), question));
  question = kQuestion;
  question.anchors = 1001;
  EXPECT_FALSE(PreparePlaceSearch(Hall(), question));
}

}  // namespace
}  // namespace tautline
