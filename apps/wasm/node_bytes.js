// Goes into the module ahead of emscripten's own code, whose loader takes the `fetch` of newer versions of node for a
// browser's: it cannot fetch files.
if (typeof process === "object" && process.versions && process.versions.node && !Module["wasmBinary"]) {
  Module["wasmBinary"] = require("fs").readFileSync(require("path").join(__dirname, "tautline.wasm"));
}
