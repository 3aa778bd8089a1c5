#include "apps/wasm/ask.h"

#include <exception>
#include <new>
#include <utility>

#include "apps/answers/reach_answer.h"
#include "apps/answers/show_answer.h"
#include "apps/pictures/fleet_pictures.h"
#include "apps/pictures/manifold_pictures.h"
#include "apps/pictures/workspace_pictures.h"
#include "apps/wasm/ask_options.h"
#include "tautline/draw/draw_classes.h"
#include "tautline/draw/draw_fleet.h"
#include "tautline/draw/draw_plan.h"
#include "tautline/draw/draw_reach.h"
#include "tautline/draw/draw_show.h"
#include "tautline/draw/draw_taut.h"
#include "tautline/scene/json_document.h"
#include "tautline/scene/map_reader.h"
#include "tautline/scene/scene_reader.h"

namespace tautline::wasm {
namespace {

MapSources SourcesIn(const Files& files) {
  const auto read = [&files](const std::string& path, std::size_t max_bytes) -> Expected<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) {
      return tl::unexpected<Error>(
          Error{ErrorCode::kUnreadable, "is not among the files of the question: hand it over by this name", path});
    }
    if (found->second.size() > max_bytes) {
      const std::string limit = std::to_string(max_bytes >> 20);
      return tl::unexpected<Error>(Error{ErrorCode::kLimitExceeded, "larger than " + limit + " MiB", path});
    }
    return found->second;
  };
  const auto parse_settings = [](const std::string& text, const std::string& path) {
    return ParseJson(text, path).map_error([](Error error) {
      error.message += "; here the settings of a ROS map must be JSON, not YAML";
      return error;
    });
  };
  const auto parse_png = [](const std::string&, const std::string& path) -> Expected<RasterImage> {
    return tl::unexpected<Error>(
        Error{ErrorCode::kUnsupported, "PNG is not read here: hand the image over as a PGM", path});
  };
  return {.read = read, .parse_settings = parse_settings, .parse_png = parse_png};
}

Expected<Scene> ReadScene(const Question& question, const SceneOptions& options) {
  const auto document = ParseJson(question.scene, "scene");
  if (!document) return tl::unexpected(document.error());
  const MapSources sources = SourcesIn(question.files);
  const auto load_map = [&](const std::string& name) { return ReadMap(name, sources, options); };
  return tautline::ReadScene(*document, "scene", load_map);
}

Reply Refuse(const Error& error) { return {.status = kExitBadInput, .error = ToString(error)}; }

/// As the program prints it.
std::string Text(const Json& json) { return json.dump(1) + "\n"; }

Reply Plan(const Scene& scene, const AskOptions& options) {
  const auto answer = AnswerPlan(scene, options.plan);
  if (!answer) return Refuse(answer.error());
  Reply reply{.status = answer->status, .answer = Text(answer->json)};
  if (options.svg) reply.svg = DrawPlan(scene, answer->planner.space().free_space(), answer->result);
  return reply;
}

Reply Reach(const Scene& scene, const AskOptions& options) {
  const auto answer = AnswerReach(scene, options.reach);
  if (!answer) return Refuse(answer.error());
  Reply reply{.status = answer->status, .answer = Text(answer->json)};
  if (options.svg) reply.svg = DrawReach(scene, answer->planner.space().free_space(), answer->result);
  return reply;
}

Reply Classes(const Scene& scene, const AskOptions& options) {
  const auto answer = AnswerClasses(scene, options.classes);
  if (!answer) return Refuse(answer.error());
  Reply reply{.status = answer->status, .answer = Text(answer->json)};
  if (options.svg) {
    const ClassesQuestion& asked = answer->question;
    const ClassesPicture picture{.from = *asked.from, .to = *asked.to, .list = answer->list};
    reply.svg = DrawClasses(scene, answer->planner.space().free_space(), picture);
  }
  return reply;
}

Reply Taut(const Scene& scene, const AskOptions& options) {
  const auto answer = AnswerTaut(scene, options.taut);
  if (!answer) return Refuse(answer.error());
  Reply reply{.status = answer->status, .answer = Text(answer->json)};
  if (options.svg) {
    const TautPicture picture{.laid = *scene.tether->laid, .taut = answer->taut};
    reply.svg = DrawTaut(scene, answer->planner.space().free_space(), picture);
  }
  return reply;
}

Reply Show(const Scene& scene, const AskOptions& options) {
  const auto answer = AnswerShow(scene);
  if (!answer) return Refuse(answer.error());
  Reply reply{.status = kExitSolved, .answer = Text(answer->json)};
  if (options.svg) reply.svg = DrawShow(scene, answer->space);
  return reply;
}

