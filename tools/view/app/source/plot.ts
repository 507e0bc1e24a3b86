// Energy over steps.
import { byId, make, numberText } from "./dom";

const svg = "http://www.w3.org/2000/svg";

function element(name: string, attributes: Record<string, string>): SVGElement {
  const made = document.createElementNS(svg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

// `now`: the step that is shown, or null.
export function plotEnergy(energies: number[], now: number | null = null): void {
  const section = byId("energy");
  section.hidden = energies.length < 2;
  if (section.hidden) return;
  const low = Math.min(...energies), high = Math.max(...energies);
  const x = (i: number) => (100 * i) / (energies.length - 1);
  const y = (energy: number) => 29 - (28 * (energy - low)) / (high - low || 1);
  const words = `Energy from ${numberText(energies[0])} to ${numberText(energies[energies.length - 1])} over ${energies.length - 1} steps`;
  const plot = element("svg", { class: "plot", viewBox: "0 0 100 30", preserveAspectRatio: "none", role: "img", "aria-label": words });
  if (now !== null) plot.append(element("line", { class: "now", x1: String(x(now)), x2: String(x(now)), y1: "0", y2: "30" }));
  plot.append(element("polyline", { class: "line", points: energies.map((energy, i) => `${x(i)},${y(energy)}`).join(" ") }));
  const ends = make("div", { class: "range" }, make("span", {}, numberText(energies[0])), make("span", {}, numberText(energies[energies.length - 1])));
  section.replaceChildren(make("h2", {}, "Energy"), plot, ends);
}
