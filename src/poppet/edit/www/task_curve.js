/* Curve of a sizing: a number of the run versus one parameter. */

import { svgElement } from "./symbols.js";
import { text } from "./strings.js";

const WIDTH = 288, HEIGHT = 170, LEFT = 46, BOTTOM = 34, TOP = 8, RIGHT = 10;

/* Return the figure of a curve {address, x_unit, x, name, y_unit, y, bounds, value}. */
export function sizedCurve(curve) {
  const figure = document.createElement("figure");
  figure.className = "task-curve";
  const svg = figure.appendChild(svgElement("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": labelOf(curve) }));
  const points = curve.x.map((x, k) => [x, curve.y[k]]).filter(([, y]) => y !== null);
  if (!points.length) {
    figure.replaceChildren(text("tasks.curve_empty"));
    return figure;
  }
  const across = scaleOf([...curve.x], LEFT, WIDTH - RIGHT);
  const along = scaleOf([...points.map(([, y]) => y), ...curve.bounds], HEIGHT - BOTTOM, TOP);
  for (const { at, label } of across.ticks) {
    svg.append(line("tick", at, TOP, at, HEIGHT - BOTTOM), words(at, HEIGHT - BOTTOM + 12, label, "middle"));
  }
  for (const { at, label } of along.ticks) svg.append(line("tick", LEFT, at, WIDTH - RIGHT, at), words(LEFT - 4, at + 3.5, label, "end"));
  for (const bound of curve.bounds) svg.append(line("bound", LEFT, along.at(bound), WIDTH - RIGHT, along.at(bound)));
  if (curve.value !== undefined) svg.append(line("value", across.at(curve.value), TOP, across.at(curve.value), HEIGHT - BOTTOM));
  const path = curve.x.map((x, k) => (curve.y[k] === null ? null : `${across.at(x).toFixed(1)} ${along.at(curve.y[k]).toFixed(1)}`));
  svg.append(svgElement("path", { class: "curve", d: segments(path) }));
  svg.append(words((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 6, withUnit(curve.address, curve.x_unit), "middle"));
  const caption = document.createElement("figcaption");
  caption.textContent = text("tasks.curve", { name: withUnit(curve.name, curve.y_unit), address: curve.address });
  figure.prepend(caption);
  return figure;
}

function labelOf(curve) {
  const known = curve.y.filter(y => y !== null);
  const ends = { from: digits(curve.x[0]), to: digits(curve.x.at(-1)), unit: curve.x_unit, low: digits(Math.min(...known)), high: digits(Math.max(...known)) };
  return text("tasks.curve_label", { name: withUnit(curve.name, curve.y_unit), address: curve.address, ...ends });
}

/* Path of a curve with gaps. */
function segments(points) {
  return points.map((point, k) => (point === null ? "" : `${k === 0 || points[k - 1] === null ? "M" : "L"}${point}`)).join("");
}

/* Linear scale from the values to the range `first` ... `last`, with at most five ticks. */
function scaleOf(values, first, last) {
  let [low, high] = [Math.min(...values), Math.max(...values)];
  if (low === high) [low, high] = [low - (Math.abs(low) || 1) * 0.05, high + (Math.abs(high) || 1) * 0.05];
  const at = value => first + (last - first) * (value - low) / (high - low);
  const raw = (high - low) / 4, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find(factor => factor * power >= raw) * power;
  const ticks = [];
  for (let value = Math.ceil(low / step) * step; value <= high + 1e-9 * step; value += step) ticks.push({ at: at(value), label: digits(value) });
  return { at, ticks };
}

function line(name, x1, y1, x2, y2) { return svgElement("line", { class: name, x1, y1, x2, y2 }); }

function words(x, y, content, anchor) {
  const element = svgElement("text", { x, y, "text-anchor": anchor });
  element.textContent = content;
  return element;
}

const withUnit = (name, unit) => (unit ? `${name} [${unit}]` : name);
const digits = value => String(Number(value.toPrecision(4)));
