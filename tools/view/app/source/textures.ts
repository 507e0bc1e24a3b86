// Arrays as textures that shaders read by index: no size of a vertex buffer binds them, and one of them can be
// replaced without the others.
import * as THREE from "three";
import type { Numbers } from "./bundle";

const width = 4096;

const kinds = {
  places: { format: THREE.RGBAFormat, type: THREE.FloatType, internal: "RGBA32F", components: 4, make: Float32Array },
  corners: { format: THREE.RGBAIntegerFormat, type: THREE.UnsignedIntType, internal: "RGBA32UI", components: 4, make: Uint32Array },
  ids: { format: THREE.RedIntegerFormat, type: THREE.UnsignedIntType, internal: "R32UI", components: 1, make: Uint32Array },
  colours: { format: THREE.RGBAFormat, type: THREE.UnsignedByteType, internal: "RGBA8", components: 4, make: Uint8Array },
} as const;

// `fill` writes entry after entry; a texture has at least one.
export function makeTexture(kind: keyof typeof kinds, count: number, fill: (values: Numbers) => void): THREE.DataTexture {
  const { format, type, internal, components, make } = kinds[kind];
  const rows = Math.max(1, Math.ceil(count / width));
  const values = new make(width * rows * components);
  fill(values);
  const texture = new THREE.DataTexture(values, width, rows, format, type);
  texture.internalFormat = internal;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

export function idTexture(ids: Uint32Array): THREE.DataTexture {
  return makeTexture("ids", ids.length, (values) => values.set(ids));
}

// Of three components each, one after the other.
export function colourTexture(colours: ArrayLike<number>): THREE.DataTexture {
  const count = colours.length / 3;
  return makeTexture("colours", count, (values) => {
    for (let i = 0; i < count; ++i) for (let c = 0; c < 3; ++c) values[4 * i + c] = colours[3 * i + c];
  });
}

export const fetchCode = `ivec2 place_of(uint i) { return ivec2(int(i & ${width - 1}u), int(i >> ${Math.log2(width)}u)); }\n`;
