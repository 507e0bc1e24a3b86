// The frames of a relaxation: a slider, and a button that plays them.
import { button, byId, labelled, make, numberText, say } from "./dom";
import type { Bundle } from "./bundle";
import { plotEnergy } from "./plot";
import type { Viewer } from "./viewer";

const framesPerSecond = 4;

export function showTimeline(viewer: Viewer, bundle: Bundle): void {
  const { frames } = bundle.header;
  if (frames.length === 0) return;
  const section = byId("timeline");
  section.hidden = false;
  const slider = make("input", { type: "range", min: "0", max: String(frames.length - 1), value: String(frames.length - 1), step: "1" });
  const label = make("p", { class: "note", id: "frame" });
  let timer = 0;
  const show = (index: number) => {
    const frame = frames[index];
    slider.value = String(index);
    const text = `${frame.label}, energy ${numberText(frame.energy)}`;
    label.textContent = text;
    slider.setAttribute("aria-valuetext", text);
    viewer.setRegions(bundle.ids(frame.region), bundle.places(frame.seeds), bundle.per(frame.region));
    plotEnergy(frames.map(({ energy }) => energy), index);
  };
  const stop = () => {
    window.clearInterval(timer);
    timer = 0;
    play.textContent = "Play";
  };
  const play = button("Play", () => {
    if (timer !== 0) return stop();
    if (slider.valueAsNumber === frames.length - 1) show(0);
    play.textContent = "Pause";
    timer = window.setInterval(() => {
      if (slider.valueAsNumber === frames.length - 1) return stop();
      show(slider.valueAsNumber + 1);
    }, 1000 / framesPerSecond);
  });
  slider.addEventListener("input", () => {
    stop();
    show(slider.valueAsNumber);
    say(label.textContent ?? "");
  });
  section.append(make("h2", {}, "Timeline"), labelled("Step", slider), label, make("div", { class: "row" }, play));
  show(frames.length - 1);
}
