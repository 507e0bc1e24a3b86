// Measurements of a small mesh have a time in each row.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, geolloyd, program, report } from "./browser.mjs";

const began = Date.now();
const folder = mkdtempSync(join(tmpdir(), "geolloyd-measured-"));
try {
  const mesh = join(folder, "mesh.ply");
  geolloyd("generate", "creature", "--triangles", "2000", "--output", mesh);
  const script = fileURLToPath(new URL("../../tools/view/app/measure.mjs", import.meta.url));
  const [head, ...rows] = execFileSync("node", [script, program, mesh, "12", "1"], { encoding: "utf8" }).trim().split("\n\n")
    .flatMap((part, i) => (i === 0 ? [] : part.split("\n")));
  expect(head.includes("drawn"), head);
  expect(rows.length === 12, `${rows.length} rows`);
  for (const row of rows) {
    const [drawn, processor] = row.trim().split(/ {2,}/).slice(-2).map(Number);
    expect(drawn > 0 && drawn < 60_000 && processor >= 0, row);
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
report("measurements", began);
