// Validates GLB files with Khronos' glTF validator: node validate.mjs FILE... prints one JSON list.
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { validateBytes, version } from "gltf-validator";

const reports = [];
for (const file of process.argv.slice(2)) {
  const bytes = new Uint8Array(readFileSync(file));
  const { issues, info } = await validateBytes(bytes, { uri: basename(file), maxIssues: 100 });
  const { animationCount, hasTextures, totalTriangleCount } = info ?? {};
  reports.push({ file, version: version(), ...issues, animationCount, hasTextures, totalTriangleCount });
}
console.log(JSON.stringify(reports));
