// All that is shown of a mesh, and what of it is to be seen. Bundles bring layers; those that have come stay.
import * as THREE from "three";
import { Bundle, none, Per } from "./bundle";
import { Balls, fieldLines, Lines, nodePlaces, treeLines } from "./marks";
import { areaOf } from "./normals";
import { Stage } from "./stage";
import { Colouring, Surface, surfaceOf } from "./surface";

export type Shown = "mesh" | "remesh" | "dual";

export interface Look {
  shown: Shown;
  colouring: Colouring | "truth";
  edges: boolean;
  seeds: boolean;
  trees: boolean;
  field: boolean;
  centroids: boolean;
  picked: number | null;
}

export class Viewer extends EventTarget {
  readonly stage: Stage;
  readonly mesh: Surface;
  readonly seeds: Balls;
  readonly look: Look = { shown: "mesh", colouring: "plain", edges: false, seeds: true, trees: false, field: false, centroids: true, picked: null };
  readonly remeshes = new Map<Shown, Surface>();
  offered = new Set<string>();  // layers that a session has, whether they have come or not
  region: Uint32Array | null = null;
  per: Per = "vertex";
  private truthRegion: Uint32Array | null = null;
  private readonly area: number;
  private readonly centroids: Balls;
  private readonly sites: Balls;
  private readonly trees: Lines;
  private readonly field: Lines;
  private readonly have = new Set<string>();
  private lastRegion: Uint32Array | null = null;
  private figures: Bundle | null = null;

  constructor(canvas: HTMLCanvasElement, readonly bundle: Bundle) {
    super();
    this.mesh = surfaceOf(bundle);
    this.area = areaOf(this.mesh.positions, this.mesh.triangles);
    this.stage = new Stage(canvas, this.mesh.positions);
    this.stage.scene.add(this.mesh.mesh);
    this.seeds = new Balls(this.stage.scene, 0x111114, 0.11);
    this.centroids = new Balls(this.stage.scene, 0xffffff, 0.11);
    this.sites = new Balls(this.stage.scene, 0x1f5aaa, 0.2);
    this.trees = new Lines(this.stage.scene);
    this.field = new Lines(this.stage.scene);
    this.add(bundle);
  }

  has(layer: string): boolean {
    return this.have.has(layer);
  }

  offers(layer: string): boolean {
    return this.has(layer) || this.offered.has(layer);
  }

  // Takes the layers that a bundle brings; a remesh becomes `shown`.
  add(bundle: Bundle, shown: Shown = "remesh"): void {
    if (bundle.has("colours")) {
      this.mesh.setOwnColours(bundle.numbers("colours"), bundle.per("colours"));
      this.have.add("own");
    }
    if (bundle.has("palette")) this.mesh.setPalette(Float32Array.from(bundle.numbers("palette")));
    if (bundle.has("region")) this.addRegions(bundle);
    if (bundle.has("parent")) {
      const placeOf = nodePlaces(this.mesh.positions, this.mesh.triangles, bundle.per("parent"));
      this.trees.set(treeLines(bundle.ids("parent"), placeOf));
      this.have.add("trees");
    }
    if (bundle.has("field")) {
      this.field.set(fieldLines(bundle.places("field"), this.mesh.positions, this.area));
      this.have.add("field");
    }
    if (bundle.has("truth_region")) {
      this.truthRegion = bundle.ids("truth_region");
      this.centroids.set(bundle.places("truth_centroids"), this.radius(bundle.numbers("truth_centroids").length / 3));
      this.have.add("truth");
    }
    if (bundle.has("remesh_positions")) this.addRemesh(bundle, shown);
    if (bundle.has("sites")) {
      this.sites.set(bundle.places("sites"), this.radius(bundle.numbers("sites").length / 3));
      this.have.add("sites");
    }
    this.update();
    this.dispatchEvent(new Event("layers"));
  }

