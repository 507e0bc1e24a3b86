// A session in a browser, with a pointer and the program behind it: what is done there is what the command line does.
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { drag, emptyPlace, fingerprintIn, isIdle, press, seedInSight, startView, stateOf, until, whenDrawn, wordsOf } from "../../tools/view/app/drive.mjs";
import { complaintsOf, expect, geolloyd, program, report, unreachableControls, withBrowser } from "./browser.mjs";

const began = Date.now();

async function open(browser, address) {
  const context = await browser.newContext({ viewport: { width: 1000, height: 700 } });
  const page = await context.newPage();
  const complaints = complaintsOf(page);
  page.on("response", (response) => {
    if (!response.ok()) complaints.push(`${response.status()} ${response.url()}`);
  });
  await page.goto(address);
  await whenDrawn(page);
  return { page, complaints, context };
}

// What the command line prints as fingerprint.
const fingerprintOf = (line, output) => fingerprintIn(geolloyd(...wordsOf(line, output)));

async function testSeeds(page, address) {
  const { seeds } = await stateOf(address);
  const place = await emptyPlace(page);
  await page.getByRole("radio", { name: "adds a seed" }).check();
  await page.mouse.click(place.x, place.y);
  await until(address, (state) => state.seeds === seeds + 1, "the seed that a click adds");
  await page.getByRole("radio", { name: "picks" }).check();

  await page.waitForFunction((count) => window.geolloyd.viewer.seeds.count === count, seeds + 1);
  const seed = await seedInSight(page);
  const target = await emptyPlace(page);
  const before = await stateOf(address);
  await drag(page, seed, target);
  const after = await until(address, (state) => state.layers.regions > before.layers.regions, "the drag");
  expect(after.seeds === seeds + 1, "a drag adds no seed");
  await page.waitForFunction(({ region, x, y }) => {
    const place = window.geolloyd.seedAt(region);
    return Math.hypot(place.x - x, place.y - y) < 20;
  }, { region: seed.region, ...target });
}

async function testRelaxation(page, address, folder) {
  await press(page, "Greedy step");
  await until(address, (state) => state.step === 1 && isIdle(state), "a greedy step");
  await press(page, "Microstep");
  await until(address, (state) => state.phase === "precise", "a microstep");
  await press(page, "Macrostep");
  await until(address, (state) => state.step === 2 && isIdle(state), "a macrostep");
  await press(page, "Reset");
  await until(address, (state) => state.step === 0, "a reset");
  await press(page, "Run");
  await page.getByRole("button", { name: "Pause", exact: true }).click({ timeout: 1000 }).catch(() => {});  // if it still runs
  await until(address, isIdle, "a pause");
  if ((await stateOf(address)).phase !== "done") await press(page, "Run");
  await until(address, (state) => state.phase === "done" && isIdle(state), "the end");
  await page.getByRole("button", { name: "Save result", exact: true }).click();
  const done = await until(address, (state) => state.message?.kind === "done", "saved results");
  expect(done.fingerprint === fingerprintOf(done.command_line, join(folder, "again")), "the fingerprint is that of the command line");
  const saved = JSON.parse(readFileSync(join(folder, "saved/report.json"), "utf8"));
  expect(saved.fingerprint === done.fingerprint, "it is that of the report");
  expect((await page.textContent("#live")).includes(done.fingerprint), "it is shown");
}

async function testOptions(page, address) {
  for (const graph of ["triangle", "vertex"]) {
    await page.selectOption("select[name=graph]", graph);
    const state = await until(address, (s) => s.options.graph === graph && isIdle(s), graph);
    expect(state.step === 0 && state.message === null, `${graph}: begins anew`);
    await page.waitForFunction((count) => window.geolloyd.viewer.seeds.count === count, state.seeds);
  }
}

async function testRemesh(page, address, folder) {
  await page.getByLabel("Vertices of a remesh").fill("150");
  await press(page, "Remesh");
  const { remesh } = await until(address, (state) => state.remesh?.fingerprint && isIdle(state), "a remesh");
  expect(remesh.fingerprint === fingerprintOf(remesh.command_line, join(folder, "remesh.ply")), "the remesh is that of the command line");
}

