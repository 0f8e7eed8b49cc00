/* Range and scale of the slider of a number. */

import { fromSi, parts, shown, siOf, withUnit } from "./units.js";

export const STEPS = 1000;
const SPAN = 3;  // largest and smallest value are the present one times and divided by it
const DEGREES = 30;  // span of a temperature, in degrees
const INSET = 0.01;  // distance from a limit that does not belong to the range, as a fraction of the range

/* Return {low, high, isLog, unit} in the typed unit, or null if a value has no range. */
export function rangeOf(field, value, units, ambient) {
  const typed = parts(value);
  const unit = typed?.unit || (typeof value === "number" && field.unit !== "1" ? field.unit : "");
  if (!typed || siOf(value, field.unit, units, ambient) === null) return null;
  const number = Number(typed.number);
  const limit = key => (key in field ? Number(fromSi(field[key], field.unit, unit, units, ambient)) : NaN);
  const [low, above, high, below] = ["low", "above", "high", "below"].map(limit);
  const ends = [first(low, above), first(high, below)];
  if (field.unit === "1" && ends.every(Number.isFinite) && ends[1] - ends[0] <= 200) {
    const inset = INSET * (ends[1] - ends[0]);
    const [least, most] = [ends[0] + (above >= ends[0] ? inset : 0), ends[1] - (below <= ends[1] ? inset : 0)];
    return least <= number && number <= most ? { low: least, high: most, isLog: false, unit } : null;
  }
  if (!number) return null;
  const isTemperature = field.quantity === "temperature";
  const reach = isTemperature ? [number - DEGREES, number + DEGREES] : [number / SPAN, number * SPAN].sort((a, b) => a - b);
  const range = { low: Math.max(reach[0], least(ends[0])), high: Math.min(reach[1], most(ends[1])), unit };
  return range.low < range.high ? { ...range, isLog: range.low > 0 && !isTemperature } : null;
}

/* Return the position of a number in a range, from 0 to STEPS. */
export function positionOf(number, { low, high, isLog }) {
  const share = isLog ? Math.log(number / low) / Math.log(high / low) : (number - low) / (high - low);
  return Math.round(STEPS * Math.min(Math.max(share, 0), 1));
}

/* Return the text of the number at a position, with three digits. */
export function textAt(position, { low, high, isLog, unit }) {
  const share = position / STEPS;
  const number = isLog ? low * (high / low) ** share : low + share * (high - low);
  return withUnit(Math.abs(number) < 1e-12 * (high - low) ? "0" : shown(number, 3), unit);
}

function first(...numbers) { return numbers.find(Number.isFinite) ?? NaN; }

function least(number) { return Number.isFinite(number) ? number : -Infinity; }

function most(number) { return Number.isFinite(number) ? number : Infinity; }
