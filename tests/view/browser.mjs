// What tests in a browser share.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launchBrowser } from "../../tools/view/app/drive.mjs";

export const program = process.argv[2];

export function geolloyd(...words) {
  return execFileSync(program, words, { encoding: "utf8" });
}

export async function withBrowser(test) {
  const folder = mkdtempSync(join(tmpdir(), "geolloyd-browser-"));
  const browser = await launchBrowser();
  try {
    await test(browser, folder);
  } finally {
    await browser.close();
    rmSync(folder, { recursive: true, force: true });
  }
}

let checks = 0;

export function expect(isTrue, message) {
  ++checks;
  if (!isTrue) throw new Error(`not so: ${message}`);
}

export function report(name, began) {
  console.log(`${name}: ${checks} checks in ${((Date.now() - began) / 1000).toFixed(1)} s`);
}

// Collects what a page complains of.
export function complaintsOf(page) {
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  return complaints;
}

// Of pixels that show something, the share of each colour of the palette, whatever the light; "grey" is one of them.
// `png`: a picture as a data URL; without it, what the canvas shows.
export function coloursShown(page, png) {
  return page.evaluate(async (address) => {
    let image;
    if (address) {
      image = new Image();
      image.src = address;
      await image.decode();
    } else {
      image = await createImageBitmap(await window.geolloyd.viewer.stage.picture());
    }
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const palette = { blue: [78, 121, 167], orange: [242, 142, 43], green: [89, 161, 79], red: [225, 87, 89], violet: [176, 122, 161], yellow: [237, 201, 72], teal: [118, 183, 178], brown: [156, 117, 95], grey: [214, 210, 202] };
    const unit = (c) => c.map((x) => x / Math.hypot(...c));
    const names = Object.keys(palette), units = names.map((name) => unit(palette[name]));
    const count = Object.fromEntries(names.map((name) => [name, 0]));
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      const colour = [data[i], data[i + 1], data[i + 2]];
      if (data[i + 3] < 255 || Math.max(...colour) < 50) continue;
      const direction = unit(colour);
      const likeness = units.map((u) => u[0] * direction[0] + u[1] * direction[1] + u[2] * direction[2]);
      ++count[names[likeness.indexOf(Math.max(...likeness))]];
      ++sum;
    }
    return Object.fromEntries(names.map((name) => [name, count[name] / Math.max(sum, 1)]));
  }, png);
}

// Controls without a name that a screen reader could say, and those that the Tab key does not reach.
export async function unreachableControls(page) {
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas")]
    .filter((e) => !(e.getAttribute("aria-label") || e.labels?.[0]?.textContent.trim() || (e.tagName === "BUTTON" && e.textContent.trim())))
    .map((e) => e.outerHTML));
  await page.evaluate(() => document.activeElement?.blur());
  const reached = new Set();
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => {
      const e = document.activeElement;
      return e.type === "radio" ? `radio ${e.name}` : [...document.querySelectorAll("button, input, select, canvas")].indexOf(e);
    }));
  }
  const wanted = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas")]
    .map((e, i) => [e, i]).filter(([e]) => !e.disabled && e.checkVisibility())
    .map(([e, i]) => (e.type === "radio" ? `radio ${e.name}` : i)));
  return [...nameless, ...new Set(wanted.filter((control) => !reached.has(control)))];
}
