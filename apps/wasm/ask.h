// One question to tautline where there are neither files nor a command line: in a browser.
#ifndef APPS_WASM_ASK_H_
#define APPS_WASM_ASK_H_

#include <map>
#include <string>

namespace tautline::wasm {

/// The bytes of files by their names: the maps that scenes name, and the images that maps name.
using Files = std::map<std::string, std::string>;

struct Question {
  std::string command;  ///< As the program has them: `plan`, `workspace best`, `fleet check`; see docs/wasm.md.
  std::string scene;    ///< JSON.
  std::string options;  ///< JSON; see ask_options.h. Empty: none.
  Files files;          ///< The map by its name in the scene; the image of a ROS map beside it.
};

struct Reply {
  int status = 0;      ///< The exit status that the program would have; see docs/formats.md.
  std::string answer;  ///< What the program prints with --json; empty for statuses 1 and 2.
  std::string error;   ///< For statuses 1 and 2: what is wrong, where, and how to mend it; one line.
  std::string svg;     ///< The picture, where the options ask for one and there is an answer.
  std::string film;    ///< The motion as an SVG that moves, likewise; of fleet plan and fleet simulate.
};

/// Answers as the program does. The settings of a ROS map must be JSON, and its image a PGM. Never throws but where
/// memory for the reply itself is lacking. Keeps nothing between calls.
Reply Ask(const Question& question);

}  // namespace tautline::wasm

#endif  // APPS_WASM_ASK_H_
