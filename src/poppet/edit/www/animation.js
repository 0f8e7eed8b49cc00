/* State of the last run at the cursor: pistons and spools, flow arrows, colours of pressures, and values beside parts. */

import { colourOf } from "./colours.js";
import { entryOf, targetOf } from "./connections.js";
import { portFlows, pressureSeries } from "./flows.js";
import { plainValue } from "./field_values.js";
import { CHAMBERS, MOTIONS } from "./motions.js";
import { digits, displayOf, prettyUnit } from "./quantities.js";
import { htmlElement, svgElement } from "./symbols.js";
import { text } from "./strings.js";
import { siOf } from "./units.js";

const AMBIENT = 1e5;  // Pa, where the model does not tell another pressure
const LEAST_FLOW = 0.004;  // fraction of the largest flow below which there is no arrow
const LEAST_SPAN = 0.5;  // of values, which therefore have at most three decimals
const VALUES = ["pressure", "piston_position", "opening", "shaft.position", "position", "mass_flow_rate", "command"];
const OUTWARD = { left: [-1, 0], right: [1, 0], top: [0, -1], bottom: [0, 1] };

export class Animation {
  constructor(drawing) {
    Object.assign(this, { drawing, movers: new Map(), arrows: new Map(), isAsked: false });
    this.dark = matchMedia("(prefers-color-scheme: dark)");
    this.dark.addEventListener("change", () => this.later());
    this.legend = htmlElement("div", { className: "pressure-legend", hidden: true }, drawing.svg.parentElement);
    [this.low, this.bar, this.high] = ["span", "i", "span"].map(tag => htmlElement(tag, {}, this.legend));
  }

  /* The circuit has changed. */
  changed() {
    this.run = null;
    this.later();
  }

