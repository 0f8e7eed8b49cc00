/* One plot of curves with the same unit. */

import { digits, displayOf, noiseOf, prettyUnit, quantityName, valueAt } from "./quantities.js";
import { text } from "./strings.js";

const COLOURS = 8;
const AREAS = { now: "40", kept: "18" };  // opacity of a band, hexadecimal
const LOWEST = 90;  // px
const DASH_KEPT = [6, 4];
const DASH_MEASURED = [2, 3];

let palette = null;
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { palette = null; });

/* Colours of the style sheet, which a canvas cannot use by name. */
function colours() {
  if (palette) return palette;
  const style = getComputedStyle(document.documentElement);
  const value = name => style.getPropertyValue(name).trim();
  const curves = Array.from({ length: COLOURS }, (_, k) => value(`--curve-${k + 1}`));
  palette = { curves, ink: value("--ink"), soft: value("--soft"), line: value("--line") };
  return palette;
}

/* A plot of columns with one SI unit: present curves, those of the kept run (dashed) and measured ones (dotted). */
export class Plot {
  constructor(parent, unit, store) {
    Object.assign(this, { unit, store, lines: [], zoom: null, end: 1 });
    this.display = displayOf(unit, store.units);
    this.noise = Math.abs(this.display.from(noiseOf(unit)) - this.display.from(0));
    this.element = parent.appendChild(document.createElement("figure"));
    this.element.className = "plot";
    this.caption = this.element.appendChild(document.createElement("figcaption"));
    this.title = this.caption.appendChild(document.createElement("b"));
    const shown = prettyUnit(this.display.unit);
    this.title.textContent = shown ? `${quantityName(unit)} [${shown}]` : quantityName(unit);
    this.legend = this.caption.appendChild(document.createElement("span"));
    this.legend.className = "legend";
    this.place = this.element.appendChild(document.createElement("div"));
    this.place.setAttribute("role", "img");
    this.clock = document.createElement("div");
    this.clock.className = "clock-line";
  }

  /* Select the lines: {name, label, role: "now" | "kept" | "measured", isStep, isSelected, colour, edge}. The edges of a
     band follow each other: "low", "high". */
  setLines(lines, size) {
    this.lines = lines;
    this.zoom = null;
    this.u?.destroy();
    this.u = new uPlot(this.options(lines, size), [[0], ...lines.map(() => [null])], this.place);
    this.u.over.append(this.clock);
    this.u.over.addEventListener("pointermove", event => this.point(event));
    this.u.over.addEventListener("pointerdown", event => this.point(event));
    this.u.over.addEventListener("dblclick", () => { this.zoom = null; });
    this.showLegend();
  }

