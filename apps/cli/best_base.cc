#include "apps/cli/best_base.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "apps/cli/describe.h"
#include "apps/cli/kept_jobs.h"
#include "apps/cli/option_checks.h"
#include "tautline/draw/draw_best_base.h"

namespace tautline::cli {
namespace {

/// Candidates listed in the text; JSON has all.
constexpr std::size_t kMostListed = 5;

/// What a shard cannot be asked for.
std::optional<Error> ShardFault(const CommonOptions& common, const BestBaseOptions& options) {
  if (!options.parts.empty()) {
    return Error{ErrorCode::kInvalidInput, "--parts joins what shards found; leave out one of the two", "--shard"};
  }
  if (!common.svg.empty() || !common.png.empty()) {
    return Error{ErrorCode::kInvalidInput,
                 "a picture shows all candidates, and --shard does a part of them; draw with --parts",
                 common.svg.empty() ? "--png" : "--svg"};
  }
  if (options.checkpoint.empty() && !common.json) {
    return Error{ErrorCode::kInvalidInput,
                 "nothing would be left of the shard; name a file with --checkpoint, or print the part with --json",
                 "--shard"};
  }
  return std::nullopt;
}

Expected<std::vector<BaseTrial>> JoinBaseParts(const CommonOptions& common, const BestBaseOptions& options,
                                               const BaseSearch& search) {
  std::vector<PartNumbers> numbers;
  std::vector<BaseTrial> trials;
  for (const std::string& path : options.parts) {
    if (auto kept = KeepInput(common, path); !kept) return tl::unexpected(kept.error());
    const auto text = ReadPartFile(path);
    if (!text) return tl::unexpected(text.error());
    const auto part = ReadBasePart(search, *text, path);
    if (!part) return tl::unexpected(part.error());
    PartNumbers& of_part = numbers.emplace_back(PartNumbers{path, {}});
    for (const BaseTrial& trial : *part) {
      of_part.jobs.push_back(trial.job);
      trials.push_back(trial);
    }
  }
  const auto checked = CheckParts(search.candidates.size(), numbers, options.unfinished);
  if (!checked) return tl::unexpected(checked.error());
  std::sort(trials.begin(), trials.end(), [](const BaseTrial& a, const BaseTrial& b) { return a.job < b.job; });
  return trials;
}

Expected<std::vector<BaseTrial>> RunTrials(const CommonOptions& common, const BestBaseOptions& options,
                                           const BaseSearch& search, const Shard& shard) {
  ProgressBar progress(!common.quiet);
  const KeptJobs<BaseTrial> jobs{
      .compute = [&](std::size_t job) { return search.Run(job); },
      .read = [&](std::string_view text, const std::string& name) { return ReadBasePart(search, text, name); },
      .write = [&](const std::vector<BaseTrial>& done, bool complete) { return BasePartJson(search, done, complete); }};
  auto trials = jobs.Run({.jobs = search.candidates.size(),
                          .shard = shard,
                          .threads = common.threads,
                          .checkpoint = options.checkpoint,
                          .stage = "bases"},
                         progress);
  progress.Clear();
  return trials;
}

std::string ToText(const BaseSearch& search, const BaseAnswer& answer) {
  if (answer.ranked.empty()) return fmt::format("No best base: {}.\n", answer.explanation);
  const double cell_area = search.ground.cell_m() * search.ground.cell_m();
  std::string text = fmt::format("The best of {}:\n", Counted(answer.ranked.size(), "base", "bases"));
  for (std::size_t i = 0; i < std::min(kMostListed, answer.ranked.size()); ++i) {
    const BaseTrial& trial = answer.ranked[i];
    const Point at = search.ground.CentreOf(trial.base);
    text += fmt::format("  {:>2}  {:<18} reaches {}", i + 1, Describe({&at, 1}),
                        SquareMetres(static_cast<double>(trial.cells) * cell_area));
    if (search.trial.deadlocks) {
      text += fmt::format(", {} close {} over all classes",
                          Counted(static_cast<std::size_t>(trial.deadlocks), "deadlock", "deadlocks"),
                          SquareMetres(static_cast<double>(trial.closed) * cell_area));
    }
    text += "\n";
  }
  const std::size_t incomplete = answer.json.at("incomplete").get<std::size_t>();
  if (incomplete > 0) text += fmt::format("  left out  {} that took more than the budget\n", incomplete);
  return text;
}

Expected<int> DeliverShard(const CommonOptions& common, const BestBaseOptions& options, const BaseSearch& search,
                           std::vector<BaseTrial> trials) {
  const std::string text =
      fmt::format("Shard {} is done: {}{}.\n", options.shard, Counted(trials.size(), "job", "jobs"),
                  options.checkpoint.empty() ? "" : " in " + options.checkpoint);
  return Deliver(common, {.json = BasePartJson(search, std::move(trials), true), .text = text, .draw = {}});
}

}  // namespace

void AddBestBaseOptions(CLI::App& command, BestBaseOptions& options) {
  CLI::Option* asked = command.add_flag("--best-base", options.asked, "instead: the best place for the base");
  command
      .add_option("--objective", options.objective,
                  "of the base: area, the most ground reached; deadlock, the least area in deadlocks")
      ->check(CLI::IsMember({"area", "deadlock"}))
      ->capture_default_str()
      ->needs(asked);
  command.add_option("--candidates", options.candidates, "bases on a lattice over the map, or along walls")
      ->check(CLI::IsMember({"lattice", "walls"}))
      ->capture_default_str()
      ->needs(asked);
  command.add_option("--spacing", options.spacing, "between candidates; default: a 20th of the map's longer side")
      ->type_name("METRES")
      ->check(Positive())
      ->needs(asked);
  command.add_option("--checkpoint", options.checkpoint, "keep finished candidates in this file, and go on from those")
      ->type_name("FILE")
      ->check(FileName())
      ->needs(asked);
  command.add_option("--shard", options.shard, "do the I-th of N parts of the candidates; --parts joins them")
      ->type_name("I/N")
      ->needs(asked);
  command.add_option("--parts", options.parts, "join these parts of --shard instead of searching")
      ->type_name("FILE")
      ->needs(asked);
  command.add_flag("--unfinished", options.unfinished, "with --parts: join what there is")->needs(asked);
}

Expected<int> RunBestBase(const CommonOptions& common, const BestBaseOptions& options, BaseQuestion question) {
  Shard shard;
  if (!options.shard.empty()) {
    const auto parsed = ParseShard(options.shard);
    if (!parsed) return tl::unexpected(parsed.error());
    if (const auto fault = ShardFault(common, options)) return tl::unexpected(*fault);
    shard = *parsed;
  }
  const auto scene = ReadScene(common, options.checkpoint);
  if (!scene) return tl::unexpected(scene.error());
  question.objective = options.objective == "area" ? BaseObjective::kArea : BaseObjective::kDeadlock;
  question.candidates = options.candidates == "walls" ? BaseCandidates::kWalls : BaseCandidates::kLattice;
  if (options.spacing > 0) question.spacing_m = options.spacing;
  const auto search = PrepareBaseSearch(*scene, question);
  if (!search) return tl::unexpected(search.error());
  auto trials =
      options.parts.empty() ? RunTrials(common, options, *search, shard) : JoinBaseParts(common, options, *search);
  if (!trials) return tl::unexpected(trials.error());
  if (!options.shard.empty()) return DeliverShard(common, options, *search, *std::move(trials));
  const BaseAnswer answer = AnswerBases(*search, *std::move(trials));
  const auto draw = [&] {
    return DrawBestBase(*scene, {&search->ground, answer.ranked, search->question.objective, answer.explanation});
  };
  return Deliver(common, {.json = answer.json, .text = ToText(*search, answer), .draw = draw, .status = answer.status});
}

}  // namespace tautline::cli