  /* Show the state with the next picture of the screen. */
  later() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => { this.isAsked = false; this.show(); });
  }

  /* Show the state at the cursor. */
  show() {
    const { drawing } = this, { store } = drawing, { run } = store;
    drawing.svg.classList.toggle("is-stale", store.isStale);
    this.legend.hidden = !run;
    if (!run) { this.#clear(); return; }
    if (run !== this.run) this.#prepare(run);
    this.#find(store.cursor);
    for (const item of drawing.items.values()) this.#showPart(item);
    this.#showFlows();
    this.#showPressures();
  }

  #clear() {
    if (!this.movers.size && !this.arrows.size) return;
    for (const arrow of this.arrows.values()) arrow.remove();
    this.movers.clear();
    this.arrows.clear();
    for (const item of this.drawing.items.values()) {
      item.value.textContent = "";
      item.reset();
    }
  }

  /* Names, ranges and ports of a new run. */
  #prepare(run) {
    const { drawing } = this, { view } = drawing;
    this.run = run;
    this.names = [...run.series.keys()];
    this.units = new Map(run.columns.map(({ name, unit }) => [name, unit]));
    this.ranges = new Map();
    const parts = Object.keys(view.parts);
    this.flows = new Map(parts.flatMap(name => [...portFlows(view, name, this.names)]));
    this.mostFlow = Math.max(1e-12, ...[...this.flows.values()].flat().map(([series]) => this.#most(series)));
    this.ambient = drawing.store.header?.numbers?.["ambient.pressure"]?.value ?? AMBIENT;
    const pressures = this.names.filter(name => /(^|\.)pressure$/.test(name)).map(name => this.#range(name));
    this.pressures = [Math.min(this.ambient, ...pressures.map(([low]) => low)), Math.max(this.ambient + 1e5, ...pressures.map(([, high]) => high))];
    this.values = new Map(parts.map(name => [name, VALUES.map(local => `${name}.${local}`).find(series => this.#isShown(series))]));
    this.#showLegend();
  }

  #isShown(series) {
    return this.run.series.has(series) && (this.units.get(series) !== "1" || series.endsWith(".command"));
  }

  /* Least and largest value of a series. */
  #range(series) {
    if (!this.ranges.has(series)) {
      let low = Infinity, high = -Infinity;
      for (const value of this.run.series.get(series) ?? []) { low = Math.min(low, value); high = Math.max(high, value); }
      this.ranges.set(series, [low, high]);
    }
    return this.ranges.get(series);
  }

  #most(series) {
    const [low, high] = this.#range(series);
    return Math.max(Math.abs(low), Math.abs(high));
  }

  /* Rows before and after a time, and the fraction between them. */
  #find(time) {
    const { time: times } = this.run;
    let low = 0, high = Math.max(0, times.length - 1);
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= time) low = middle;
      else high = middle;
    }
    const width = times[high] - times[low];
    this.at = [low, high, width > 0 ? Math.max(0, Math.min(1, (time - times[low]) / width)) : 0];
  }

  /* Value of a series at the cursor, or undefined. */
  value(series) {
    const values = this.run.series.get(series), [low, high, part] = this.at;
    if (!values?.length) return undefined;
    return values[low] + (values[high] - values[low]) * part;
  }

  /* --- Parts --- */

  #showPart(item) {
    const { name } = item, series = this.values.get(name), value = series && this.value(series);
    const words = this.#step(name) ?? (value === undefined ? "" : this.#words(series, value));
    if (item.value.textContent !== words) item.value.textContent = words;
    const mover = this.#mover(item);
    if (!mover.move) return;
    mover.move(mover.context);
    mover.move.fills?.forEach((fill, k) => this.#fill(fill, this.value(`${name}.${CHAMBERS[mover.kind][k]}.pressure`)));
  }

  #words(series, value) {
    const { unit, from } = displayOf(this.units.get(series) ?? "1", this.drawing.store.units), [low, high] = this.#range(series).map(from);
    return `${digits(from(value), Math.max(LEAST_SPAN, Math.abs(low), Math.abs(high)))} ${prettyUnit(unit)}`.trim();
  }

  /* Name of the active step of a sequence. */
  #step(name) {
    const { steps } = this.drawing.view.parts[name]?.fields ?? {}, number = this.value(`${name}.step`);
    return steps && number !== undefined ? Object.keys(steps)[Math.round(number) - 1] : undefined;
  }

  /* Motion of the symbol of a part, made anew when the symbol is. */
  #mover(item) {
    const { name, strokes } = item, { kind, fields } = this.drawing.view.parts[name] ?? {};
    let mover = this.movers.get(name);
    if (mover?.strokes === strokes) return mover;
    mover = { strokes, kind, move: entryOf(MOTIONS, kind)?.(strokes, fields), context: this.#context(item) };
    this.movers.set(name, mover);
    return mover;
  }

  #context(item) {
    const { name } = item;
    const series = local => this.value(`${name}.${local}`);
    const share = (local, size) => {
      const value = series(local);
      if (value === undefined) return undefined;
      const whole = size && this.#sizeOf(name, size);
      const [low, high] = whole > 0 ? [0, whole] : this.#range(`${name}.${local}`);
      return high > low ? (value - low) / (high - low) : 0;
    };
    share.most = local => Math.max(1e-12, this.#most(`${name}.${local}`));
    return { series, share, item };
  }

  /* Length of a part: of the model, or as typed; otherwise undefined. */
  #sizeOf(name, field) {
    const { store, view } = this.drawing;
    return store.header?.numbers?.[`${name}.${field}`]?.value ?? siOf(plainValue(view.parts[name]?.fields[field]), "m", store.units);
  }

  /* --- Flows --- */

  #showFlows() {
    const seen = new Set();
    for (const [address, terms] of this.flows) {
      const [end] = this.drawing.endsAt(address);
      if (!end) continue;
      seen.add(address);
      const flow = terms.reduce((sum, [series, sign]) => sum + sign * (this.value(series) ?? 0), 0);
      this.#arrow(address, end, flow / this.mostFlow);
    }
    for (const [address, arrow] of this.arrows) {
      if (!seen.has(address)) { arrow.remove(); this.arrows.delete(address); }
    }
  }

  /* Arrow on the wire of a port, or outside a port without one, in the direction of the flow; its size follows the square
     root of the flow. */
  #arrow(address, end, strength) {
    if (!this.arrows.has(address)) this.arrows.set(address, svgElement("path", { class: "flow", d: "M0.9 0L-0.6 0.75L-0.3 0L-0.6 -0.75Z" }, this.drawing.arrowLayer));
    const arrow = this.arrows.get(address), isSeen = Math.abs(strength) > LEAST_FLOW;
    arrow.style.display = isSeen ? "" : "none";
    if (!isSeen) return;
    const onWire = this.drawing.wires.arrow(address), { x, y, angle } = onWire?.length >= 2 ? onWire : besidePort(end);
    const size = 0.4 + 0.5 * Math.sqrt(Math.min(1, Math.abs(strength)));
    arrow.setAttribute("transform", `translate(${x} ${y}) rotate(${angle + (strength < 0 ? 180 : 0)}) scale(${size.toFixed(3)})`);
  }

  /* --- Pressures --- */

  #showPressures() {
    const { drawing } = this, { view } = drawing;
    for (const wire of drawing.wireLayer.querySelectorAll("[data-wire]")) {
      const [end] = drawing.endsAt(wire.dataset.wire), pressure = end && this.#pressureAt(end, view);
      if (pressure === undefined) wire.style.removeProperty("--flow-colour");
      else wire.style.setProperty("--flow-colour", this.#colour(pressure));
    }
    for (const item of drawing.items.values()) {
      if (!item.ends.some(end => !end.port && end.type === "store")) continue;
      for (const stroke of item.strokes.filter(one => one.classList.contains("outline"))) this.#fill(stroke, this.value(`${item.name}.pressure`));
    }
  }

  /* Pressure in the wire that begins at a port or at the end of a tube, or undefined. */
  #pressureAt(end, view) {
    const target = end.type === "tube" ? end.address : end.type === "port" ? targetOf(view, end) : undefined;
    if (target === undefined) return undefined;
    const series = pressureSeries(view, target, this.names);
    return series === null ? this.ambient : this.value(series);
  }

  #share(pressure) {
    const [low, high] = this.pressures;
    return (pressure - low) / (high - low);
  }

  #colour(pressure) {
    return colourOf(this.#share(pressure), this.dark.matches);
  }

  #fill(shape, pressure) {
    if (pressure === undefined) shape.style.removeProperty("fill");
    else shape.style.fill = `color-mix(in srgb, ${this.#colour(pressure)} ${Math.round(25 + 45 * this.#share(pressure))}%, var(--inside))`;
  }

  #showLegend() {
    const { unit, from } = displayOf("Pa", this.drawing.store.units), [low, high] = this.pressures.map(from);
    const stops = [0, 1, 2, 3, 4, 5, 6].map(k => colourOf(k / 6, this.dark.matches));
    this.bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
    [this.low.textContent, this.high.textContent] = [digits(low, high), `${digits(high, high)} ${prettyUnit(unit)}`];
    this.legend.title = text("drawing.legend");
    this.legend.setAttribute("aria-label", text("drawing.legend"));
  }
}

/* Anchor of an arrow outside a port, directed away from it. */
function besidePort({ x, y, side }) {
  const [dx, dy] = OUTWARD[side];
  return { x: x + 1.1 * dx, y: y + 1.1 * dy, angle: Math.atan2(dy, dx) * 180 / Math.PI };
}
