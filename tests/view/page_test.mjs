// A page in a browser without network: what it shows, against the files that the program wrote beside it.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { drag, framesDrawn, seedInSight, settle, whenDrawn } from "../../tools/view/app/drive.mjs";
import { coloursShown, complaintsOf, expect, geolloyd, report, unreachableControls, withBrowser } from "./browser.mjs";

const began = Date.now();

function rowsOf(csv) {
  const [head, ...lines] = readFileSync(csv, "utf8").trim().split("\n").map((line) => line.split(","));
  return lines.map((line) => Object.fromEntries(head.map((name, i) => [name, line[i]])));
}

async function openPage(browser, file, options = {}) {
  const context = await browser.newContext({ viewport: { width: 900, height: 600 }, offline: true, ...options });
  const page = await context.newPage();
  const complaints = complaintsOf(page);
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(pathToFileURL(file).href);
  await whenDrawn(page);
  return { page, complaints, asked, context };
}

function close(shares, others, by, what) {
  for (const name of Object.keys(shares)) {
    expect(Math.abs(shares[name] - others[name]) < by, `${what}: ${name} ${shares[name].toFixed(3)} is about ${others[name].toFixed(3)}`);
  }
}

const figures = (page) => page.evaluate(() => Object.fromEntries([...document.querySelectorAll("#figures dt")]
  .map((dt) => [dt.textContent, dt.nextElementSibling.textContent])));

// Of triangles in sight of two regions, those near whose odd corner, but past the middle, the other region is not shown.
const crookedBorders = (page) => page.evaluate(() => {
  const { viewer } = window.geolloyd;
  const { triangles } = viewer.mesh;
  const found = { tried: 0, crooked: [] };
  for (let t = 0; t < triangles.length && found.tried < 20; t += 3) {
    for (let turn = 0; turn < 3; ++turn) {
      const [odd, a, b] = [0, 1, 2].map((i) => triangles[t + ((i + turn) % 3)]);
      const wanted = viewer.region[a];
      if (wanted !== viewer.region[b] || wanted === viewer.region[odd]) continue;
      const place = viewer.placeOfNode(odd).multiplyScalar(0.44);
      for (const node of [a, b]) place.addScaledVector(viewer.placeOfNode(node), 0.28);
      const { x, y } = viewer.stage.project(place);
      const hit = viewer.at(x - 0.5, y - 0.5);  // the middle of a pixel
      if (!hit || ![odd, a, b].includes(hit.node)) continue;  // hidden
      ++found.tried;
      if (hit.region !== wanted) found.crooked.push(t / 3);
    }
  }
  return found;
});

// Red, green and blue of what the canvas shows there.
const pixelAt = (page, x, y) => page.evaluate(async (place) => {
  const image = await createImageBitmap(await window.geolloyd.viewer.stage.picture());
  const { left, top, width } = document.querySelector("canvas").getBoundingClientRect();
  const context = new OffscreenCanvas(1, 1).getContext("2d");
  const scale = image.width / width;
  context.drawImage(image, -Math.floor((place.x - left) * scale), -Math.floor((place.y - top) * scale));
  return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3);
}, { x, y });