/// The answer of a command whose picture DrawAnswer makes.
template <class Answer>
Reply ReplyWith(const Scene& scene, const AskOptions& options, const Expected<Answer>& answer) {
  if (!answer) return Refuse(answer.error());
  Reply reply{.status = answer->status, .answer = Text(answer->json)};
  if (options.svg) reply.svg = DrawAnswer(scene, *answer);
  return reply;
}

Reply Boundary(const Scene& scene, const AskOptions& options) {
  return ReplyWith(scene, options, AnswerBoundary(scene, options.boundary));
}

Reply Best(const Scene& scene, const AskOptions& options) {
  return ReplyWith(scene, options, AnswerBest(scene, options.best));
}

Reply PoseIn(const Scene& scene, const AskOptions& options) {
  return ReplyWith(scene, options, AnswerPose(scene, options.pose));
}

Reply MoveTo(const Scene& scene, const AskOptions& options) {
  return ReplyWith(scene, options, AnswerMove(scene, options.move));
}

Reply TourOver(const Scene& scene, const AskOptions& options) {
  return ReplyWith(scene, options, AnswerTour(scene, options.tour));
}

Reply Check(const Scene& scene, const AskOptions& options) { return ReplyWith(scene, options, AnswerCheck(scene)); }

Reply Layouts(const Scene& scene, const AskOptions& options) {
  return ReplyWith(scene, options, AnswerLayouts(scene, options.layouts));
}

/// How many moments a playback must show for what is asked.
int FramesFor(const Scene& scene, const AskOptions& options) {
  return options.animate && scene.fleet ? FilmFrames(scene.fleet->robots.size()) : 0;
}

/// As ReplyWith, with the film.
template <class Answer>
Reply ReplyWithFilm(const Scene& scene, const AskOptions& options, const Expected<Answer>& answer) {
  Reply reply = ReplyWith(scene, options, answer);
  if (answer && options.animate) reply.film = AnimateAnswer(scene, *answer);
  return reply;
}

Reply PlanFleetMotion(const Scene& scene, const AskOptions& options) {
  FleetPlanQuestion question = options.fleet_plan;
  question.playback.frames = FramesFor(scene, options);
  return ReplyWithFilm(scene, options, AnswerFleetPlan(scene, question));
}

Reply Simulate(const Scene& scene, const AskOptions& options) {
  SimulateQuestion question = options.simulate;
  question.frames = FramesFor(scene, options);
  return ReplyWithFilm(scene, options, AnswerSimulate(scene, question));
}

Reply Manifold(const Scene& scene, const AskOptions& options) {
  ManifoldQuestion question = options.manifold;
  question.cells.unknown_free = options.scene.unknown_free;
  return ReplyWith(scene, options, AnswerManifold(scene, question));
}

Reply Answer(const Question& question) {
  const auto options = ReadAskOptions(question.command, question.options);
  if (!options) return Refuse(options.error());
  const auto scene = ReadScene(question, options->scene);
  if (!scene) return Refuse(scene.error());
  using Answerer = Reply (*)(const Scene&, const AskOptions&);
  const std::pair<const char*, Answerer> answerers[] = {{"plan", Plan},
                                                        {"reach", Reach},
                                                        {"classes", Classes},
                                                        {"taut", Taut},
                                                        {"show", Show},
                                                        {"workspace boundary", Boundary},
                                                        {"workspace best", Best},
                                                        {"workspace pose", PoseIn},
                                                        {"workspace move", MoveTo},
                                                        {"workspace tour", TourOver},
                                                        {"fleet check", Check},
                                                        {"fleet layouts", Layouts},
                                                        {"fleet plan", PlanFleetMotion},
                                                        {"fleet simulate", Simulate},
                                                        {"manifold", Manifold}};
  for (const auto& [name, answerer] : answerers) {
    if (question.command == name) return answerer(*scene, *options);
  }
  return {.status = kExitFault, .error = "a command without an answer: " + question.command};
}

}  // namespace

Reply Ask(const Question& question) {
  try {
    return Answer(question);
  } catch (const std::bad_alloc&) {
    return {.status = kExitFault, .error = "out of memory: the scene is too large for this machine"};
  } catch (const std::exception& fault) {
    return {.status = kExitFault,
            .error = std::string("a fault of tautline's own, please report it with the scene: ") + fault.what()};
  }
}

}  // namespace tautline::wasm
