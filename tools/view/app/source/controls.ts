// The controls of a session.
import type { Choice, Command, State } from "./api";
import { button, byId, choices, labelled, make, numberInput } from "./dom";
import type { Viewer } from "./viewer";

const choiceNames: [Choice, string][] = [["graph", "Graph"], ["norm", "Norm"], ["field", "Tangent field"], ["init", "First seeds"], ["greedy", "Greedy phase"]];

export type ClickAction = "pick" | "add" | "remove";

export class SessionControls {
  clickAction: ClickAction = "pick";
  private readonly section = byId("live");
  private readonly selects = new Map<Choice, HTMLSelectElement>();
  private readonly seedCount = numberInput(1);
  private readonly randomSeed = numberInput(0);
  private readonly nodeId = numberInput(0);
  private readonly vertices = numberInput(4);
  // What waits while the program is at work, and what only makes sense then.
  private readonly idle: (HTMLButtonElement | HTMLInputElement | HTMLSelectElement)[] = [];
  private readonly busy: HTMLButtonElement[] = [];
  private readonly saves: HTMLButtonElement[] = [];
  private readonly result = make("div");

  constructor(private readonly viewer: Viewer, private readonly send: (command: Command) => void) {
    const run = byId("run");
    run.hidden = this.section.hidden = false;
    run.append(...this.relaxationPart());
    this.section.append(this.startPart(), this.seedPart(), this.resultPart(), this.result);
  }

  show(state: State): void {
    for (const [choice, select] of this.selects) {
      const values = state.choices[choice] ?? [];
      if (select.options.length !== values.length) select.replaceChildren(...values.map((value) => make("option", { value }, value)));
      if (document.activeElement !== select || !state.running) select.value = state.options[choice];
    }
    this.setNumber(this.seedCount, state.options.seed_count);
    this.setNumber(this.randomSeed, state.options.random_seed);
    if (this.vertices.value === "") this.vertices.value = String(Math.max(4, state.seeds));
    const isBusy = state.task !== null || state.running;
    for (const control of this.idle) control.disabled = isBusy;
    for (const control of this.busy) control.disabled = !isBusy;
    for (const save of this.saves) {
      save.disabled = isBusy || state.output === null;
      save.title = state.output === null ? "Start with --output FOLDER to save there" : `Into ${state.output}`;
    }
    this.result.replaceChildren(...resultLines(state));
  }

  disable(): void {
    for (const control of [...this.idle, ...this.busy, ...this.saves]) control.disabled = true;
  }

  private startPart(): HTMLElement {
    const part = make("div", {}, make("h2", {}, "Start"));
    for (const [choice, name] of choiceNames) {
      const select = make("select", { name: choice });
      select.addEventListener("change", () => this.send({ do: "set", [choice]: select.value }));
      this.selects.set(choice, select);
      this.idle.push(select);
      part.append(labelled(name, select));
    }
    for (const [key, name, input] of [["seed_count", "Seeds", this.seedCount], ["random_seed", "Random number", this.randomSeed]] as const) {
      input.name = key;
      input.addEventListener("change", () => {
        if (input.checkValidity() && input.value !== "") this.send({ do: "set", [key]: input.valueAsNumber });
      });
      this.idle.push(input);
      part.append(labelled(name, input));
    }
    part.append(this.row(this.command("Choose seeds", "choose_seeds", "Choose the first seeds anew")));
    return part;
  }

  private seedPart(): HTMLElement {
    const part = make("div", {}, make("h2", {}, "Seeds"));
    part.append(choices<ClickAction>("A click", "click", [["pick", "picks"], ["add", "adds a seed"], ["remove", "removes a seed"]], "pick", (action) => {
      this.clickAction = action;
    }));
    part.append(make("p", { class: "note" }, "Drag a seed to move it."));
    const add = this.press("Add seed there", () => {
      if (this.nodeId.value !== "") this.send({ do: "add_seed", id: this.nodeId.valueAsNumber });
    });
    const move = this.press("Move picked there", () => {
      const region = this.viewer.look.picked;
      if (region !== null && this.nodeId.value !== "") this.send({ do: "move_seed", region, id: this.nodeId.valueAsNumber });
    });
    const remove = this.press("Remove picked", () => {
      const region = this.viewer.look.picked;
      if (region !== null) this.send({ do: "remove_seed", region });
    });
    part.append(make("details", {}, make("summary", {}, "Without a pointer"), labelled("Vertex or triangle", this.nodeId), this.row(add, move, remove)));
    return part;
  }

  private relaxationPart(): HTMLElement[] {
    const run = this.command("Run", "run", "Relax until no seed moves");
    run.classList.add("main");
    const pause = button("Pause", () => this.send({ do: "pause" }), "Stop after this step");
    this.busy.push(pause);
    return [make("h2", {}, "Relaxation"),
      this.row(run, pause, this.command("Reset", "reset", "Back to the first seeds")),
      this.row(this.command("Greedy step", "greedy_step"), this.command("Macrostep", "macrostep"), this.command("Microstep", "microstep"))];
  }

  private resultPart(): HTMLElement {
    const part = make("div", {}, make("h2", {}, "Results"));
    const remesh = this.press("Remesh", () => {
      if (this.vertices.checkValidity() && this.vertices.value !== "") this.send({ do: "remesh", vertices: this.vertices.valueAsNumber });
    }, "The most regular remesh with so many vertices");
    const stop = button("Stop", () => this.send({ do: "stop" }), "End the work with what there is");
    this.busy.push(stop);
    const save = (text: string, what: string) => {
      const made = button(text, () => this.send({ do: "save", what }));
      this.saves.push(made);
      return made;
    };
    part.append(this.row(this.command("Ground truth", "truth", "Regions by distance through space"), this.command("Dual", "dual", "The dual mesh of the regions")));
    part.append(labelled("Vertices of a remesh", this.vertices), this.row(remesh, stop));
    part.append(this.row(save("Save result", "result"), save("Save picture", "picture"), save("Save page", "page")));
    return part;
  }

  private press(text: string, press: () => void, title = ""): HTMLButtonElement {
    const made = button(text, press, title);
    this.idle.push(made);
    return made;
  }

  private command(text: string, name: string, title = ""): HTMLButtonElement {
    return this.press(text, () => this.send({ do: name }), title);
  }

  private row(...buttons: HTMLElement[]): HTMLElement {
    return make("div", { class: "row" }, ...buttons);
  }

  private setNumber(input: HTMLInputElement, value: number): void {
    if (document.activeElement !== input) input.value = String(value);
  }
}

function resultLines(state: State): HTMLElement[] {
  const lines: HTMLElement[] = [];
  const add = (name: string, text: string | null | undefined) => {
    if (text) lines.push(make("p", { class: "note" }, `${name} `, make("code", {}, text)));
  };
  add("Fingerprint", state.fingerprint);
  add("The same by", state.command_line);
  add("Fingerprint of the remesh", state.remesh?.fingerprint);
  add("The same by", state.remesh?.command_line);
  return lines;
}
