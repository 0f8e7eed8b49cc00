/* Values of fields: how the file states them, and how the form shows them. */

import { fromSi, parts, shown, siOf, withUnit } from "./units.js";

const PLAIN_NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

/* Return True if a value of the file is a table with a value, a source and a note. */
export function isSourced(value) { return value !== null && typeof value === "object" && !Array.isArray(value) && "value" in value; }

/* Return the value without its source. */
export function plainValue(value) { return isSourced(value) ? value.value : value; }

/* Return a value of the file as a text. */
export function textOf(value) {
  const plain = plainValue(value);
  if (plain === undefined || plain === null) return "";
  if (Array.isArray(plain) && plain.every(item => typeof item === "string" && !item.includes(","))) return plain.join(", ");
  return typeof plain === "object" ? JSON.stringify(plain) : String(plain);
}

/* Return a typed text as a value for the file; undefined if it is not valid. `unit` is added to a number, except if the
   present value is a number without a unit. */
export function valueOf(field, typed, unit = "", present = undefined) {
  const word = typed.trim();
  if (!word) return null;
  if (field.type === "number") {
    if (!PLAIN_NUMBER.test(word) || !Number.isFinite(Number(word))) return word;
    const isBare = typeof plainValue(present) === "number" && unit === field.unit;
    return unit && !isBare ? withUnit(word, unit) : Number(word);
  }
  if (field.type === "switch") return { true: true, false: false }[word] ?? word;
  if (field.form === "list of str") return word.split(",").map(name => name.trim()).filter(Boolean);
  if (field.type === "reference" && /^[[{]/.test(word)) {
    try {
      return JSON.parse(word);
    } catch {
      return undefined;
    }
  }
  return word;
}

/* Return True if two values of the file are equal. */
export function isEqual(first, second) { return JSON.stringify(first ?? null) === JSON.stringify(second ?? null); }

/* Return the unit in a value of the file; a number without a unit has the unit of the field. */
export function unitOf(field, value) {
  const plain = plainValue(value);
  if (plain === undefined || plain === null) return parts(field.default)?.unit || field.units[0];
  return parts(plain)?.unit || (field.unit === "1" ? "" : field.unit);
}

/* Return True if a unit belongs to the quantity of a field. */
export function isUnitOf(field, unit, units) { return field.units.includes(unit) || siOf(withUnit("0", unit), field.unit, units) !== null; }

/* Return the ambient pressure of the circuit in Pa. */
export function ambientOf(view, units) { return siOf(plainValue(view.ambient?.pressure) ?? 1e5, "Pa", units) ?? 1e5; }

/* Return the limits of a number as texts, such as "> 0" or "≤ 5 mm". */
export function limitsOf(field, units) {
  const signs = { low: "≥", above: ">", high: "≤", below: "<" };
  return Object.keys(signs).filter(key => key in field).map(key => `${signs[key]} ${inUsualUnit(field, field[key], units)}`);
}

/* Return an SI value in the first unit of a field whose zero is the zero of the SI unit. */
export function inUsualUnit(field, si, units) {
  if (si === 0) return "0";
  const unit = field.units.find(name => siOf(withUnit("0", name), field.unit, units, 1) === 0);
  const number = unit === undefined ? null : fromSi(si, field.unit, unit, units);
  if (number === null) return withUnit(shown(si), field.unit === "1" ? "" : field.unit);
  return withUnit(shown(Number(number)), unit);
}

/* Return the default of a field as a text. */
export function defaultOf(field) {
  if (field.default === null || field.default === undefined) return "";
  if (typeof field.default !== "number") return String(field.default);
  return withUnit(shown(field.default, 6), field.unit === "1" ? "" : field.unit);
}

/* Return a name of the file in words. */
export function inWords(name) { return name.split(".").at(-1).replaceAll("_", " "); }
