// The canvas: camera, controls, drawing on demand, and what is under a pixel.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Smoothing } from "./smoothing";
import type { Surface } from "./surface";

// Of what is seen; vertices of no triangle may be farther off than 1.
function radiusOf(positions: Float32Array): number {
  let most = 0;
  for (let i = 0; i < positions.length; i += 3) most = Math.max(most, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
  return Math.min(1, most) || 1;
}

// As of the program's pictures: along the shortest side of the box, with the middle one upright.
function axesOf(positions: Float32Array): [THREE.Vector3, THREE.Vector3] {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const side = [0, 1, 2].sort((a, b) => high[a] - low[a] - (high[b] - low[b]) || a - b);
  const unit = (axis: number) => new THREE.Vector3().setComponent(axis, 1);
  return [unit(side[0]), unit(side[1])];
}

// 25 degrees to the right and 15 up.
function firstView(front: THREE.Vector3, up: THREE.Vector3): THREE.Vector3 {
  const azimuth = (25 * Math.PI) / 180, elevation = (15 * Math.PI) / 180;
  const level = front.clone().multiplyScalar(Math.cos(azimuth)).addScaledVector(new THREE.Vector3().crossVectors(up, front), Math.sin(azimuth));
  return level.multiplyScalar(Math.cos(elevation)).addScaledVector(up, Math.sin(elevation));
}

export class Stage {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
  readonly controls: OrbitControls;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly smoothing: Smoothing;
  private readonly pickScene = new THREE.Scene();
  private readonly pickTarget = new THREE.WebGLRenderTarget(1, 1);
  private isAsked = false;
  private drawn = 0;
  private readonly front: THREE.Vector3;
  private readonly radius: number;

  constructor(readonly canvas: HTMLCanvasElement, positions: Float32Array) {
    const [front, up] = axesOf(positions);
    this.front = firstView(front, up);
    this.radius = radiusOf(positions);
    this.camera.up.copy(up);  // before there are controls, which keep it
    this.renderer = new THREE.WebGLRenderer({ canvas, alpha: true });
    this.smoothing = new Smoothing(this.renderer, () => this.draw(true));
    THREE.ColorManagement.enabled = false;  // colours are drawn as they are
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.request());
    canvas.addEventListener("keydown", (event) => this.turnByKey(event));
    new ResizeObserver(() => this.resize()).observe(canvas);
    canvas.addEventListener("webglcontextrestored", () => this.request());
    this.resize();
    this.showAll();
  }

  showAll(): void {
    const half = Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(1, this.camera.aspect);
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(this.front).multiplyScalar(this.radius / Math.sin(Math.atan(half)));
    this.controls.update();
    this.request();
  }

  // Draws once, before the browser's next frame; without a request nothing is drawn.
  request(): void {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => this.draw());
  }

  // `isSmooth`: with smooth edges, however long that takes.
  draw(isSmooth = false): void {
    this.isAsked = false;
    const distance = this.camera.position.length();
    this.camera.near = Math.max(distance - 1.1, 0.002);
    this.camera.far = distance + 1.1;
    this.camera.updateProjectionMatrix();
    this.smoothing.draw(this.scene, this.camera, isSmooth);
    this.canvas.dataset.drawn = String(++this.drawn);
  }

  // The node at a place of the window; null: none is there.
  pick(surface: Surface, x: number, y: number): number | null {
    const box = this.canvas.getBoundingClientRect();
    const mesh = new THREE.Mesh(surface.mesh.geometry, surface.pickMaterial);
    mesh.frustumCulled = false;
    this.pickScene.add(mesh);
    this.camera.setViewOffset(box.width, box.height, x - box.left, y - box.top, 1, 1);
    this.renderer.setRenderTarget(this.pickTarget);
    this.renderer.setClearColor(0xffffff, 1);
    this.renderer.clear();
    this.renderer.render(this.pickScene, this.camera);
    const pixel = new Uint8Array(4);
    this.renderer.readRenderTargetPixels(this.pickTarget, 0, 0, 1, 1, pixel);
    this.renderer.setRenderTarget(null);
    this.renderer.setClearColor(0x000000, 0);
    this.camera.clearViewOffset();
    this.pickScene.remove(mesh);
    const node = new DataView(pixel.buffer).getUint32(0, true);
    return node === 0xffffffff ? null : node;
  }

  // Where a place of the mesh is in the window.
  project(place: THREE.Vector3): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    const p = place.clone().project(this.camera);
    return { x: box.left + ((p.x + 1) / 2) * box.width, y: box.top + ((1 - p.y) / 2) * box.height };
  }

  picture(): Promise<Blob | null> {
    this.draw(true);
    return new Promise((done) => this.canvas.toBlob(done, "image/png"));
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    const wasNarrow = Math.min(1, this.camera.aspect);
    this.camera.aspect = width / height;
    // What was in sight stays in sight.
    this.camera.position.sub(this.controls.target).multiplyScalar(wasNarrow / Math.min(1, this.camera.aspect)).add(this.controls.target);
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  private turnByKey(event: KeyboardEvent): void {
    const step = Math.PI / 18;
    const offset = this.camera.position.clone().sub(this.controls.target);
    const right = new THREE.Vector3().crossVectors(this.camera.up, offset).normalize();
    const level = offset.angleTo(this.camera.up);
    const turns: Record<string, () => void> = {
      ArrowLeft: () => offset.applyAxisAngle(this.camera.up, -step),
      ArrowRight: () => offset.applyAxisAngle(this.camera.up, step),
      ArrowUp: () => offset.applyAxisAngle(right, -Math.min(step, level - 0.01)),
      ArrowDown: () => offset.applyAxisAngle(right, Math.min(step, Math.PI - 0.01 - level)),
      "+": () => offset.multiplyScalar(1 / 1.2),
      "-": () => offset.multiplyScalar(1.2),
      "0": () => this.showAll(),
    };
    const turn = turns[event.key];
    if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    turn();
    if (event.key === "0") return;
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.request();
  }
}
