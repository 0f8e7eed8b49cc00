/* Values of the curves in display units. */

import { text } from "./strings.js";

/* Usual unit of each SI unit, as in the figures of reports; other units stay SI. */
const USUAL = {
  Pa: "bar", K: "degC", m: "mm", "m^2": "mm^2", "m^3": "l", "m/s": "mm/s", kg: "g", "kg/s": "g/s", "m^3/(s Pa)": "dm^3/(s bar)",
};

/* Scale of a unit: its SI value is factor * (value + offset). */
export function scaleOf(unit, units) {
  const { factor = ["1", "1"], offset = ["0", "1"] } = units[unit] ?? {};
  const quotient = ([numerator, denominator]) => Number(numerator) / Number(denominator);
  return { factor: quotient(factor), offset: quotient(offset) };
}

/* Display unit of an SI unit: its name and functions to and from SI. */
export function displayOf(si, units) {
  const unit = USUAL[si] in units ? USUAL[si] : si;
  const { factor, offset } = unit === si ? { factor: 1, offset: 0 } : scaleOf(unit, units);
  return { unit: unit === "1" ? "" : unit, from: value => value / factor - offset };
}

/* Name of a quantity by its SI unit. */
export function quantityName(si) {
  const key = `quantities.${si}`;
  const name = text(key);
  return name === key ? si : name;
}

/* Unit as readers expect it. */
export function prettyUnit(unit) {
  return unit.replace("degC", "°C").replace(/\bdeg\b/, "°").replace(/\^2/g, "²").replace(/\^3/g, "³").replace(/(\w) (?=\w)/g, "$1·");
}

/* Number with the digits that a span of values shows. */
export function digits(value, span = Math.abs(value)) {
  if (!Number.isFinite(value)) return "-";
  const size = Math.max(Math.abs(value), Math.abs(span));
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) return value.toPrecision(4);
  const count = span > 0 ? Math.min(10, Math.max(0, Math.ceil(2.6 - Math.log10(span)))) : 3;
  const shown = value.toFixed(count);
  return Number(shown) === 0 ? shown.replace("-", "") : shown;
}

/* Value of a curve at a time, straight between two rows. */
export function valueAt(time, values, at, isStep = false) {
  let low = 0, high = time.length - 1;
  if (high < 0 || at < time[0] || at > time[high] * (1 + 1e-12)) return NaN;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= at) low = middle;
    else high = middle;
  }
  if (at >= time[high]) return values[high] ?? NaN;
  if (isStep || high === low) return values[low] ?? NaN;
  return values[low] + (values[high] - values[low]) * (at - time[low]) / (time[high] - time[low]);
}

/* Usual sizes in SI, as in the figures of reports. Changes that are smaller by STILL are noise of the solver. */
const SIZES = {
  Pa: 1e5, K: 300, m: 1e-3, "m/s": 0.1, N: 100, rad: 1, "rad/s": 10, "N m": 10, J: 10, 1: 1, "kg/s": 1e-3, W: 10, kg: 1e-3, "m^3": 1e-3,
};
const STILL = 1e-6;

/* Smallest change of a quantity that is not noise, in SI, for values of a size. */
export function noiseOf(si, size = 0) { return STILL * Math.max(SIZES[si] ?? 0, size); }

/* True if a curve is not constant. */
export function varies(values, si) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return high - low > noiseOf(si, Math.max(Math.abs(low), Math.abs(high)));
}

/* Largest absolute value of a curve. */
export function sizeOf(values) { return values.reduce((size, value) => (Math.abs(value) > size ? Math.abs(value) : size), 0); }

/* True if values jump and are constant between jumps, as those of a sampled controller. */
export function isStaircase(values) {
  let jumps = 0;
  for (let k = 1; k < values.length; k++) {
    if (values[k] === values[k - 1]) continue;
    if (k > 1 && values[k - 1] !== values[k - 2]) return false;
    jumps++;
  }
  return jumps > 0;
}
