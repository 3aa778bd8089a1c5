// Answers questions through the browser's module: ask_wasm.js MODULE
//
// Reads one question a line, {command, scene, options, files: {name: base64}}, and writes one reply a line.
"use strict";
const readline = require("readline");

async function main() {
  const tautline = await require(require("path").resolve(process.argv[2]))();
  for await (const line of readline.createInterface({input: process.stdin})) {
    const {command, scene, options, files} = JSON.parse(line);
    const bytes = {};
    for (const name of Object.keys(files)) bytes[name] = new Uint8Array(Buffer.from(files[name], "base64"));
    process.stdout.write(JSON.stringify(tautline.ask(command, scene, options, bytes)) + "\n");
  }
}

main().catch((error) => {
  process.stderr.write(String(error).slice(0, 1000) + "\n");
  process.exit(1);
});
