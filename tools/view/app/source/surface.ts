// A mesh that is drawn from textures: three corners a triangle, without vertex buffers. Regions are looked up per
// node, colours per region, so a new partition is one texture. Borders between two regions run straight across triangles.
import * as THREE from "three";
import { Bundle, Per } from "./bundle";
import { packDirection, unpackCode, vertexNormals } from "./normals";
import { colourTexture, fetchCode, idTexture, makeTexture } from "./textures";

export type Colouring = "regions" | "own" | "plain";

const head = `
precision highp float; precision highp int; precision highp usampler2D; precision highp sampler2D;
uniform int uNodes;  // 0: vertices, 1: triangles, 2: both
${fetchCode}`;

// Of a corner: its place, and what `body` makes of it for `outputs`. Few outputs: each costs as much as a triangle's pixels.
const vertexShaderOf = (outputs: string, body: string) => `${head}
uniform mat4 modelViewMatrix, projectionMatrix;
uniform sampler2D uPositions;
uniform usampler2D uTriangles, uRegions;
uniform uint uFirstTriangle;
uniform int uColouring, uColoursPer;  // 0: plain, 1: own, 2: regions; per 0: vertices, 1: triangles
out vec3 vWeights;
flat out uvec4 vRegions;
${outputs}
uint region_of(uint node) { return texelFetch(uRegions, place_of(node), 0).r; }
void main() {
  uint triangle = uint(gl_VertexID) / 3u;
  uint c = uint(gl_VertexID) % 3u;
  uvec3 corners = texelFetch(uTriangles, place_of(triangle), 0).rgb;
  uvec4 nodes = uvec4(corners, uFirstTriangle + triangle);
  vec4 packed_place = texelFetch(uPositions, place_of(corners[c]), 0);
  vec4 place = modelViewMatrix * vec4(packed_place.xyz, 1.0);
  vWeights = vec3(c == 0u, c == 1u, c == 2u);
  gl_Position = projectionMatrix * place;
  vRegions = uvec4(0u);
  if (uColouring == 2) {
    vRegions = uNodes == 1 ? uvec4(region_of(nodes.w))
      : uvec4(region_of(nodes.x), region_of(nodes.y), region_of(nodes.z), uNodes == 2 ? region_of(nodes.w) : 0u);
  }
  ${body}
}`;

const vertexShader = vertexShaderOf(`
uniform sampler2D uColours;
out vec3 vNormal, vPlace, vOwn;
${unpackCode}`, `
  vNormal = mat3(modelViewMatrix) * unpack_direction(packed_place.w);
  vPlace = place.xyz;
  vOwn = uColouring == 1 ? texelFetch(uColours, place_of(uColoursPer == 1 ? triangle : corners[c]), 0).rgb : vec3(0.0);`);

const pickVertexShader = vertexShaderOf("flat out uvec4 vNodes;", "vNodes = nodes;");

// A pixel is of the nearest corner, but of none whose region has the lesser share: a zigzag around each corner would
// be the border between two regions.
const fragmentHead = `${head}
in vec3 vWeights;
flat in uvec4 vRegions;
int node_of() {
  if (uNodes == 1) return 3;
  vec3 w = vWeights;
  if (uNodes == 2 && max(w.x, max(w.y, w.z)) < 2.0 / 3.0) return 3;
  uvec3 r = vRegions.xyz;
  if (uNodes == 0) {
    if (r.y == r.z && r.x != r.y) w.x = w.x < 0.5 ? 0.0 : 1.0;
    if (r.z == r.x && r.y != r.z) w.y = w.y < 0.5 ? 0.0 : 1.0;
    if (r.x == r.y && r.z != r.x) w.z = w.z < 0.5 ? 0.0 : 1.0;
  }
  float most = max(w.x, max(w.y, w.z));
  return w.x == most ? 0 : w.y == most ? 1 : 2;
}`;

const fragmentShader = `${fragmentHead}
uniform sampler2D uPalette;
uniform int uColouring;
uniform uint uPicked;
uniform bool uEdges, uPale;
uniform vec3 uPlain;
in vec3 vNormal, vPlace, vOwn;
out vec4 colour;
void main() {
  vec3 base = uPlain;
  if (uColouring == 1) {
    base = vOwn;
  } else if (uColouring == 2) {
    uint region = vRegions[node_of()];
    base = region == 0xffffffffu ? vec3(0.5) : texelFetch(uPalette, place_of(region), 0).rgb;
    if (uPale) base = mix(base, vec3(1.0), 0.55);
    // Stripes, dark and light: they differ from any colour.
    if (region == uPicked) base = mix(base, vec3(step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 10.0))), 0.6);
  }
  vec3 face = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  vec3 normal = normalize(vNormal);
  if (dot(normal, face) < 0.0) normal = -normal;
  if (!(dot(normal, face) > 0.766)) normal = face;  // sharper than 40 degrees: an edge
  float light = 0.35 + 0.65 * max(dot(normal, normalize(-vPlace + vec3(-0.6, 0.8, 0.0))), 0.0);
  base *= light;
  if (uEdges) {
    vec3 w = vWeights / max(fwidth(vWeights), vec3(1e-6));
    float shown = 1.0 - smoothstep(0.2, 0.9, min(w.x, min(w.y, w.z)));
    float room = 1.0 / max(length(fwidth(vWeights)), 1e-6);
    base = mix(base, vec3(0.05), 0.8 * shown * clamp((room - 2.0) / 8.0, 0.0, 1.0));
  }
  colour = vec4(base, 1.0);
}`;

