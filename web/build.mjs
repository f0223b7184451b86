// Builds esg/report/static from web/src: `npm ci --ignore-scripts && npm run build`.
import { createHash } from "node:crypto";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const target = join(here, "..", "esg", "report", "static");
mkdirSync(target, { recursive: true });

const result = await build({
  absWorkingDir: here,
  entryPoints: { report: "src/main.js" },
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome100", "firefox115", "safari16.4"],
  charset: "ascii",
  legalComments: "none",
  metafile: true,
  outdir: target,
  write: false,
});
// `</script` inside the bundle would end the element that carries it.
for (const file of result.outputFiles) {
  const text = file.text.replaceAll("</script", "<\\/script");
  writeFileSync(file.path, text);
}
await build({
  absWorkingDir: here,
  entryPoints: { report: "src/report.css" },
  bundle: true,
  minify: true,
  outdir: target,
});

const packages = new Set();
for (const input of Object.keys(result.metafile.inputs)) {
  const match = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
  if (match) packages.add(match[1]);
}
const notices = ["Libraries inside report.js and their licenses.\n"];
for (const name of [...packages].sort()) {
  const folder = join(here, "node_modules", name);
  const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = readdirSync(folder).find((f) => /^licen[sc]e/i.test(f));
  if (!file) throw new Error(`${name} ships no license text`);
  notices.push(`${name} ${version} (${license})\n\n${readFileSync(join(folder, file), "utf8").trim()}\n`);
}
writeFileSync(join(target, "LICENSES.txt"), notices.join("\n----------------------------------------\n\n"));

// What the bundle was made from, so that a test can tell a stale one without building.
const hash = createHash("sha256");
const sources = ["build.mjs", "package-lock.json", "package.json"];
for (const name of readdirSync(join(here, "src")).sort()) sources.push(`src/${name}`);
for (const name of sources) hash.update(name + "\0").update(readFileSync(join(here, name)));
writeFileSync(join(target, "SOURCES.sha256.txt"), hash.digest("hex") + "\n");
