// Seeds and centroids as small balls, trees and fields as lines.
import * as THREE from "three";
import { none, Per } from "./bundle";

export class Balls {
  object: THREE.InstancedMesh | null = null;
  places: Float32Array = new Float32Array(0);

  constructor(private readonly scene: THREE.Scene, private readonly colour: number, private readonly size: number) {}

  get count(): number {
    return this.places.length / 3;
  }

  place(i: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.places, 3 * i);
  }

  // `radius`: what a region of the mean area has.
  set(places: Float32Array, radius: number): void {
    this.places = places;
    if (this.object && this.object.count !== this.count) this.remove();
    if (!this.object) {
      this.object = new THREE.InstancedMesh(new THREE.OctahedronGeometry(1, 2), new THREE.MeshBasicMaterial({ color: this.colour }), this.count);
      this.object.frustumCulled = false;
      this.scene.add(this.object);
    }
    const size = this.size * radius;
    const matrix = new THREE.Matrix4().makeScale(size, size, size);
    for (let i = 0; i < this.count; ++i) {
      this.object.setMatrixAt(i, matrix.setPosition(places[3 * i], places[3 * i + 1], places[3 * i + 2]));
    }
    this.object.instanceMatrix.needsUpdate = true;
  }

  move(i: number, place: THREE.Vector3): void {
    place.toArray(this.places, 3 * i);
    const matrix = new THREE.Matrix4();
    this.object?.getMatrixAt(i, matrix);
    this.object?.setMatrixAt(i, matrix.setPosition(place));
    if (this.object) this.object.instanceMatrix.needsUpdate = true;
  }

  show(isShown: boolean): void {
    if (this.object) this.object.visible = isShown;
  }

  private remove(): void {
    if (!this.object) return;
    this.scene.remove(this.object);
    this.object.geometry.dispose();
    this.object.dispose();
    this.object = null;
  }
}

export class Lines {
  private object: THREE.LineSegments | null = null;

  constructor(private readonly scene: THREE.Scene) {}

  // Two places a line, and a colour for each place, or one for all.
  set(places: Float32Array, colour: number | Float32Array): void {
    this.remove();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
    const varies = typeof colour !== "number";
    if (varies) geometry.setAttribute("color", new THREE.BufferAttribute(colour, 3));
    const material = new THREE.LineBasicMaterial(varies ? { vertexColors: true } : { color: colour });
    this.object = new THREE.LineSegments(geometry, material);
    this.object.frustumCulled = false;
    this.scene.add(this.object);
  }

  show(isShown: boolean): void {
    if (this.object) this.object.visible = isShown;
  }

  private remove(): void {
    if (!this.object) return;
    this.scene.remove(this.object);
    this.object.geometry.dispose();
    (this.object.material as THREE.Material).dispose();
    this.object = null;
  }
}

// Where a node is: a vertex, or the middle of a triangle.
export function nodePlaces(positions: Float32Array, triangles: Uint32Array, per: Per): (node: number) => [number, number, number] {
  const first = per === "vertex" ? Infinity : per === "triangle" ? 0 : positions.length / 3;
  return (node) => {
    if (node < first) return [positions[3 * node], positions[3 * node + 1], positions[3 * node + 2]];
    const t = 3 * (node - first);
    const middle: [number, number, number] = [0, 0, 0];
    for (let c = 0; c < 3; ++c) for (let k = 0; k < 3; ++k) middle[k] += positions[3 * triangles[t + c] + k] / 3;
    return middle;
  };
}

export function treeLines(parent: Uint32Array, placeOf: (node: number) => [number, number, number]): Float32Array {
  let count = 0;
  for (const p of parent) if (p !== none) ++count;
  const lines = new Float32Array(6 * count);
  let at = 0;
  parent.forEach((p, node) => {
    if (p === none) return;
    lines.set(placeOf(node), at);
    lines.set(placeOf(p), at + 3);
    at += 6;
  });
  return lines;
}

// Crosses at some vertices, evenly spread over their numbers: the larger direction blue, the other orange.
export function fieldLines(field: Float32Array, positions: Float32Array): { places: Float32Array; colours: Float32Array } {
  const most = 6000;
  const step = Math.max(1, Math.floor(field.length / 6 / most));
  const length = 0.5 / Math.sqrt(Math.min(most, field.length / 6));
  const places: number[] = [], colours: number[] = [];
  const blue = [0.12, 0.35, 0.67], orange = [0.86, 0.41, 0.06];
  for (let v = 0; v < field.length / 6; v += step) {
    const size = [0, 3].map((k) => Math.hypot(field[6 * v + k], field[6 * v + k + 1], field[6 * v + k + 2]));
    [0, 3].forEach((k, i) => {
      for (const sign of [-1, 1]) {
        for (let c = 0; c < 3; ++c) places.push(positions[3 * v + c] + sign * length * field[6 * v + k + c]);
        colours.push(...((i === 0) === (size[0] >= size[1]) ? blue : orange));
      }
    });
  }
  return { places: Float32Array.from(places), colours: Float32Array.from(colours) };
}
