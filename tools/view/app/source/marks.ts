// Seeds and centroids as small balls, trees and fields as lines.
import * as THREE from "three";
import { none, Per } from "./bundle";

// One object of the scene, which may be replaced, and hidden.
class Mark<T extends THREE.InstancedMesh | THREE.LineSegments> {
  protected object: T | null = null;

  constructor(private readonly scene: THREE.Scene) {}

  show(isShown: boolean): void {
    if (this.object) this.object.visible = isShown;
  }

  protected replace(object: T): void {
    if (this.object) {
      this.scene.remove(this.object);
      this.object.geometry.dispose();
      (this.object.material as THREE.Material).dispose();
      if (this.object instanceof THREE.InstancedMesh) this.object.dispose();
    }
    this.object = object;
    object.frustumCulled = false;
    this.scene.add(object);
  }
}

const small = 500;  // where there are more balls, each is small enough for fewer triangles

export class Balls extends Mark<THREE.InstancedMesh> {
  private places: Float32Array = new Float32Array(0);

  constructor(scene: THREE.Scene, private readonly colour: number, private readonly size: number) {
    super(scene);
  }

  get count(): number {
    return this.places.length / 3;
  }

  place(i: number): THREE.Vector3 {
    return new THREE.Vector3().fromArray(this.places, 3 * i);
  }

  // `radius`: what a region of the mean area has.
  set(places: Float32Array, radius: number): void {
    this.places = places;
    if (this.object?.count !== this.count) {
      const detail = this.count > small ? 1 : 2;
      this.replace(new THREE.InstancedMesh(new THREE.OctahedronGeometry(1, detail), new THREE.MeshBasicMaterial({ color: this.colour }), this.count));
    }
    const size = this.size * radius;
    const matrix = new THREE.Matrix4().makeScale(size, size, size);
    for (let i = 0; i < this.count; ++i) {
      this.object!.setMatrixAt(i, matrix.setPosition(places[3 * i], places[3 * i + 1], places[3 * i + 2]));
    }
    this.object!.instanceMatrix.needsUpdate = true;
  }

  move(i: number, place: THREE.Vector3): void {
    if (!this.object) return;
    place.toArray(this.places, 3 * i);
    const matrix = new THREE.Matrix4();
    this.object.getMatrixAt(i, matrix);
    this.object.setMatrixAt(i, matrix.setPosition(place));
    this.object.instanceMatrix.needsUpdate = true;
  }
}

// Two places a line, and a colour for each place.
export interface ColouredLines { places: Float32Array; colours: Float32Array }

export class Lines extends Mark<THREE.LineSegments> {
  set({ places, colours }: ColouredLines): void {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(places, 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(colours, 3));
    const material = new THREE.LineBasicMaterial({ vertexColors: true });
    // A little nearer than they are: where the surface curves they would be hidden in it.
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(/}\s*$/, "gl_Position.z -= 0.004 * gl_Position.w;}");
    };
    this.replace(new THREE.LineSegments(geometry, material));
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

// How many nodes are reached by way of each, with itself.
function subtreeSizes(parent: Uint32Array): Uint32Array {
  const waiting = new Uint32Array(parent.length);  // children that are not done
  for (const p of parent) if (p !== none) ++waiting[p];
  const sizes = new Uint32Array(parent.length).fill(1);
  const done: number[] = [];
  waiting.forEach((count, node) => {
    if (count === 0) done.push(node);
  });
  for (let node = done.pop(); node !== undefined; node = done.pop()) {
    const p = parent[node];
    if (p === none) continue;
    sizes[p] += sizes[node];
    if (--waiting[p] === 0) done.push(p);
  }
  return sizes;
}

const mostTreeLines = 12_000;

// Each node joined to its parent, darker the more nodes are reached by it. Of large meshes the finest are left out.
export function treeLines(parent: Uint32Array, placeOf: (node: number) => [number, number, number]): ColouredLines {
  const sizes = subtreeSizes(parent);
  const least = Math.max(1, parent.length / mostTreeLines);
  const places: number[] = [], colours: number[] = [];
  parent.forEach((p, node) => {
    if (p === none || sizes[node] < least) return;
    places.push(...placeOf(node), ...placeOf(p));
    const shade = 0.45 * Math.max(0, 1 - Math.log2(sizes[node] / least) / 6);
    colours.push(shade, shade, shade, shade, shade, shade);
  });
  return { places: Float32Array.from(places), colours: Float32Array.from(colours) };
}

const mostCrosses = 3000;

// Crosses at some vertices, evenly spread over their numbers: the larger direction blue, the other orange. The larger
// one has the same length everywhere, so that the ratio is seen where magnitudes are small, too.
export function fieldLines(field: Float32Array, positions: Float32Array, area: number): ColouredLines {
  const count = field.length / 6;
  const step = Math.max(1, Math.floor(count / mostCrosses));
  const length = 0.45 * Math.sqrt((area * step) / Math.max(count, 1));
  const places: number[] = [], colours: number[] = [];
  const blue = [0.12, 0.35, 0.67], orange = [0.86, 0.41, 0.06];
  for (let v = 0; v < count; v += step) {
    const size = [0, 3].map((k) => Math.hypot(field[6 * v + k], field[6 * v + k + 1], field[6 * v + k + 2]));
    const scale = length / (Math.max(...size) || 1);
    [0, 3].forEach((k, i) => {
      for (const sign of [-1, 1]) {
        for (let c = 0; c < 3; ++c) places.push(positions[3 * v + c] + sign * scale * field[6 * v + k + c]);
        colours.push(...((i === 0) === (size[0] >= size[1]) ? blue : orange));
      }
    });
  }
  return { places: Float32Array.from(places), colours: Float32Array.from(colours) };
}
