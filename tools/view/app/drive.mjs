// The viewer in a browser without a screen, as tests, measurements and pictures drive it.
import { spawn } from "node:child_process";
import { chromium } from "playwright-core";

export function launchBrowser() {
  return chromium.launch({
    executablePath: process.env.GEOLLOYD_BROWSER ?? "/usr/bin/chromium",
    args: ["--headless", "--no-sandbox", "--disable-dev-shm-usage", "--enable-unsafe-swiftshader"],
  });
}

export function whenDrawn(page) {
  return page.waitForFunction(() => Number(document.querySelector("canvas").dataset.drawn ?? 0) > 0, null, { timeout: 60_000 });
}

export function framesDrawn(page) {
  return page.evaluate(() => Number(document.querySelector("canvas").dataset.drawn));
}

// Once no frame has come for a second: the last one is drawn with smooth edges.
export async function settle(page) {
  for (let before = -1, now = await framesDrawn(page); before !== now; now = await framesDrawn(page)) {
    before = now;
    await page.waitForTimeout(1000);
  }
}

// Resolves once the session's address is there.
export function startView(program, ...words) {
  const child = spawn(program, ["view", "--no-open", ...words]);
  const ended = new Promise((done) => child.on("exit", (status) => done(status)));
  let text = "";
  return new Promise((done, fail) => {
    child.stderr.on("data", (data) => fail(new Error(String(data))));
    child.stdout.on("data", (data) => {
      text += data;
      const address = text.match(/http:\/\/127\.0\.0\.1:\d+\/#[0-9a-f]{32}/);
      if (address && text.includes("Ctrl-C")) done({ child, ended, address: address[0] });
    });
  });
}

// What a session says of itself.
export function stateOf(address) {
  const [origin, token] = address.split("/#");
  return fetch(`${origin}/api/state`, { headers: { "X-Geolloyd-Token": token } }).then((response) => response.json());
}

export async function until(address, holds, what) {
  for (const end = Date.now() + 120_000; Date.now() < end;) {
    const state = await stateOf(address);
    if (holds(state)) return state;
    await new Promise((done) => setTimeout(done, 20));
  }
  throw new Error(`never came: ${what}`);
}

export const isIdle = (state) => !state.running && state.task === null;

// The words after the program's name that give the same as the session, into `output`.
export function wordsOf(line, output) {
  const words = line.split(" ").slice(1);
  words[words.indexOf("--output") + 1] = output;
  return words;
}

export const fingerprintIn = (text) => text.match(/fingerprint +([0-9a-f]{16})/)[1];

export const press = (page, name) => page.getByRole("button", { name, exact: true }).click();

export async function drag(page, from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 3 });
  await page.mouse.move(to.x, to.y, { steps: 3 });
  await page.mouse.up();
}

// A region whose seed is in sight, and where; null: there is none.
export const seedInSight = (page) => page.evaluate(() => {
  const { viewer, seedAt } = window.geolloyd;
  for (let region = 0; region < viewer.seeds.count; ++region) {
    const place = seedAt(region);
    if (viewer.at(place.x, place.y)?.region === region) return { region, ...place };
  }
  return null;
});

// A place of the canvas at which the mesh is, and no seed within `reach` pixels.
export const emptyPlace = (page, reach = 30) => page.evaluate((least) => {
  const { viewer, seedAt } = window.geolloyd;
  const { width, height } = viewer.stage.canvas.getBoundingClientRect();
  const seeds = Array.from({ length: viewer.seeds.count }, (_, region) => seedAt(region));
  for (let y = height / 4; y < height; y += 7) {
    for (let x = width / 4; x < width; x += 7) {
      if (seeds.some((seed) => Math.hypot(seed.x - x, seed.y - y) <= least)) continue;
      const hit = viewer.at(x, y);
      if (hit && hit.region !== null) return { x, y };
    }
  }
  return null;
}, reach);
