// `node measure.mjs PROGRAM MESH [SEEDS [RUNS]]`: what a user waits for, with a page and with a session. Each row is the
// median of RUNS (5): until the layer was there, until its frame was drawn to the last pixel, and the processor time
// that the browser took. First it sees that session and command line agree; without that nothing is printed.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, statSync } from "node:fs";
import { availableParallelism, cpus, tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { drag, emptyPlace, fingerprintIn, isIdle, launchBrowser, press, seedInSight, settle, startView, stateOf, until, whenDrawn, wordsOf } from "./drive.mjs";

const [program, mesh, seeds = "256", runs = "5"] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "geolloyd-measure-"));
const browser = await launchBrowser();
const devtools = await browser.newBrowserCDPSession();
const rows = [];

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
const geolloyd = (...words) => execFileSync(program, words, { encoding: "utf8" });

async function browserSeconds() {
  const { processInfo } = await devtools.send("SystemInfo.getProcessInfo");
  return processInfo.reduce((sum, { cpuTime }) => sum + cpuTime, 0);
}

// In the page: when the user last did something, when layers came, and from when to when frames were drawn. A pixel is read
// after each, for a browser goes on before its pixels are there.
function watch() {
  window.clock = { began: 0, came: [], frames: [] };
  for (const name of ["click", "change", "pointerup"]) window.addEventListener(name, (event) => (window.clock.began = event.timeStamp), true);
  window.clock.finish = () => {
    const gl = document.querySelector("canvas").getContext("webgl2");
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  };
  new MutationObserver(() => {
    const began = performance.now();
    window.clock.finish();
    window.clock.frames.push([began, performance.now()]);
  }).observe(document, { subtree: true, attributes: true, attributeFilter: ["data-drawn"] });
}

async function openTab(address) {
  const page = await browser.newPage({ viewport: { width: 1000, height: 700 } });
  await page.addInitScript(watch);
  await page.goto(address);
  await whenDrawn(page);
  await page.waitForFunction(() => window.geolloyd);
  await page.evaluate(() => window.geolloyd.viewer.addEventListener("layers", () => window.clock.came.push(performance.now())));
  return page;
}

// Milliseconds from the user's act: until the layer came, and until a frame with it was there.
async function timesOf(page, layer) {
  const handle = await page.waitForFunction((name) => {
    const { began, came, frames } = window.clock;
    const asked = performance.getEntriesByType("resource").findLast((entry) => entry.name.endsWith(`/layer/${name}`));
    if (!asked || asked.startTime < began) return null;
    const taken = came.find((time) => time >= asked.responseEnd);
    const frame = taken && frames.find(([begin]) => begin >= taken);
    return frame ? [asked.responseEnd - began, frame[1] - began] : null;
  }, layer, { timeout: 120_000 });
  return handle.jsonValue();
}

// `prepare` finds what `work` needs, and is not measured.
async function measure(name, count, work, prepare = (i) => i) {
  const found = [];
  for (let i = 0; i < count; ++i) {
    const prepared = await prepare(i);
    const before = await browserSeconds();
    const [came, drawn] = await work(prepared);
    found.push([came, drawn, 1000 * (await browserSeconds() - before)]);
  }
  rows.push([name, ...[0, 1, 2].map((i) => (found[0][i] === null ? "" : median(found.map((times) => times[i])).toFixed(0)))]);
}

// From the opening of an address to the first frame with regions, which a session sends after the mesh.
async function opened(address) {
  const page = await openTab(address);
  const handle = await page.waitForFunction(() => {
    const layer = performance.getEntriesByType("resource").find((entry) => entry.name.endsWith("/layer/regions"));
    const frame = window.clock.frames.find(([begin]) => begin >= (layer?.responseEnd ?? 0));
    return frame ? [null, frame[1]] : null;
  });
  const times = await handle.jsonValue();
  await page.close();
  return times;
}

