/* Conversion of values with units, as poppet.core.units performs it: in exact arithmetic, rounded once. */

const NUMBER = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)$/s;
const LARGEST_EXPONENT = 400;
const MOST_DIGITS = 12;  // of a converted number that has the same SI value
const DIGITS = 10;  // of another one

/* Return number and unit of a text, or null if it does not begin with a number. */
export function parts(value) {
  const match = NUMBER.exec(typeof value === "number" ? String(value) : value ?? "");
  return match && { number: match[1], unit: match[2].trim() };
}

/* Return the SI value of a typed value, or null if its unit is not in the table. `unit` is the SI unit of the field. */
export function siOf(value, unit, units, ambient = 100000) {
  if (typeof value === "number") return value;
  const typed = parts(value);
  if (!typed) return null;
  if (!typed.unit) return Number(typed.number);
  const source = scaleOf(typed.unit, units), target = scaleOf(unit, units);
  const number = exact(typed.number);
  if (!source || !target || !number || source.dimension !== target.dimension) return null;
  const value_si = toNumber(over(times(plus(number, source.offset), source.factor), target.factor));
  return source.gauge ? value_si + ambient : value_si;
}

/* Return an SI value as a number in another unit, or null. */
export function fromSi(si, unit, to, units, ambient = 100000) {
  const source = scaleOf(unit, units), target = scaleOf(to, units);
  if (!source || !target || !Number.isFinite(si)) return null;
  const number = exact(String(target.gauge ? si - ambient : si));
  const shifted = plus(over(times(number, source.factor), target.factor), negative(target.offset));
  return shortest(toNumber(shifted), text => siOf(withUnit(text, to), unit, units, ambient) === si);
}

/* Return a typed value in another unit, or null if that is not possible. The result is rounded to 10
   digits if no number of at most 12 has the same SI value. */
export function converted(value, unit, to, units, ambient = 100000) {
  const typed = parts(value);
  if (!typed) return null;
  const source = scaleOf(typed.unit || unit, units), target = scaleOf(to || unit, units);
  const number = exact(typed.number);
  if (!source || !target || !number || source.dimension !== target.dimension) return null;
  const pressure = [BigInt(Math.round(ambient * 1e6)), 1000000n];
  let si = times(plus(number, source.offset), source.factor);
  if (source.gauge && !target.gauge) si = plus(si, pressure);
  if (target.gauge && !source.gauge) si = plus(si, negative(pressure));
  const result = plus(over(si, target.factor), negative(target.offset));
  const wanted = siOf(value, unit, units, ambient);
  const isSame = text => siOf(withUnit(text, to), unit, units, ambient) === wanted;
  return withUnit(shortest(toNumber(result), isSame), to);
}

/* Return a number with its unit. */
export function withUnit(number, unit) { return unit ? `${number} ${unit}` : String(number); }

/* Return a number as a text with a number of significant digits, with an exponent if that is shorter. */
export function shown(number, digits = 4) {
  const rounded = Number(number.toPrecision(digits));
  const [plain, power] = [String(rounded), rounded.toExponential()].map(text => text.replace("e+", "e"));
  const isFar = Math.abs(rounded) >= 1e5 || Math.abs(rounded) < 1e-4;
  return isFar && power.length < plain.length ? power : plain;
}

function shortest(number, isSame) {
  for (let count = 1; count <= MOST_DIGITS; count++) {
    const text = shown(number, count);
    if (isSame(text)) return text;
  }
  return shown(number, DIGITS);
}

/* --- Fractions: [numerator, denominator], the denominator above zero --- */

const scales = new WeakMap();  // scale by entry of the table

function scaleOf(unit, units) {
  const entry = units[unit === "1" ? "" : unit];
  if (!entry) return null;
  if (!scales.has(entry)) {
    const [factor, offset] = [entry.factor, entry.offset].map(([top, bottom]) => [BigInt(top), BigInt(bottom)]);
    scales.set(entry, { factor, offset, gauge: entry.gauge, dimension: entry.dimension });
  }
  return scales.get(entry);
}

/* Return a decimal text as a fraction, or null if its exponent is large. */
function exact(text) {
  const [, sign, whole, decimals = "", power = "0"] = /^([+-]?)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/.exec(text);
  const exponent = Number(power) - decimals.length;
  if (Math.abs(exponent) > LARGEST_EXPONENT) return null;
  const digits = BigInt(`${whole}${decimals}` || "0") * (sign === "-" ? -1n : 1n);
  return exponent < 0 ? [digits, 10n ** BigInt(-exponent)] : [digits * 10n ** BigInt(exponent), 1n];
}

function times([a, b], [c, d]) { return [a * c, b * d]; }

function over([a, b], [c, d]) { return [a * d, b * c]; }

function plus([a, b], [c, d]) { return [a * d + c * b, b * d]; }

function negative([a, b]) { return [-a, b]; }

/* Return the nearest float of a fraction; ties go to the even one. */
export function toNumber([top, bottom]) {
  if (top === 0n) return 0;
  const isNegative = top < 0n;
  let [a, b] = [isNegative ? -top : top, bottom];
  // Scaled to a quotient of 55 to 56 bits; bits behind them only count as a remainder.
  let shift = bits(a) - bits(b) - 55;
  shift = Math.max(shift, -1075 - 1);  // the spacing of the smallest floats
  if (shift > 0) b <<= BigInt(shift);
  else a <<= BigInt(-shift);
  let quotient = a / b;
  const hasRemainder = a % b !== 0n;
  const extra = BigInt(Math.max(bits(quotient) - 53, shift === -1076 ? 2 : 0));
  const half = 1n << (extra - 1n);
  const rest = quotient & ((1n << extra) - 1n);
  quotient >>= extra;
  if (rest > half || (rest === half && (hasRemainder || quotient & 1n))) quotient += 1n;
  const power = shift + Number(extra);
  // Two steps, because 2 ** power alone can be zero.
  const value = Number(quotient) * 2 ** Math.max(power, -1000) * 2 ** (power - Math.max(power, -1000));
  return isNegative ? -value : value;
}

function bits(number) {
  const digits = number.toString(16);
  return 4 * digits.length - Math.clz32(parseInt(digits[0], 16)) + 28;
}
