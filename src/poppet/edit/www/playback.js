/* Time cursor: a slider, and a button that plays the run in the drawing. */

import { digits } from "./quantities.js";
import { text } from "./strings.js";

const WHOLE = 8;  // s in which a whole run is played

/* Elements of the time cursor. */
export class Playback {
  constructor(element, store) {
    Object.assign(this, { store, frame: 0 });
    this.button = element.appendChild(document.createElement("button"));
    Object.assign(this.button, { type: "button", onclick: () => this.toggle() });
    this.slider = element.appendChild(document.createElement("input"));
    Object.assign(this.slider, { type: "range", min: 0, max: 1, step: "any", value: 0, oninput: () => this.move() });
    this.slider.setAttribute("aria-label", text("curves.clock"));
    this.output = element.appendChild(document.createElement("output"));
    this.output.setAttribute("aria-live", "off");
    this.speed = element.appendChild(document.createElement("select"));
    this.speed.setAttribute("aria-label", text("curves.speed"));
    for (const name of ["whole", "real"]) this.speed.add(new Option(text(`curves.speed_${name}`), name));
    store.addEventListener("cursor", () => this.show());
    store.addEventListener("run", () => this.show());
    store.addEventListener("state", () => this.show());
    store.addEventListener("open", () => this.stop());
    this.stop();
  }

  get duration() { return this.store.run?.duration ?? 0; }

  move() {
    const time = Number(this.slider.value);
    this.stop();
    this.store.setCursor(time);
  }

  toggle() {
    if (this.frame) this.stop();
    else if (this.store.run) this.play();
  }

  play() {
    const { store, duration } = this;
    const start = store.cursor < duration * (1 - 1e-9) ? store.cursor : 0;
    const began = performance.now();
    const rate = this.speed.value === "real" ? 1 : duration / WHOLE;
    const step = now => {
      const time = start + Math.max(0, now - began) / 1000 * rate;
      if (time >= this.duration) this.stop();
      else this.frame = requestAnimationFrame(step);
      store.setCursor(Math.min(time, this.duration));
    };
    store.isPlaying = true;
    this.frame = requestAnimationFrame(step);
    this.button.textContent = text("curves.pause");
  }

  stop() {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.store.isPlaying = false;
    this.button.textContent = text("curves.play");
    this.show();
  }

  show() {
    const { duration, store } = this;
    const isEmpty = !Object.keys(store.state?.view.parts ?? {}).length;
    this.button.disabled = this.slider.disabled = !store.run || isEmpty;
    this.slider.max = duration || 1;
    this.slider.step = (duration || 1) / 1000;
    this.slider.value = store.cursor;
    const shown = digits(store.cursor, duration || 1);
    this.output.textContent = text("curves.cursor", { time: shown });
    this.slider.setAttribute("aria-valuetext", this.output.textContent);
  }
}