function expectSame(mine, line, output) {
  const theirs = fingerprintIn(geolloyd(...wordsOf(line, join(folder, output))));
  if (mine !== theirs) throw new Error(`The session found ${mine}, but the command line ${theirs}: ${line}`);
}

async function measurePage() {
  const file = join(folder, "page.html");
  geolloyd("relax", mesh, "--seeds", seeds, "--page", file, "--output", join(folder, "relaxed"));
  await measure(`page of ${(statSync(file).size / 1e6).toFixed(1)} MB, opened`, Number(runs), () => opened(pathToFileURL(file).href));
}

// A seed, and a place without one, once the search for them has come to rest.
async function findPlaces(page) {
  const places = [await seedInSight(page), await emptyPlace(page, 3)];
  await settle(page);
  return places;
}

async function measureSession(address) {
  await measure("session, opened", Number(runs), () => opened(address));
  const page = await openTab(address);
  const settled = () => until(address, isIdle, "the end of a command");
  const pressed = async (button, layer) => {
    await press(page, button);
    const times = await timesOf(page, layer);
    await settled();
    return times;
  };
  const inPage = (work) => page.evaluate(work);
  await measure("a frame, nothing new", Number(runs), () => inPage(() => {
    const began = performance.now();
    window.geolloyd.viewer.stage.draw();
    window.clock.finish();
    return [null, performance.now() - began];
  }));
  await measure("what is under a pixel", Number(runs), () => inPage(() => {
    const { viewer } = window.geolloyd;
    const began = performance.now();
    viewer.at(viewer.stage.canvas.clientWidth / 2, viewer.stage.canvas.clientHeight / 2);
    return [null, performance.now() - began];
  }));
  await measure("macrostep", Number(runs), () => pressed("Macrostep", "regions"));
  const stepped = await stateOf(address);
  expectSame(stepped.fingerprint, stepped.command_line, "stepped");

  await measure("microstep", Number(runs), () => pressed("Microstep", "regions"));
  await page.getByRole("radio", { name: "adds a seed" }).check();
  await measure("add a seed", Number(runs), async (place) => {
    await page.mouse.click(place.x, place.y);
    return timesOf(page, "regions");
  }, async () => (await findPlaces(page))[1]);
  await page.getByRole("radio", { name: "picks" }).check();
  await measure("drag a seed, dropped", Number(runs), async ([seed, place]) => {
    await drag(page, seed, place);
    return timesOf(page, "regions");
  }, () => findPlaces(page));
  await measure("ground truth", 1, () => pressed("Ground truth", "truth"));
  await measure("dual", 1, () => pressed("Dual", "dual"));
  await page.getByLabel("Vertices of a remesh").fill(seeds);
  await measure("remesh", 1, () => pressed("Remesh", "remesh"));
  const { remesh } = await stateOf(address);
  expectSame(remesh.fingerprint, remesh.command_line, "remesh.ply");
  await page.getByRole("radio", { name: "mesh", exact: true }).check();
  await measure("set graph", 2, async (i) => {
    await page.selectOption("select[name=graph]", ["triangle", "vertex"][i]);
    const times = await timesOf(page, "regions");
    await settled();
    return times;
  });
  return stepped.mesh;
}

try {
  await measurePage();
  const { child, ended, address } = await startView(program, mesh, "--seeds", seeds, "--output", join(folder, "saved"));
  const { triangles } = await measureSession(address);
  child.kill("SIGINT");
  await ended;
  console.log(`${cpus()[0].model.trim()}, ${availableParallelism()} threads; browser ${browser.version()}`);
  console.log(`${mesh}: ${triangles.toLocaleString("en-US")} triangles, ${seeds} seeds; milliseconds, medians\n`);
  for (const row of [["", "layer came", "drawn", "browser's CPU"], ...rows]) {
    console.log(row[0].padEnd(28) + row.slice(1).map((text) => text.padStart(14)).join(""));
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
