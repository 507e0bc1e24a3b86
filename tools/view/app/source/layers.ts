// The controls of what is shown. They are made again when a layer comes or goes.
import { byId, button, check, choices, make, save } from "./dom";
import type { Look, Shown, Viewer } from "./viewer";

export function showLayers(viewer: Viewer): void {
  const section = byId("layers");
  const fill = () => {
    const { look } = viewer;
    const held = [...section.querySelectorAll("input, button")].indexOf(document.activeElement as Element);
    section.replaceChildren(make("h2", {}, "Layers"));
    const surfaces = (["mesh", "dual", "remesh"] as Shown[]).filter((shown) => shown === "mesh" || viewer.offers(shown));
    if (surfaces.length > 1) {
      section.append(choices("Surface", "surface", surfaces.map((shown) => [shown, shown]), look.shown, (shown) => viewer.set({ shown })));
    }
    const colourings: [Look["colouring"], string][] = [["plain", "none"]];
    if (viewer.has("own")) colourings.unshift(["own", "its own"]);
    if (viewer.offers("truth")) colourings.unshift(["truth", "ground truth"]);
    if (viewer.has("regions")) colourings.unshift(["regions", "regions"]);
    if (colourings.length > 1) {
      section.append(choices("Colours of the mesh", "colouring", colourings, look.colouring, (colouring) => viewer.set({ colouring })));
    }
    section.append(check("edges of the mesh", look.edges, (edges) => viewer.set({ edges })));
    if (viewer.has("regions")) section.append(check("seeds", look.seeds, (seeds) => viewer.set({ seeds })));
    if (viewer.offers("trees")) section.append(check("shortest-path trees", look.trees, (trees) => viewer.set({ trees })));
    if (viewer.offers("field")) section.append(check("tangent field", look.field, (field) => viewer.set({ field })));
    if (viewer.offers("truth")) section.append(check("centroids (with ground truth)", look.centroids, (centroids) => viewer.set({ centroids })));
    const buttons = make("div", { class: "row" });
    buttons.append(
      button("Show all", () => viewer.stage.showAll(), "Back to the first view"),
      button("Save picture", async () => {
        const blob = await viewer.stage.picture();
        if (blob) save(blob, "geolloyd.png");
      }),
    );
    section.append(buttons);
    section.querySelectorAll<HTMLElement>("input, button")[held]?.focus();
  };
  viewer.addEventListener("layers", fill);
  fill();
}
