// Bundles the viewer: `node build.mjs FOLDER` writes app.js, app.css, index.html and page.html there.
// page.html is the frame of a self-contained page: the program puts script, style, title and data in the
// places of the marks. Its policy names the hashes of script and style, and allows no network at all.
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
mkdirSync(folder, { recursive: true });

const result = await build({
  entryPoints: { app: join(here, "source/main.ts") },
  outdir: folder,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "ascii",
  legalComments: "none",
  banner: { js: "/* geolloyd's viewer, with three.js (MIT licence, three.js authors) */" },
  write: false,
});
const script = result.outputFiles.find((file) => file.path.endsWith(".js")).text.trimEnd();
const style = readFileSync(join(here, "source/style.css"), "utf8").trimEnd();
const body = readFileSync(join(here, "source/body.html"), "utf8");

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const policy = `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; img-src data: blob:; base-uri 'none'; form-action 'none'`;
const frame = (head, tail, title) => `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
${head}
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${title}</title>
</head>
<body>
${body}${tail}</body>
</html>
`;

const write = (name, text) => writeFileSync(join(folder, name), text);
write("app.js", script);
write("app.css", style);
write("index.html", frame('<link rel="icon" href="data:,">\n<link rel="stylesheet" href="/app.css">',
  '<script src="/app.js"></script>\n', "geolloyd"));
write("page.html", frame(
  `<meta http-equiv="Content-Security-Policy" content="${policy}">\n<link rel="icon" href="data:,">\n<style>@STYLE@</style>`,
  '<script type="application/octet-stream" id="bundle">@BUNDLE@</script>\n<script>@SCRIPT@</script>\n',
  "@TITLE@"));
