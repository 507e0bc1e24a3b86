// A session: the program computes, this shows its state. Nothing is kept here that a reloaded page would lose.
import { Api, Command, State } from "./api";
import { SessionControls } from "./controls";
import { byId, countText, numberText, say } from "./dom";
import { showFacts, showFigures } from "./figures";
import { showLayers } from "./layers";
import { expose } from "./page";
import { plotEnergy } from "./plot";
import { followPointer } from "./pointer";
import { Viewer } from "./viewer";

// Commands whose work is seen on the mesh, not on its dual or remesh.
const changesMesh = new Set(["set", "add_seed", "remove_seed", "move_seed", "choose_seeds", "greedy_step", "microstep", "macrostep", "run", "reset", "truth", "remesh"]);
const retries = 5;
const retryAfter = 1000;  // milliseconds

export async function startSession(): Promise<void> {
  const token = location.hash.slice(1);
  if (!token) throw new Error("The address lacks its key: open the one that geolloyd view printed.");
  const api = new Api(token);
  const state = await api.state();
  // Regions before the first frame: a mesh without them would be drawn for nothing.
  const [mesh, regions] = await Promise.all([api.bundle("mesh"), api.bundle("layer/regions")]);
  const viewer = new Viewer(byId<HTMLCanvasElement>("canvas"), mesh);
  viewer.add(regions);
  const session = new Session(api, viewer, { regions: state.layers.regions });
  await session.take(state);
  expose(viewer);
  await session.follow();
}

class Session {
  private readonly controls: SessionControls;
  private readonly revisions: Map<string, number>;  // of the layers that are shown
  private state: State | null = null;
  private isFetching = false;

  constructor(private readonly api: Api, private readonly viewer: Viewer, shown: Record<string, number>) {
    this.revisions = new Map(Object.entries(shown));
    const send = (command: Command) => this.send(command);
    this.controls = new SessionControls(viewer, send);
    showLayers(viewer);
    showFigures(viewer);
    viewer.addEventListener("look", () => void this.fetchLayers());
    followPointer(viewer, {
      click: (hit) => this.click(hit),
      drop: (region, id) => send({ do: "move_seed", region, id }),
    });
  }

  async follow(): Promise<void> {
    for (let failures = 0; failures < retries; ++failures) {
      try {
        await this.api.follow((state) => {
          failures = 0;
          void this.take(state);
        });
      } catch {
        // Said below, if it stays so.
      }
      say("Connecting again", true);
      await new Promise((done) => setTimeout(done, retryAfter));
    }
    say("The program has ended. Results that were saved are in its output folder.", true);
    this.controls.disable();
  }

  async take(state: State): Promise<void> {
    const earlier = this.state;
    this.state = state;
    const { mesh } = state;
    byId("title").textContent = mesh.name;
    document.title = `${mesh.name} - geolloyd`;
    this.controls.show(state);
    plotEnergy(state.energies);
    showFacts(factsOf(state), []);
    if (state.message?.kind === "error") say(state.message.text, true);
    else say(state.task?.text ?? state.message?.text ?? "");
    const offered = Object.keys(state.layers);
    if (earlier) this.showNew(offered.filter((layer) => state.layers[layer] > (earlier.layers[layer] ?? -1)));
    if (offered.join() !== [...this.viewer.offered].join()) {
      this.viewer.offered = new Set(offered);
      for (const layer of this.revisions.keys()) {
        if (layer in state.layers) continue;
        this.revisions.delete(layer);
        this.viewer.forget(layer);
      }
      this.viewer.dispatchEvent(new Event("layers"));
    }
    await this.fetchLayers();
  }

  // One at a time, and again while there are newer ones: what comes late is what is newest.
  private async fetchLayers(): Promise<void> {
    if (this.isFetching) return;
    this.isFetching = true;
    try {
      for (let layer = this.wanted(); layer !== undefined; layer = this.wanted()) {
        this.revisions.set(layer, this.state!.layers[layer]);
        const bundle = await this.api.bundle(`layer/${layer}`);
        this.viewer.add(bundle, layer === "dual" ? "dual" : "remesh");
      }
    } catch (error) {
      say((error as Error).message, true);
    } finally {
      this.isFetching = false;
    }
  }

  private wanted(): string | undefined {
    const { look } = this.viewer;
    const shown: Record<string, boolean> = {
      regions: true, sites: true, trees: look.trees, field: look.field, truth: look.colouring === "truth",
      dual: look.shown === "dual", remesh: look.shown === "remesh",
    };
    const layers = this.state?.layers ?? {};
    return Object.keys(layers).find((name) => shown[name] && layers[name] > (this.revisions.get(name) ?? -1));
  }

  // What has just been made is what its maker wants to see.
  private showNew(layers: string[]): void {
    const { look } = this.viewer;
    if (layers.includes("truth")) look.colouring = "truth";
    for (const shown of ["dual", "remesh"] as const) if (layers.includes(shown)) look.shown = shown;
    if (layers.some((layer) => layer in { truth: 0, dual: 0, remesh: 0 })) this.viewer.dispatchEvent(new Event("layers"));
  }

  private click(hit: { node: number; region: number | null } | null): void {
    const action = this.controls.clickAction;
    if (action === "add") {
      if (hit) this.send({ do: "add_seed", id: hit.node });
    } else if (action === "remove") {
      if (hit && hit.region !== null) this.send({ do: "remove_seed", region: hit.region });
    } else {
      this.viewer.pick(hit?.region ?? null);
    }
  }

  private send(command: Command): void {
    if (changesMesh.has(command.do) && this.viewer.look.shown !== "mesh") {
      this.viewer.set({ shown: "mesh" });
      this.viewer.dispatchEvent(new Event("layers"));
    }
    this.api.command(command).catch((error: Error) => {
      say(error.message, true);
      // What was changed here only, such as a seed under the pointer, goes back.
      this.revisions.delete("regions");
      void this.fetchLayers();
    });
  }
}

function factsOf(state: State): [string, string][] {
  const facts: [string, string][] = [
    ["vertices", countText(state.mesh.vertices)],
    ["triangles", countText(state.mesh.triangles)],
    ["seeds", countText(state.seeds)],
    ["phase", state.phase],
    ["steps", countText(state.step)],
    ["energy", numberText(state.energy)],
  ];
  if (state.moving > 0) facts.push(["seeds moving", countText(state.moving)]);
  if (state.remesh) {
    facts.push(["remesh", `${countText(state.remesh.vertices)} vertices`], ["iteration", countText(state.remesh.iteration)]);
    facts.push(["energy of hexagons", numberText(state.remesh.energy_ratio)]);
  }
  return facts;
}
