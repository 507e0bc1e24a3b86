// Clicks on the mesh, and drags of seeds. A drag is no click: a pointer that has moved turns the view, or a seed.
import type { Viewer } from "./viewer";

const clickReach = 4;   // pixels
const seedReach = 14;

export interface PointerActions {
  click(hit: { node: number; region: number | null } | null): void;
  drop?(region: number, node: number): void;  // a seed was dragged to a node; without it seeds stay where they are
}

export function followPointer(viewer: Viewer, actions: PointerActions): void {
  const { canvas, controls } = viewer.stage;
  let start: { x: number; y: number; id: number } | null = null;
  let hasMoved = false;
  let seed: number | null = null;
  let node: number | null = null;

  canvas.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary || event.button !== 0) return;
    start = { x: event.clientX, y: event.clientY, id: event.pointerId };
    hasMoved = false;
    seed = actions.drop ? seedAt(viewer, event.clientX, event.clientY) : null;
    controls.enabled = seed === null;
  }, { capture: true });

  canvas.addEventListener("pointermove", (event) => {
    if (!start || event.pointerId !== start.id) return;
    hasMoved ||= Math.hypot(event.clientX - start.x, event.clientY - start.y) > clickReach;
    if (!hasMoved || seed === null) return;
    const hit = viewer.at(event.clientX, event.clientY);
    if (!hit) return;
    node = hit.node;
    viewer.seeds.move(seed, viewer.placeOfNode(hit.node));
    viewer.stage.request();
  });

  const end = (event: PointerEvent, isCancelled: boolean) => {
    if (!start || event.pointerId !== start.id) return;
    start = null;
    controls.enabled = true;
    if (!isCancelled && !hasMoved) actions.click(viewer.at(event.clientX, event.clientY));
    if (!isCancelled && hasMoved && seed !== null && node !== null) actions.drop?.(seed, node);
    seed = node = null;
  };
  canvas.addEventListener("pointerup", (event) => end(event, false));
  canvas.addEventListener("pointercancel", (event) => end(event, true));
}

// The seed of the region under the pointer, if that is near enough: those behind the mesh are out of reach.
function seedAt(viewer: Viewer, x: number, y: number): number | null {
  const region = viewer.at(x, y)?.region ?? null;
  if (region === null || !viewer.look.seeds) return null;
  const place = viewer.stage.project(viewer.seeds.place(region));
  return Math.hypot(place.x - x, place.y - y) <= seedReach ? region : null;
}
