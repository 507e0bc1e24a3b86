// Small helpers for plain HTML: labels belong to their controls, so that keyboards and screen readers reach them.

export function byId<T extends HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (!element) throw new Error(`The page has no #${id}.`);
  return element as T;
}

type Content = Node | string;

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Record<string, string> = {}, ...content: Content[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...content);
  return element;
}

export function labelled(text: string, control: HTMLElement, after = true): HTMLLabelElement {
  const name = make("span", {}, text);
  const label = make("label", after ? {} : { class: "check" });
  label.append(...(after ? [name, control] : [control, name]));
  return label;
}

export function check(text: string, isOn: boolean, change: (isOn: boolean) => void): HTMLLabelElement {
  const box = make("input", { type: "checkbox" });
  box.checked = isOn;
  box.addEventListener("change", () => change(box.checked));
  return labelled(text, box, false);
}

// One of several; a choice is [value, text].
export function choices<T extends string>(legend: string, name: string, values: [T, string][], now: T, change: (value: T) => void): HTMLFieldSetElement {
  const set = make("fieldset", { class: "choices" }, make("legend", {}, legend));
  for (const [value, text] of values) {
    const button = make("input", { type: "radio", name, value });
    button.checked = value === now;
    button.addEventListener("change", () => change(value));
    set.append(labelled(text, button, false));
  }
  return set;
}

export function button(text: string, press: () => void, title = ""): HTMLButtonElement {
  const made = make("button", { type: "button" }, text);
  if (title) made.title = title;
  made.addEventListener("click", press);
  return made;
}

export function numberInput(min: number, value: number | "" = "", max?: number): HTMLInputElement {
  const input = make("input", { type: "number", min: String(min), step: "1", value: String(value) });
  if (max !== undefined) input.max = String(max);
  return input;
}

export function definitions(rows: [string, string][]): HTMLDListElement {
  const list = make("dl");
  for (const [name, text] of rows) list.append(make("dt", {}, name), make("dd", {}, text));
  return list;
}

export function say(text: string, isError = false): void {
  const status = byId("status");
  status.classList.toggle("error", isError);
  if (status.textContent !== text) status.textContent = text;
}

export function countText(n: number): string {
  return n.toLocaleString("en-US");
}

export function numberText(value: number): string {
  return value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6) ? String(Number(value.toPrecision(5))) : value.toExponential(3);
}

export function save(blob: Blob, name: string): void {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
