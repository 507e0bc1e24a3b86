// A remesh with colours, as GLB and as glTF, in the loader of three.js: what it finds is what a PLY file says.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { GLTFLoader } from "../../tools/view/app/node_modules/three/examples/jsm/loaders/GLTFLoader.js";
import { expect, geolloyd, report } from "./browser.mjs";

globalThis.ProgressEvent ??= Event;  // a browser has it
const began = Date.now();
const around = 48, across = 24;

// A torus, red where x > 0, and blue elsewhere.
function colouredTorus() {
  const vertices = [], triangles = [];
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const u = (2 * Math.PI * i) / around, v = (2 * Math.PI * j) / across, r = 1 + 0.4 * Math.cos(v);
      const id = (a, b) => (a % around) * across + (b % across);
      vertices.push(`${r * Math.cos(u)} ${r * Math.sin(u)} ${0.4 * Math.sin(v)} ${Math.cos(u) > 0 ? "255 0 0" : "0 0 255"}`);
      triangles.push(`3 ${id(i, j)} ${id(i + 1, j)} ${id(i + 1, j + 1)}`, `3 ${id(i, j)} ${id(i + 1, j + 1)} ${id(i, j + 1)}`);
    }
  }
  const properties = ["x", "y", "z"].map((name) => `property float ${name}`)
    .concat(["red", "green", "blue"].map((name) => `property uchar ${name}`));
  return ["ply", "format ascii 1.0", `element vertex ${vertices.length}`, ...properties, `element face ${triangles.length}`,
    "property list uchar int vertex_indices", "end_header", ...vertices, ...triangles, ""].join("\n");
}

async function loaded(file) {
  const bytes = readFileSync(file);
  const { scene } = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), "");
  const meshes = [];
  scene.traverse((object) => object.isMesh && meshes.push(object));
  expect(meshes.length === 1, `${meshes.length} meshes in ${file}`);
  return meshes[0];
}

const folder = mkdtempSync(join(tmpdir(), "geolloyd-gltf-"));
try {
  const mesh = join(folder, "torus.ply");
  writeFileSync(mesh, colouredTorus());
  for (const ending of ["glb", "gltf"]) {
    const file = join(folder, `remesh.${ending}`);
    const said = geolloyd("remesh", mesh, "--vertices", "300", "--output", file);
    const { geometry, material } = await loaded(file);
    const { position, color } = geometry.attributes;
    expect(position.count === 300 && color.count === 300, `${position.count} vertices, ${color.count} colours`);
    expect(geometry.index.count === 3 * 600, `${geometry.index.count / 3} triangles on a torus; ${said}`);
    expect(Math.max(...geometry.index.array) === 299, "triangles name its vertices");
    expect(material.vertexColors, "the material shows colours");
    for (let v = 0; v < position.count; ++v) {
      const x = position.getX(v), fromRing = Math.hypot(x, position.getY(v)) - 1;
      expect(Math.abs(Math.hypot(fromRing, position.getZ(v)) - 0.4) < 0.03, `vertex ${v} is on the torus`);
      if (Math.abs(x) < 0.2) continue;  // colours meet there
      const [red, green, blue] = [color.getX(v), color.getY(v), color.getZ(v)];
      if (x > 0) expect(red > 0.99 && green < 0.01 && blue < 0.01, `vertex ${v} is red`);
      else expect(red < 0.01 && green < 0.01 && blue > 0.99, `vertex ${v} is blue`);
    }
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
report("glTF in three.js", began);