  forget(layer: string): void {
    if (!this.have.delete(layer)) return;
    if (layer === this.look.shown) this.look.shown = "mesh";
    if (layer === "truth" && this.look.colouring === "truth") this.look.colouring = "regions";
    this.update();
    this.dispatchEvent(new Event("layers"));
  }

  // Another partition of the same nodes: a frame of the timeline, or the state of a session.
  setRegions(region: Uint32Array, seeds: Float32Array, per: Per): void {
    this.region = region;
    this.per = per;
    this.seeds.set(seeds, this.radius(seeds.length / 3));
    this.update();
  }

  set(change: Partial<Look>): void {
    Object.assign(this.look, change);
    this.update();
    this.dispatchEvent(new Event("look"));
  }

  pick(region: number | null): void {
    this.set({ picked: region });
    this.dispatchEvent(new Event("picked"));
  }

  // The node and the region under a pixel of the window.
  at(x: number, y: number): { node: number; region: number | null } | null {
    if (this.look.shown !== "mesh") return null;
    const node = this.stage.pick(this.mesh, x, y);
    if (node === null) return null;
    const region = this.region ? this.region[node] : none;
    return { node, region: region === none || region === undefined ? null : region };
  }

  placeOfNode(node: number): THREE.Vector3 {
    return new THREE.Vector3(...nodePlaces(this.mesh.positions, this.mesh.triangles, this.per)(node));
  }

  // What the program found out about a region; undefined where it did not say.
  figure(name: "seed_id" | "region_nodes" | "region_area" | "region_energy", region: number): number | undefined {
    return this.figures?.has(name) ? this.figures.numbers(name)[region] : undefined;
  }

  private addRegions(bundle: Bundle): void {
    this.figures = bundle;
    const isFirst = !this.have.has("regions");
    this.have.add("regions");
    if (isFirst) this.look.colouring = "regions";
    this.setRegions(bundle.ids("region"), bundle.places("seeds"), bundle.per("region"));
    if (this.look.picked !== null && this.look.picked >= this.seeds.count) this.look.picked = null;
    this.dispatchEvent(new Event("picked"));
  }

  private addRemesh(bundle: Bundle, shown: Shown): void {
    const earlier = this.remeshes.get(shown);
    if (earlier) {
      this.stage.scene.remove(earlier.mesh);
      earlier.dispose();
    }
    const remesh = surfaceOf(bundle, "remesh_");
    this.remeshes.set(shown, remesh);
    this.stage.scene.add(remesh.mesh);
    this.have.add(shown);
  }

  private radius(count: number): number {
    return Math.sqrt(this.area / Math.PI / Math.max(count, 1));
  }

  private update(): void {
    const { look } = this;
    const isMesh = look.shown === "mesh" || !this.has(look.shown);
    const isTruth = look.colouring === "truth";
    const shownRegion = isTruth ? this.truthRegion : this.region;
    if (shownRegion && shownRegion !== this.lastRegion) this.mesh.setRegions(shownRegion, this.per);
    this.lastRegion = shownRegion;
    const isRemeshing = this.has("sites");
    const colouring = isRemeshing ? "plain" : isTruth ? "regions" : look.colouring;
    this.mesh.setLook({ colouring: colouring as Colouring, edges: look.edges, pale: (look.trees && this.has("trees")) || (look.field && this.has("field")), picked: look.picked });
    this.mesh.mesh.visible = isMesh;
    for (const [shown, remesh] of this.remeshes) {
      remesh.mesh.visible = !isMesh && shown === look.shown;
      remesh.setLook({ colouring: "plain", edges: true, pale: false, picked: null });
    }
    this.seeds.show(isMesh && look.seeds && !isRemeshing);
    this.trees.show(isMesh && look.trees);
    this.field.show(isMesh && look.field);
    this.centroids.show(isMesh && isTruth && look.centroids && !isRemeshing);
    this.sites.show(isMesh && isRemeshing);
    this.stage.request();
  }
}
