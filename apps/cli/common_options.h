// The options that all commands share, and the answer that all commands give.
#ifndef APPS_CLI_COMMON_OPTIONS_H_
#define APPS_CLI_COMMON_OPTIONS_H_

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/scene.h"

namespace tautline::cli {

struct CommonOptions {
  std::string scene;
  bool json = false;
  bool quiet = false;
  bool verify = false;
  std::string unknown = "blocked";  ///< Or "free".
  std::string svg;
  std::string png;
  std::string prepared;       ///< A prepared map to read; commands that take one add the option.
  std::string csv;            ///< Where to write a table; commands that have one add the option.
  std::string save_prepared;  ///< Where to keep the preparation.
  std::string policy;         ///< Where to write a policy; commands that teach one add the option --out.
  std::string animate;        ///< Where to draw the motion as a film; commands that have one add the option.
  double simplify = 0;
  int threads = 1;
  std::uint64_t seed = 1;
};

/// Adds SCENE and the common options to a command.
void AddCommonOptions(CLI::App& command, CommonOptions& options);

/// Reads the scene that the options name. Errors: as ReadSceneFile, and outputs that would replace each other, the
/// scene, its map, the prepared map or `other_input` (a path; may be empty).
[[nodiscard]] Expected<Scene> ReadScene(const CommonOptions& options, const std::string& other_input = "");

/// That no output would replace this input (a path; may be empty).
[[nodiscard]] Expected<void> KeepInput(const CommonOptions& options, const std::string& input);

/// What a command found, in the forms in which it can be handed out.
struct Answer {
  const nlohmann::ordered_json& json;
  std::string text;                            ///< For people, with the final newline.
  std::function<std::string()> draw;           ///< The picture as SVG; called only where one is asked for.
  std::function<std::string()> csv = {};       ///< The table for --csv; called only where it is asked for.
  std::function<std::string()> prepared = {};  ///< The bytes for --save-prepared; called only where they are asked for.
  std::function<std::string()> policy = {};    ///< The policy for --out; called only where it is asked for.
  std::function<std::string()> animate = {};   ///< The film for --animate as SVG; called only where it is asked for.
  int status = 0;
};

/// Writes the answer to standard output and puts its files in place, all or none; the exit status, or what could
/// not be written. Files are written before anything is printed, and put in place after.
[[nodiscard]] Expected<int> Deliver(const CommonOptions& options, const Answer& answer);

}  // namespace tautline::cli

#endif  // APPS_CLI_COMMON_OPTIONS_H_
