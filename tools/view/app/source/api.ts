// What a session says and takes: the server's side is ../../http_*.h and ../../session.h.
import { Bundle } from "./bundle";

export interface Options { graph: string; norm: string; field: string; greedy: string; init: string; seed_count: number; random_seed: number }
export type Choice = "graph" | "norm" | "field" | "greedy" | "init";

export interface State {
  revision: number;
  mesh: { name: string; vertices: number; triangles: number; min: number[]; max: number[] };
  options: Options;
  choices: Record<Choice, string[]>;
  task: { name: string; text: string } | null;
  running: boolean;
  phase: string;
  step: number;
  seeds: number;
  moving: number;
  energy: number;
  initial_energy: number;
  energies: number[];
  layers: Record<string, number>;
  command_line: string;
  fingerprint: string | null;
  remesh: { vertices: number; iteration: number; energy_ratio: number; fingerprint: string | null; command_line: string | null } | null;
  output: string | null;
  message: { kind: "error" | "done"; text: string } | null;
}

export type Command = { do: string } & Record<string, unknown>;

export class Api {
  constructor(private readonly token: string) {}

  async state(): Promise<State> {
    return (await this.get("state")).json() as Promise<State>;
  }

  async bundle(path: string): Promise<Bundle> {
    return new Bundle(await (await this.get(path)).arrayBuffer());
  }

  async command(command: Command): Promise<void> {
    const response = await fetch("/api/command", {
      method: "POST",
      headers: { "X-Geolloyd-Token": this.token, "Content-Type": "application/json" },
      body: JSON.stringify(command),
    });
    if (!response.ok) throw new Error(await reasonOf(response));
  }

  // Calls `take` with each state until the stream ends or fails.
  async follow(take: (state: State) => void): Promise<void> {
    const body = (await this.get("events")).body;
    if (!body) return;
    const reader = body.pipeThrough(new TextDecoderStream()).getReader();
    let text = "";
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      text += value;
      const events = text.split("\n\n");
      text = events.pop() ?? "";
      // Of several that came together the last one tells all.
      const last = events.reverse().find((event) => event.startsWith("data:"));
      if (last) take(JSON.parse(last.slice(5)) as State);
    }
  }

  private async get(path: string): Promise<Response> {
    const response = await fetch(`/api/${path}`, { headers: { "X-Geolloyd-Token": this.token }, cache: "no-store" });
    if (!response.ok) throw new Error(await reasonOf(response));
    return response;
  }
}

async function reasonOf(response: Response): Promise<string> {
  const text = await response.text();
  try {
    return (JSON.parse(text) as { error: string }).error;
  } catch {
    return text.trim() || `The program answered ${response.status}.`;
  }
}
