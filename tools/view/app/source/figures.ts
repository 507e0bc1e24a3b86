// The figures of one region, chosen by a click on it or by its number, and the facts of the whole.
import { button, byId, countText, definitions, labelled, make, numberInput, numberText, say } from "./dom";
import { none } from "./bundle";
import type { Viewer } from "./viewer";

export function regionRows(viewer: Viewer, region: number): [string, string][] {
  const rows: [string, string][] = [["region", String(region)]];
  const seed = viewer.figure("seed_id", region);
  if (seed !== undefined && seed !== none) rows.push(["seed", String(seed)]);
  const nodes = viewer.figure("region_nodes", region);
  if (nodes !== undefined) rows.push(["nodes", countText(nodes)]);
  const area = viewer.figure("region_area", region);
  if (area !== undefined) rows.push(["area", numberText(area)]);
  const energy = viewer.figure("region_energy", region);
  if (energy !== undefined) rows.push(["energy", numberText(energy)]);
  return rows;
}

export function showFigures(viewer: Viewer): void {
  const section = byId("figures");
  const input = numberInput(0);
  input.addEventListener("change", () => {
    const region = input.valueAsNumber;
    viewer.pick(Number.isInteger(region) && region >= 0 && region < viewer.seeds.count ? region : null);
  });
  const list = make("div");
  const row = make("div", { class: "row" });
  row.append(labelled("Number", input), button("None", () => viewer.pick(null)));
  section.append(make("h2", {}, "Region"), row, list);
  const fill = () => {
    section.hidden = !viewer.has("regions");
    const { picked } = viewer.look;
    input.max = String(viewer.seeds.count - 1);
    input.value = picked === null ? "" : String(picked);
    if (picked === null) {
      list.replaceChildren(make("p", { class: "note" }, "Click on a region, or give its number."));
      return;
    }
    const rows = regionRows(viewer, picked);
    list.replaceChildren(definitions(rows));
    say(rows.map(([name, text]) => `${name} ${text}`).join(", "));
  };
  viewer.addEventListener("picked", fill);
  viewer.addEventListener("layers", fill);
  fill();
}

export function showFacts(facts: [string, string][], notes: string[]): void {
  const section = byId("facts");
  section.replaceChildren(make("h2", {}, "Facts"), definitions(facts));
  for (const note of notes) section.append(make("p", { class: "note" }, note));
  section.hidden = facts.length === 0 && notes.length === 0;
}