// Two windows show the same, a window that is loaded again too, and a browser that is gone leaves all as it is.
async function testWindows(browser, page, address) {
  const other = await open(browser, address);
  await press(page, "Reset");
  await until(address, (state) => state.step === 0 && isIdle(state), "a reset");
  await press(other.page, "Macrostep");
  await until(address, (state) => state.step === 1 && isIdle(state), "a step of the other window");
  const stepsShown = (p) => p.waitForFunction(() => [...document.querySelectorAll("#facts dt")]
    .some((dt) => dt.textContent === "steps" && dt.nextElementSibling.textContent === "1"));
  await stepsShown(page);
  await stepsShown(other.page);
  const before = await stateOf(address);
  await page.reload();
  await whenDrawn(page);
  await stepsShown(page);
  await other.context.close();
  const after = await stateOf(address);
  expect(after.fingerprint === before.fingerprint && after.seeds === before.seeds, "nothing is lost");
}

// A page of somebody else, in the same browser, who even knows the port.
async function testOtherPage(browser, address) {
  const origin = address.split("/#")[0];
  const evil = createServer((request, response) => response.setHeader("Content-Type", "text/html").end("<body></body>"));
  await new Promise((done) => evil.listen(0, "127.0.0.1", done));
  const page = await (await browser.newContext()).newPage();
  await page.goto(`http://localhost:${evil.address().port}/`);
  const before = await stateOf(address);
  const got = await page.evaluate(async (target) => {
    const tried = {};
    const attempt = async (name, work) => (tried[name] = await work().catch(() => "refused"));
    await attempt("read", async () => (await fetch(`${target}/api/state`)).text());
    await attempt("opaque", async () => (await (await fetch(`${target}/app.js`, { mode: "no-cors" })).text()).length || "refused");
    await attempt("post", async () => (await fetch(`${target}/api/command`, { method: "POST", body: "{\"do\":\"run\"}", mode: "no-cors" })).text() || "refused");
    await attempt("script", () => new Promise((done, fail) => document.body.append(Object.assign(document.createElement("script"), { src: `${target}/app.js`, onload: () => done("loaded"), onerror: fail }))));
    const form = Object.assign(document.createElement("form"), { action: `${target}/api/command`, method: "post", enctype: "text/plain", target: "frame" });
    const frame = Object.assign(document.createElement("iframe"), { name: "frame" });
    document.body.append(form, frame);
    form.submit();
    await new Promise((done) => (frame.onload = done));
    return tried;
  }, origin);
  expect(Object.values(got).every((result) => result === "refused"), `another page gets nothing: ${JSON.stringify(got)}`);
  const after = await stateOf(address);
  expect(after.revision === before.revision, "another page changes nothing");
  evil.close();
}

await withBrowser(async (browser, folder) => {
  const mesh = join(folder, "mesh.ply");
  geolloyd("generate", "creature", "--triangles", "20000", "--output", mesh);
  const { child, ended, address } = await startView(program, mesh, "--seeds", "40", "--init", "random", "--output", join(folder, "saved"));
  const { page, complaints } = await open(browser, address);
  const unreachable = await unreachableControls(page);
  expect(unreachable.length === 0, `the keyboard reaches ${unreachable}`);
  await testOptions(page, address);
  await testSeeds(page, address);
  await testRelaxation(page, address, folder);
  await testRemesh(page, address, folder);
  await testWindows(browser, page, address);
  await testOtherPage(browser, address);
  expect(complaints.length === 0, `no complaint of the browser: ${complaints}`);
  await browser.close();
  expect((await stateOf(address)).step === 1, "without a browser all is there");
  expect(existsSync(join(folder, "saved/first-seeds.csv")), "edited seeds are saved");
  child.kill("SIGINT");
  expect((await ended) === 130, "an interrupt ends it");
});
report("session", began);
