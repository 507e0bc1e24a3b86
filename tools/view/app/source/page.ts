// A page without a server: what its bundle has, and no more.
import type { Bundle } from "./bundle";
import { byId, say } from "./dom";
import { showFacts, showFigures } from "./figures";
import { showLayers } from "./layers";
import { followPointer } from "./pointer";
import { showTimeline } from "./timeline";
import { Viewer } from "./viewer";

export function showPage(bundle: Bundle): void {
  const { title, info } = bundle.header;
  byId("title").textContent = title;
  document.title = `${title} - geolloyd`;
  const viewer = new Viewer(byId<HTMLCanvasElement>("canvas"), bundle);
  showTimeline(viewer, bundle);
  showLayers(viewer);
  showFigures(viewer);
  showFacts(info.facts ?? [], info.notes ?? []);
  if (info.surface === "remesh") viewer.set({ shown: "remesh" });
  if (info.colouring === "own" || info.colouring === "truth") viewer.set({ colouring: info.colouring });
  viewer.dispatchEvent(new Event("layers"));
  followPointer(viewer, { click: (hit) => viewer.pick(hit?.region ?? null) });
  say("");
  expose(viewer);
}

// For tests and for the console of a browser.
export function expose(viewer: Viewer): void {
  Object.assign(window, {
    geolloyd: {
      viewer,
      seedAt: (region: number) => viewer.stage.project(viewer.seeds.place(region)),
    },
  });
}