async function testRegions(browser, folder) {
  const mesh = join(folder, "a.ply");
  geolloyd("generate", "creature", "--triangles", "20000", "--output", mesh);
  const file = join(folder, "page.html");
  geolloyd("relax", mesh, "--seeds", "60", "--init", "random", "--ground-truth", "--output", join(folder, "result"), "--page", file);
  const { page, complaints, asked } = await openPage(browser, file);
  expect(asked.length === 1, `the page asks for itself alone, not ${asked.slice(1)}`);

  // Of a view from afar, the colours of the program's own picture.
  const picture = join(folder, "picture.png");
  const seeds = rowsOf(join(folder, "result/seeds.csv"));
  geolloyd("relax", mesh, "--seeds", "60", "--init", "random", "--output", join(folder, "again"), "--picture", picture, "--size", "500x500");
  const shown = await coloursShown(page);
  const drawn = await coloursShown(page, `data:image/png;base64,${readFileSync(picture).toString("base64")}`);
  close(shown, drawn, 0.06, "region colours");
  expect(shown.grey < 0.03, "regions cover the mesh");

  const seed = await seedInSight(page);
  expect(Math.max(...await pixelAt(page, seed.x, seed.y)) < 50, "a dark ball where the seed is");
  await page.getByLabel("seeds", { exact: true }).click();
  expect(Math.max(...await pixelAt(page, seed.x, seed.y)) >= 50, "none without the layer");
  await page.getByLabel("seeds", { exact: true }).click();
  await page.mouse.click(seed.x, seed.y);
  const wanted = seeds[seed.region];
  const read = await figures(page);
  expect(read.region === String(seed.region) && read.seed === wanted.input_id, `seed ${read.seed} is ${wanted.input_id}`);
  expect(read.nodes === Number(wanted.nodes).toLocaleString("en-US"), "nodes");
  for (const key of ["area", "energy"]) {
    expect(Math.abs(Number(read[key]) / Number(wanted[key]) - 1) < 1e-4, `${key} ${read[key]} is ${wanted[key]}`);
  }
  expect((await page.textContent("#status")).includes(`region ${seed.region}`), "the region is said aloud");
  const ground = await page.evaluate(() => getComputedStyle(document.getElementById("status")).backgroundColor);
  expect(/^rgb\(/.test(ground), `it is legible before the mesh, on ${ground}`);

  // A drag turns the mesh, and picks nothing.
  await drag(page, { x: 300, y: 300 }, { x: 380, y: 310 });
  expect((await figures(page)).region === String(seed.region), "a drag is no click");
  const moved = await page.evaluate((region) => window.geolloyd.seedAt(region), seed.region);
  expect(Math.hypot(moved.x - seed.x, moved.y - seed.y) > 5, "the mesh has turned");

  // Nothing is drawn while nothing changes.
  await settle(page);
  const before = await framesDrawn(page);
  await page.waitForTimeout(400);
  expect(await framesDrawn(page) === before, "no frame without a change");
  const canvas = page.locator("canvas");
  const kept = await canvas.screenshot();
  await page.evaluate(() => window.geolloyd.viewer.stage.draw(true));
  await settle(page);
  expect(kept.equals(await canvas.screenshot()), "edges are smooth in what stays");

  for (const label of ["seeds", "edges of the mesh", "shortest-path trees"]) {
    for (let turn = 0; turn < 2; ++turn) {  // on and off
      const count = await framesDrawn(page);
      await page.getByLabel(label, { exact: true }).click();
      await page.waitForFunction((n) => Number(document.querySelector("canvas").dataset.drawn) > n, count);
    }
  }
  await page.getByLabel("ground truth", { exact: true }).click();
  close(await coloursShown(page), shown, 0.2, "ground truth");
  await page.getByLabel("remesh", { exact: true }).click();
  expect((await coloursShown(page)).grey > 0.9, "a remesh has no colours");
  await page.getByLabel("mesh", { exact: true }).click();
  await page.getByLabel("none", { exact: true }).click();
  expect((await coloursShown(page)).grey > 0.9, "a mesh without colours");
  await page.getByLabel("regions", { exact: true }).click();

  // The timeline begins with the first seeds.
  const { energy_initial: initial } = JSON.parse(readFileSync(join(folder, "result/report.json"), "utf8"));
  await page.getByRole("slider", { name: "Step" }).focus();
  await page.keyboard.press("Home");
  const first = await page.textContent("#frame");
  expect(first.startsWith("greedy step 1, energy "), first);
  expect(Math.abs(Number(first.split("energy ")[1]) / initial - 1) < 1e-3, `${first} is ${initial}`);
  await page.keyboard.press("End");
  expect((await page.textContent("#frame")).startsWith("result"), "the last frame is the result");

  await page.focus("canvas");
  const still = await page.evaluate((region) => window.geolloyd.seedAt(region), seed.region);
  await page.keyboard.press("ArrowRight");
  const turned = await page.evaluate((region) => window.geolloyd.seedAt(region), seed.region);
  expect(Math.hypot(still.x - turned.x, still.y - turned.y) > 5, "arrow keys turn the mesh");

  const unreachable = await unreachableControls(page);
  expect(unreachable.length === 0, `the keyboard reaches ${unreachable}`);
  expect(complaints.length === 0, `no complaint: ${complaints}`);
}

async function testOddNames(browser, folder) {
  const name = "a <b>&\"'@BUNDLE@.ply";
  const mesh = join(folder, name);
  geolloyd("generate", "torus", "--triangles", "800", "--output", mesh);
  const file = join(folder, "odd.html");
  geolloyd("render", mesh, "--seeds", "9", "--vfield", "curvature", "--panel", "regions", "--panel", "field", "--output", file);
  const { page, complaints } = await openPage(browser, file, { colorScheme: "dark", viewport: { width: 360, height: 640 } });
  expect(await page.textContent("#title") === name, "the name is shown as it is");
  expect(await page.locator("b").count() === 0, "and is no element");
  expect(await page.getByLabel("tangent field").count() === 1, "there is a field");
  const { tried, crooked } = await crookedBorders(page);
  expect(tried === 20 && crooked.length === 0, `of ${tried} triangles ${crooked} have crooked borders`);
  const look = await page.evaluate(() => ({ wide: document.documentElement.scrollWidth, ground: getComputedStyle(document.body).backgroundColor, canvas: document.querySelector("canvas").clientWidth }));
  expect(look.wide <= 360 && look.canvas === 360, "a narrow window is enough");
  expect(look.ground.match(/\d+/g).every((part) => Number(part) < 60), `dark ground, not ${look.ground}`);
  expect(complaints.length === 0, `no complaint: ${complaints}`);
}

async function testRemesh(browser, folder) {
  const mesh = join(folder, "cube.ply");
  geolloyd("generate", "cube", "--triangles", "3000", "--output", mesh);
  const file = join(folder, "remesh.html");
  geolloyd("remesh", mesh, "--vertices", "200", "--output", join(folder, "remesh.ply"), "--page", file);
  const { page, complaints } = await openPage(browser, file);
  expect(await page.getByLabel("remesh", { exact: true }).isChecked(), "the remesh is shown first");
  await page.getByLabel("mesh", { exact: true }).check();
  expect((await coloursShown(page)).grey > 0.9, "then the mesh");
  expect(complaints.length === 0, `no complaint: ${complaints}`);
}

await withBrowser(async (browser, folder) => {
  await testRegions(browser, folder);
  await testOddNames(browser, folder);
  await testRemesh(browser, folder);
});
report("page", began);
