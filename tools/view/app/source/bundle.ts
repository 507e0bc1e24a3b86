// Reads bundles: the format is told in ../../bundle.h.

export type Numbers = Float32Array | Uint32Array | Uint16Array | Uint8Array;
export type Per = "vertex" | "triangle" | "both";

export interface Frame { label: string; energy: number; seeds: string; region: string }
export interface Info {
  facts?: [string, string][];
  notes?: string[];
  node?: string;
  colouring?: string;
  surface?: string;
  command_line?: string;
}

interface Entry { type: "f32" | "u32" | "u16" | "u8"; components: number; count: number; offset: number; per?: "vertex" | "triangle"; origin?: number[]; step?: number[] }
interface Header { version: number; title: string; origin: number[]; scale: number; arrays: Record<string, Entry>; info: Info; frames: Frame[] }

const magic = 0x424c4c47;
const types = { f32: Float32Array, u32: Uint32Array, u16: Uint16Array, u8: Uint8Array };

export const none = 0xffffffff;

export class Bundle {
  readonly header: Header;
  private readonly data: number;

  constructor(private readonly buffer: ArrayBuffer) {
    const begin = new DataView(buffer);
    if (buffer.byteLength < 8 || begin.getUint32(0, true) !== magic) throw new Error("The data are no bundle of geolloyd.");
    const size = begin.getUint32(4, true);
    this.header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, size))) as Header;
    if (this.header.version !== 1) throw new Error("The data are of another version of geolloyd.");
    this.data = 8 + size;
  }

  has(name: string): boolean {
    return name in this.header.arrays;
  }

  per(name: string): Per {
    return this.header.arrays[name].per ?? "both";
  }

  numbers(name: string): Numbers {
    const entry = this.header.arrays[name];
    if (!entry) throw new Error(`The data have no ${name}.`);
    return new types[entry.type](this.buffer, this.data + entry.offset, entry.count * entry.components);
  }

  // 32 bits each, whatever the bundle has; none is `none`.
  ids(name: string): Uint32Array {
    const numbers = this.numbers(name);
    if (numbers instanceof Uint32Array) return numbers;
    const ids = Uint32Array.from(numbers);
    for (let i = 0; i < ids.length; ++i) if (ids[i] === 0xffff) ids[i] = none;
    return ids;
  }

  // In the viewer's units, also where they were quantised.
  places(name: string): Float32Array {
    const numbers = this.numbers(name);
    const { origin, step } = this.header.arrays[name];
    if (!origin || !step) return numbers as Float32Array;
    return Float32Array.from(numbers, (value, i) => origin[i % 3] + step[i % 3] * value);
  }
}

export function bundleOfText(base64: string): Bundle {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new Bundle(bytes.buffer);
}
