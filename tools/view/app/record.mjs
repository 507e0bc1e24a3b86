// `node record.mjs PAGE FOLDER`: pictures of a page of `relax`, as the documentation has them. viewer.png and
// viewer-dark.png show trees and a picked region, 000.png, 001.png ... the timeline.
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { launchBrowser, settle, whenDrawn } from "./drive.mjs";

const [page, folder] = process.argv.slice(2);
const browser = await launchBrowser();

async function open(width, height, colorScheme) {
  const tab = await browser.newPage({ viewport: { width, height }, colorScheme });
  await tab.goto(pathToFileURL(page).href);
  await whenDrawn(tab);
  return tab;
}

for (const [scheme, name] of [["light", "viewer.png"], ["dark", "viewer-dark.png"]]) {
  const tab = await open(1000, 640, scheme);
  await tab.getByLabel("shortest-path trees").check();
  await tab.getByLabel("Number").fill("40");
  await tab.keyboard.press("Tab");
  await tab.evaluate(() => document.getElementById("panel").scrollTo(0, 150));
  await settle(tab);
  await tab.screenshot({ path: join(folder, name) });
}

const tab = await open(760, 470, "light");
await tab.evaluate(() => document.getElementById("timeline").after(document.getElementById("layers")));
const slider = tab.getByRole("slider");
const last = Number(await slider.getAttribute("max"));
await slider.press("Home");
for (let frame = 0; frame <= last; ++frame) {
  await settle(tab);
  await tab.screenshot({ path: join(folder, `${String(frame).padStart(3, "0")}.png`) });
  await slider.press("ArrowRight");
}
await browser.close();
