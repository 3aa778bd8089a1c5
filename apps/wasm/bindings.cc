// What JavaScript sees: the function `ask`. See docs/wasm.md.
#include <emscripten/bind.h>

#include "apps/wasm/ask.h"

namespace tautline::wasm {
namespace {

/// An object of names and bytes: Uint8Array, or texts, which become UTF-8.
Files FilesOf(const emscripten::val& object) {
  Files files;
  if (object.isUndefined() || object.isNull()) return files;
  const emscripten::val entries = emscripten::val::global("Object").call<emscripten::val>("entries", object);
  const auto count = entries["length"].as<unsigned>();
  for (unsigned i = 0; i < count; ++i) {
    const emscripten::val entry = entries[i];
    files[entry[0].as<std::string>()] = entry[1].as<std::string>();
  }
  return files;
}

Reply AskFromJavaScript(const std::string& command, const std::string& scene, const std::string& options,
                        const emscripten::val& files) {
  return Ask({.command = command, .scene = scene, .options = options, .files = FilesOf(files)});
}

}  // namespace
}  // namespace tautline::wasm

EMSCRIPTEN_BINDINGS(tautline) {
  using tautline::wasm::Reply;
  emscripten::value_object<Reply>("Reply")
      .field("status", &Reply::status)
      .field("answer", &Reply::answer)
      .field("error", &Reply::error)
      .field("svg", &Reply::svg)
      .field("film", &Reply::film);
  emscripten::function("ask", &tautline::wasm::AskFromJavaScript);
}