// The node under each pixel, as four bytes.
const pickShader = `${fragmentHead}
flat in uvec4 vNodes;
out vec4 colour;
void main() {
  uint node = vNodes[node_of()];
  colour = vec4(node & 255u, (node >> 8) & 255u, (node >> 16) & 255u, node >> 24) / 255.0;
}`;

const nodesNumber: Record<Per, number> = { vertex: 0, triangle: 1, both: 2 };

export class Surface {
  readonly mesh: THREE.Mesh;
  readonly pickMaterial: THREE.RawShaderMaterial;
  private readonly uniforms: Record<string, THREE.IUniform>;

  constructor(readonly positions: Float32Array, readonly triangles: Uint32Array) {
    const vertices = positions.length / 3;
    const count = triangles.length / 3;
    const normals = vertexNormals(positions, triangles);
    this.uniforms = {
      uPositions: { value: makeTexture("places", vertices, (values) => {
        for (let v = 0; v < vertices; ++v) {
          for (let c = 0; c < 3; ++c) values[4 * v + c] = positions[3 * v + c];
          values[4 * v + 3] = packDirection(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
        }
      }) },
      uTriangles: { value: makeTexture("corners", count, (values) => {
        for (let t = 0; t < count; ++t) for (let c = 0; c < 3; ++c) values[4 * t + c] = triangles[3 * t + c];
      }) },
      uRegions: { value: idTexture(new Uint32Array(0)) },
      uPalette: { value: colourTexture([]) },
      uColours: { value: colourTexture([]) },
      uColouring: { value: 0 },
      uColoursPer: { value: 0 },
      uNodes: { value: 0 },
      uFirstTriangle: { value: 0 },
      uPicked: { value: 0xfffffffe },
      uEdges: { value: false },
      uPale: { value: false },
      uPlain: { value: new THREE.Vector3(0.84, 0.82, 0.79) },
    };
    const common = { glslVersion: THREE.GLSL3, uniforms: this.uniforms, side: THREE.DoubleSide };
    const material = new THREE.RawShaderMaterial({ ...common, vertexShader, fragmentShader, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 4 });
    this.pickMaterial = new THREE.RawShaderMaterial({ ...common, vertexShader: pickVertexShader, fragmentShader: pickShader, blending: THREE.NoBlending });
    const geometry = new THREE.BufferGeometry();
    geometry.setDrawRange(0, triangles.length);
    this.mesh = new THREE.Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  setOwnColours(colours: ArrayLike<number>, per: Per): void {
    this.replace("uColours", colourTexture(colours));
    this.uniforms.uColoursPer.value = nodesNumber[per];
  }

  setRegions(region: Uint32Array, per: Per): void {
    this.replace("uRegions", idTexture(region));
    this.setNodes(per);
  }

  // Of what nodes are; without regions, too, for picking.
  setNodes(per: Per): void {
    this.uniforms.uNodes.value = nodesNumber[per];
    this.uniforms.uFirstTriangle.value = per === "both" ? this.positions.length / 3 : 0;
  }

  setPalette(palette: ArrayLike<number>): void {
    this.replace("uPalette", colourTexture(palette));
  }

  setLook(look: { colouring: Colouring; edges: boolean; pale: boolean; picked: number | null }): void {
    this.uniforms.uColouring.value = { plain: 0, own: 1, regions: 2 }[look.colouring];
    this.uniforms.uEdges.value = look.edges;
    this.uniforms.uPale.value = look.pale;
    this.uniforms.uPicked.value = look.picked ?? 0xfffffffe;
  }

  dispose(): void {
    for (const { value } of Object.values(this.uniforms)) if (value instanceof THREE.Texture) value.dispose();
    (this.mesh.material as THREE.Material).dispose();
    this.pickMaterial.dispose();
    this.mesh.geometry.dispose();
  }

  private replace(name: string, texture: THREE.DataTexture): void {
    (this.uniforms[name].value as THREE.Texture).dispose();
    this.uniforms[name].value = texture;
  }
}

export function surfaceOf(bundle: Bundle, prefix = ""): Surface {
  return new Surface(bundle.places(`${prefix}positions`), bundle.numbers(`${prefix}triangles`) as Uint32Array);
}