  options(lines, { width, height }) {
    const line = () => colours().line;
    const axis = { stroke: () => colours().soft, grid: { stroke: line, width: 1 }, ticks: { stroke: line }, font: "12px sans-serif" };
    return {
      width, height, pxAlign: false, padding: [6, 10, 0, 0], legend: { show: false },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, y: false } },
      scales: { x: { time: false, range: (u, low, high) => this.rangeX(low, high) }, y: { range: (u, low, high) => rangeY(low, high, this.noise) } },
      axes: [
        { ...axis, size: 26, space: 50 },
        {
          ...axis, space: 26, size: (u, labels) => widthOf(labels ?? []),
          values: (u, ticks, index, space, step) => ticks.map(tick => plain(tick, step)),
        },
      ],
      series: [{}, ...lines.map(line => ({
        stroke: () => colours().curves[line.colour % COLOURS], width: (line.isSelected ? 2.4 : 1.4) * (line.edge ? .7 : 1), spanGaps: true, points: { show: false },
        dash: { now: [], kept: DASH_KEPT, measured: DASH_MEASURED }[line.role],
        paths: line.isStep ? uPlot.paths.stepped({ align: 1 }) : linePath,
      }))],
      hooks: { drawAxes: [u => this.paintBands(u)], setSelect: [u => this.setZoom(u)], setScale: [(u, key) => { if (key === "x") this.showClock(); }] },
    };
  }

  paintBands(u) {
    const { ctx, bbox, data } = u, [time] = data;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    this.lines.forEach(({ edge, role, colour }, k) => {
      if (edge !== "low") return;
      const [low, high] = [data[k + 1], data[k + 2]], rows = [...time.keys()].filter(row => Number.isFinite(low[row]));
      const place = (row, values) => [u.valToPos(time[row], "x", true), u.valToPos(values[row], "y", true)];
      ctx.beginPath();
      for (const row of rows) ctx.lineTo(...place(row, low));
      for (const row of rows.reverse()) ctx.lineTo(...place(row, high));
      ctx.fillStyle = `${colours().curves[colour % COLOURS]}${AREAS[role]}`;
      ctx.fill();
    });
    ctx.restore();
  }

  rangeX(low, high) {
    if (this.zoom) return this.zoom;
    return [0, this.end > 0 ? this.end : Math.max(high ?? 1, 1e-9)];
  }

  setZoom(u) {
    const { left, width } = u.select;
    if (width > 4) this.zoom = [u.posToVal(left, "x"), u.posToVal(left + width, "x")];
  }

  /* Show values: one pair of times and values in SI per line. */
  setData(pairs, end) {
    this.end = end;
    const tables = pairs.map(([time, values]) => [time, this.shown(values)]);
    const isAligned = tables.every(([time]) => time === tables[0][0] || areEqual(time, tables[0][0]));
    const data = isAligned ? [tables[0]?.[0] ?? [], ...tables.map(([, values]) => values)] : uPlot.join(tables);
    this.values = tables;
    this.u.setData(data, false);
    const [min, max] = this.rangeX(0, end);
    this.u.setScale("x", { min, max });
    this.place.setAttribute("aria-label", this.describe());
    // The hook of the scale is only called when the scale changes, and that later.
    this.showClock();
  }

  shown(values) {
    const { from } = this.display, shown = new Array(values.length);
    for (let k = 0; k < values.length; k++) shown[k] = Number.isFinite(values[k]) ? from(values[k]) : null;
    return shown;
  }

  resize({ width, height }) {
    if (this.u && (this.u.width !== width || this.u.height !== height)) this.u.setSize({ width, height: Math.max(LOWEST, height) });
  }

  get captionHeight() { return this.caption.offsetHeight; }

  redraw() { this.u?.redraw(false); }

  describe() {
    const names = this.lines.flatMap(({ label, edge }, k) => {
      const value = this.shownValue(k, (time, values) => values.at(-1) ?? NaN, digits);
      return edge === "high" ? [] : [`${label} ${value} ${this.display.unit}`.trim()];
    });
    return text("curves.plot", { quantity: this.title.textContent, names: names.join(", ") });
  }

  /* Text of a value of a line; for a band, those of both edges. */
  shownValue(k, valueOf, shown) {
    const [low, high] = this.values.slice(k, k + 2).map(pair => shown(valueOf(...pair)));
    return this.lines[k].edge && low !== high ? text("curves.range", { low, high }) : low;
  }

  /* --- Legend and time cursor --- */

  showLegend() {
    this.legend.replaceChildren(...this.lines.filter(({ edge }) => edge !== "high").map(line => {
      const item = document.createElement("span");
      item.className = `key is-${line.role}${line.edge ? " is-band" : ""}`;
      const swatch = item.appendChild(document.createElement("i"));
      swatch.style.color = `var(--curve-${line.colour % COLOURS + 1})`;
      item.append(line.label);
      line.value = item.appendChild(document.createElement("output"));
      line.value.setAttribute("aria-live", "off");
      return item;
    }));
  }

  showClock() {
    if (!this.u || !this.values) return;
    const { cursor } = this.store;
    const left = this.u.valToPos(cursor, "x");
    this.clock.hidden = !(left >= 0 && left <= this.u.bbox.width / devicePixelRatio + 1);
    this.clock.style.transform = `translateX(${left}px)`;
    this.lines.forEach((line, k) => {
      if (line.edge === "high") return;
      const shown = this.shownValue(k, (time, values) => valueAt(time, values, cursor, line.isStep),
        value => digits(Math.abs(value) < this.noise ? 0 : value, spanOf(this.u)));
      if (line.value.textContent !== shown) line.value.textContent = shown;
    });
  }

  point(event) {
    if (this.store.isPlaying || event.pointerType === "touch" && event.type === "pointermove" && !event.buttons) return;
    const { left } = this.u.over.getBoundingClientRect();
    const time = this.u.posToVal(event.clientX - left, "x");
    this.store.setCursor(Math.min(this.end, Math.max(0, time)));
  }

  remove() {
    this.u?.destroy();
    this.element.remove();
  }
}

/* Path of a curve through all its points, without those that are nearer than half a pixel to the one before.
   The usual path of uPlot makes steps of one pixel of a curve with many points. */
function linePath(u, series, first, last) {
  const stroke = new Path2D(), [xs, ys] = [u.data[0], u.data[series]];
  const line = (scale, from, to) => {
    const { min, max } = u.scales[scale];
    const slope = (to - from) / (max - min);
    return [slope, from - slope * min];
  };
  const { left, top, width, height } = u.bbox;
  const [ax, bx] = line("x", left, left + width), [ay, by] = line("y", top + height, top);
  const least = 0.5 * devicePixelRatio;
  let [px, py, isFirst] = [0, 0, true];
  for (let k = first; k <= last; k++) {
    const value = ys[k];
    if (value === null || value === undefined) continue;
    const x = ax * xs[k] + bx, y = ay * value + by;
    if (!isFirst && k < last && x - px < least && Math.abs(y - py) < least) continue;
    if (isFirst) stroke.moveTo(x, y);
    else stroke.lineTo(x, y);
    [px, py, isFirst] = [x, y, false];
  }
  return { stroke, fill: null, clip: null, band: null, gaps: null, flags: 1 };
}

function spanOf(u) { return (u.scales.y.max ?? 1) - (u.scales.y.min ?? 0); }

/* Width of the labels of the vertical axis, px. */
function widthOf(labels) { return 20 + 7 * Math.max(3, ...labels.map(({ length }) => length)); }

/* Label of a tick with the decimals of the step between ticks. */
function plain(value, step) {
  let decimals = 0;
  while (decimals < 9 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) decimals++;
  return Math.abs(value) >= 1e6 ? value.toExponential(1) : value.toFixed(decimals);
}

/* Range of the vertical axis; a constant curve lies in the middle. */
function rangeY(low, high, noise) {
  if (low === null || high === null) return [0, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const span = high - low > Math.max(noise, 1e-6 * size) ? high - low : 0.1 * size > noise ? 0.1 * size : 1;
  const middle = (low + high) / 2;
  return [middle - 0.56 * span, middle + 0.56 * span];
}

function areEqual(a, b) { return a.length === b.length && a.every((value, k) => value === b[k]); }
