/* Small plot with points that can be dragged, or moved by the arrow keys. */

import { text } from "./strings.js";
import { shown } from "./units.js";

const SVG = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [300, 130];
const MARGIN = { left: 8, right: 8, top: 16, bottom: 18 };
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

/* Plot of a curve. `moved(index, x, y)` is called while a point is dragged, `added(x, y)` by a double click; `name(index)`
   is the accessible name of a point. */
export class CurvePlot {
  constructor({ label, moved = null, added = null, name = () => "" }) {
    Object.assign(this, { moved, added, name, points: [], handles: [], drag: null });
    this.svg = node("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "curve-plot", role: "group", "aria-label": label });
    this.frame = node("rect", {
      class: "frame", x: MARGIN.left, y: MARGIN.top, width: WIDTH - MARGIN.left - MARGIN.right, height: HEIGHT - MARGIN.top - MARGIN.bottom,
    });
    this.curve = node("path", { class: "curve" });
    this.labels = ["start", "start", "end", "start"].map((anchor, k) => node("text", { class: `label label-${k}`, "text-anchor": anchor }));
    this.points_group = node("g", {});
    this.svg.append(this.frame, this.curve, ...this.labels, this.points_group);
    if (added) this.svg.addEventListener("dblclick", event => { if (!this.drag) added(...this.#at(event)); });
    this.svg.addEventListener("pointermove", event => this.#onMove(event));
    for (const type of ["pointerup", "pointercancel"]) this.svg.addEventListener(type, () => this.#end());
  }

  /* Draw a curve through points [x, y]; `handles` are the points that can be moved. */
  draw(points, handles, { x = "", y = "" } = {}) {
    Object.assign(this, { points, handles, units: { x, y } });
    if (!this.drag) this.#scale();
    const path = points.filter(point => point.every(Number.isFinite)).map(point => this.#place(point).map(v => v.toFixed(1)).join(" "));
    this.curve.setAttribute("d", path.length ? `M${path.join("L")}` : "");
    this.#drawLabels();
    this.#drawHandles();
  }

  #scale() {
    const columns = [0, 1].map(k => [...this.points, ...this.handles].map(point => point[k]).filter(Number.isFinite));
    this.range = columns.map(values => {
      const [low, high] = values.length ? [Math.min(...values), Math.max(...values)] : [0, 1];
      return low < high ? [low, high] : [low - (Math.abs(low) || 1) / 2, high + (Math.abs(high) || 1) / 2];
    });
  }

  #place([x, y]) {
    const [[left, right], [low, high]] = this.range;
    return [
      MARGIN.left + (x - left) / (right - left) * (WIDTH - MARGIN.left - MARGIN.right),
      HEIGHT - MARGIN.bottom - (y - low) / (high - low) * (HEIGHT - MARGIN.top - MARGIN.bottom),
    ];
  }

  #drawLabels() {
    const [[left, right], [low, high]] = this.range;
    const { x, y } = this.units;
    const [l, r, b, t] = [rounded(left, right - left), rounded(right, right - left), rounded(low, high - low), rounded(high, high - low)];
    const content = [`${t} ${y}`, l, `${r} ${x}`, `${b} ${y}`];
    const places = [[MARGIN.left, 11], [MARGIN.left, HEIGHT - 4], [WIDTH - MARGIN.right, HEIGHT - 4], [MARGIN.left + 3, HEIGHT - MARGIN.bottom - 3]];
    this.labels.forEach((label, k) => {
      label.setAttribute("x", places[k][0]);
      label.setAttribute("y", places[k][1]);
      label.textContent = content[k].trim();
    });
  }

  #drawHandles() {
    const present = this.points_group.children;
    while (present.length > this.handles.length) present[present.length - 1].remove();
    while (present.length < this.handles.length) this.points_group.append(this.#handle(present.length));
    this.handles.forEach((point, k) => {
      const [x, y] = this.#place(point);
      present[k].setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
      present[k].setAttribute("aria-label", this.name(k));
    });
  }

  #handle(index) {
    const group = node("g", { class: "handle", tabindex: 0, role: "button", "aria-roledescription": text("signals.point") });
    group.append(node("circle", { class: "hit", r: 12 }), node("circle", { class: "dot", r: 4.5 }));
    group.addEventListener("pointerdown", event => {
      event.preventDefault();
      group.focus();
      this.svg.setPointerCapture(event.pointerId);
      this.drag = { index };
    });
    group.addEventListener("keydown", event => this.#onKey(event, index));
    return group;
  }

  #at(event) {
    const box = this.svg.getScreenCTM().inverse();
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(box);
    const [[left, right], [low, high]] = this.range;
    return [
      snapped(left + (x - MARGIN.left) / (WIDTH - MARGIN.left - MARGIN.right) * (right - left), right - left),
      snapped(low + (HEIGHT - MARGIN.bottom - y) / (HEIGHT - MARGIN.top - MARGIN.bottom) * (high - low), high - low),
    ];
  }

  #onMove(event) { if (this.drag) this.#move(this.drag.index, ...this.#at(event)); }

  #end() {
    if (!this.drag) return;
    this.drag = null;
    this.draw(this.points, this.handles, this.units);
  }

  #onKey(event, index) {
    const direction = KEYS[event.key];
    if (!direction || event.ctrlKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const size = event.shiftKey ? 10 : 1;
    const [x, y] = this.handles[index].map((value, k) => value + direction[k] * size * stepOf(this.range[k][1] - this.range[k][0]));
    this.#move(index, ...[x, y].map((value, k) => snapped(value, this.range[k][1] - this.range[k][0])));
  }

  /* Move a point between its neighbours. */
  #move(index, x, y) {
    const [before, after] = [this.handles[index - 1], this.handles[index + 1]];
    const gap = stepOf(this.range[0][1] - this.range[0][0]);
    const place = Math.min(Math.max(x, before ? before[0] + gap : -Infinity), after ? after[0] - gap : Infinity);
    this.moved?.(index, Number(place.toPrecision(12)), y);
  }
}

function rounded(value, span) { return Math.abs(value) < 2e-3 * span ? "0" : shown(value, 3); }

function stepOf(span) { return 10 ** Math.floor(Math.log10(span / 40)); }

function snapped(value, span) {
  const step = stepOf(span);
  return Number((Math.round(value / step) * step).toPrecision(12));
}

function node(name, attributes) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}
