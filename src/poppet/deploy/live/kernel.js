/* Kernel in a browser: the module, and the fields of its integrator, filled as in Python. */
"use strict";

const LIBRARY = {
  sin: Math.sin, cos: Math.cos, tan: Math.tan, tanh: Math.tanh, atan: Math.atan, atan2: Math.atan2, exp: Math.exp,
  log: Math.log, pow: Math.pow, exp2: x => Math.pow(2, x), exp10: x => Math.pow(10, x), log2: Math.log2,
};
const ENDINGS = ["done", "stopped", "stalled", "too many", "not finite", "interrupted"];
const TIGHTER = [1, 0.1, 0.01];  // as in `poppet.engine.solve`, for a run that stalled

/* Header and blobs from the text in a page. */
async function unpacked(text) {
  const packed = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const begin = 4 + new DataView(bytes.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, begin)));
  const blobs = {};
  for (const [name, [at, length]] of Object.entries(header.blobs)) blobs[name] = bytes.subarray(begin + at, begin + at + length);
  return { header, blobs };
}

/* Inputs of a file in segments, some of them replaced, merged as in `poppet.timeseries.segments`. */
class Inputs {
  constructor(blobs, { n_inputs: n }) {
    const of = (kind, name) => new kind(blobs[name].slice().buffer);
    Object.assign(this, {
      n, stride: 7 * n, starts: of(Float64Array, "starts"), courses: of(BigInt64Array, "courses"),
      coefficients: of(Float64Array, "coefficients"), jumps: of(Uint8Array, "jumps"),
    });
  }

  /* Seven coefficients of an input on a segment. */
  row(segment, input) {
    const at = this.stride * Number(this.courses[segment]) + 7 * input;
    return this.coefficients.subarray(at, at + 7);
  }

  /* True if an input has a new row at the start of a segment, and true if its value jumps. */
  turns(segment, input) {
    const before = this.row(segment - 1, input), row = this.row(segment, input);
    if (before.every((v, k) => v === row[k])) return [false, false];
    const [a, b] = [before, row].map(([v, s, amplitude, f, c, phase, from]) => {
      const tau = this.starts[segment] - from;
      return v + s * tau + amplitude * Math.sin(2 * Math.PI * (f + .5 * c * tau) * tau + phase);
    });
    return [true, Math.abs(a - b) > 1e-9 * Math.max(Math.abs(a), Math.abs(b))];
  }

  /* Starts, courses, coefficients and jumps with replaced rows of some inputs, up to the end of a run. */
  with(others, until) {
    const replaced = new Map(others), kept = Array.from({ length: this.n }, (_, k) => k).filter(k => !replaced.has(k));
    const marks = [];  // time, and true if a value jumps
    for (let k = 0; k < this.starts.length && (!k || this.starts[k] < until); k++) {
      const turns = k ? kept.map(input => this.turns(k, input)) : [[true, false]];
      if (turns.some(([is]) => is)) marks.push([this.starts[k], this.jumps[k] && turns.some(([, jumps]) => jumps)]);
    }
    for (const rows of replaced.values()) for (const [t, , , jumps] of rows) if (t < until) marks.push([t, jumps]);
    marks.sort(([a], [b]) => a - b);
    const starts = [], jumps = [], last = [];  // starts that differ by rounding are one
    for (const [t, is] of marks) {
      if (starts.length && t - last[last.length - 1] <= 4 * Number.EPSILON * t) last[last.length - 1] = t;
      else { starts.push(t); last.push(t); jumps.push(0); }
      if (is) jumps[jumps.length - 1] = 1;
    }
    const courses = [], coefficients = [], known = new Map(), places = new Map(others.map(([input]) => [input, 0]));
    let segment = 0;
    for (const t of last) {
      while (this.starts[segment + 1] <= t) segment++;
      for (const [input, rows] of replaced) { let k = places.get(input); while (rows[k + 1]?.[0] <= t) k++; places.set(input, k); }
      const key = [this.courses[segment], ...places.values()].join();
      if (!known.has(key)) {
        known.set(key, known.size);
        for (let input = 0; input < this.n; input++) {
          const row = replaced.get(input)?.[places.get(input)];
          coefficients.push(...row ? [row[1], row[2], ...Array.from({ length: 4 }, (_, j) => row[4 + j] ?? 0), row[0]] : this.row(segment, input));
        }
      }
      courses.push(BigInt(known.get(key)));
    }
    return { starts: Float64Array.from(starts), courses: BigInt64Array.from(courses),
             coefficients: Float64Array.from(coefficients), jumps: Uint8Array.from(jumps) };
  }
}

/* Rows of a signal that begins later, with its first value before. */
function delayed(rows, delay) {
  if (!(delay > 0)) return rows;
  const [, value, , , amplitude = 0, , , phase = 0] = rows[0];
  return [[0, value + amplitude * Math.sin(phase), 0, false], ...rows.map(([t, ...row]) => [t + delay, ...row])];
}

class Kernel {
  static async of({ header, blobs }) {
    const { instance } = await WebAssembly.instantiate(blobs.module, { env: LIBRARY });
    return new Kernel(instance.exports, header, blobs);
  }

  constructor(exports, header, blobs) {
    this.exports = exports;
    this.lengths = header.lengths;
    const at = {}, sizes = {};
    for (const name in blobs) if (name in header.room || header.fields.includes(name) && name !== "module") sizes[name] = blobs[name].length;
    for (const name in header.room) sizes[name] = 8 * header.room[name];
    let end = header.heap;
    for (const name in sizes) { at[name] = sizes[name] ? end : 0; end += Math.ceil(sizes[name] / 16) * 16; }
    const job = end;
    end += 8 * header.fields.length;
    Object.assign(this, { at, sizes, job, end, header });
    this.room(end);
    for (const name in blobs) if (at[name]) new Uint8Array(exports.memory.buffer, at[name]).set(blobs[name]);
    this.file = new Inputs(blobs, this.lengths);
    this.given = { p: this.p.slice(), tolerance: this.limits[3], weights: this.weights.slice() };
    this.map = { values: [], places: [], conditions: [], links: [], signals: {}, ...header.map };
    this.map.usual = this.map.values.length ? this.mapped(this.map.values) : [];
  }

  /* Extend the memory to an end, and make views of its arrays. */
  room(end) {
    const { memory } = this.exports, missing = end - memory.buffer.byteLength;
    if (missing > 0) memory.grow(Math.ceil(missing / 65536));
    for (const name of ["p", "x", "table", "watch", "limits", "grid", "weights", "sliders", "results"])
      this[name] = new Float64Array(memory.buffer, this.at[name] ?? 0, (this.sizes[name] ?? 0) / 8);
    this.counts = new BigInt64Array(memory.buffer, this.at.counts, 5);
  }

  /* Fill the fields; replaced inputs are stored after all other arrays. A run can end at an earlier row. */
  drive(inputs, n_rows) {
    const at = { ...this.at }, lengths = { ...this.lengths, n_rows }, until = this.grid[n_rows - 1];
    if (n_rows < this.grid.length) lengths.n_segments = Math.max(1, this.file.starts.filter(t => t < until).length);
    if (inputs.length) {
      const merged = this.file.with(inputs, until);
      let end = Math.ceil(this.end / 16) * 16;
      for (const name in merged) { at[name] = end; end += Math.ceil(merged[name].byteLength / 16) * 16; }
      this.room(end);
      for (const name in merged) new Uint8Array(this.exports.memory.buffer, at[name]).set(new Uint8Array(merged[name].buffer));
      Object.assign(lengths, { n_segments: merged.starts.length, n_courses: merged.coefficients.length / this.file.stride });
    }
    const { fields, functions } = this.header, row = new BigInt64Array(this.exports.memory.buffer, this.job, fields.length);
    fields.forEach((name, k) => { row[k] = BigInt(functions[name] ?? lengths[name] ?? at[name] ?? 0); });
  }

  /* Parameters and thresholds for values of the sliders, in the order of the map. */
  mapped(values) {
    if (!this.results.length) return [];
    this.sliders.set(values);
    this.exports.mapped(this.at.sliders, this.at.results);
    return Array.from(this.results);
  }

  /* Arguments of a run with other values of the sliders. `inputs` are replaced inputs: the place of each, its rows, and the delay of a
     signal. Inputs without a signal follow their parameters, delayed signals their delays. */
  changes(values, inputs = []) {
    const { usual, places, conditions, links, signals } = this.map, results = this.mapped(values);
    const others = results.map((v, j) => [j, v]).filter(([j, v]) => v !== usual[j]), n = places.length;
    const numbers = others.filter(([j]) => j < n).map(([j, v]) => [places[j], v]), of = new Map(numbers);
    const thresholds = others.filter(([j]) => j >= n).map(([j, v]) => [3 * conditions[j - n] + 2, v]);
    const replaced = new Map(inputs.map(([k, rows, delay]) => [k, delayed(rows, delay === undefined ? 0 : of.get(links[k]?.[1]) ?? delay)]));
    links.forEach(([parameter, delay], k) => {
      if (replaced.has(k)) return;
      if (of.has(parameter)) replaced.set(k, [[0, of.get(parameter), 0, false]]);
      else if (of.has(delay) && signals[k]) replaced.set(k, delayed(signals[k], of.get(delay)));
    });
    return [numbers, [...replaced], thresholds];
  }

  /* One run, with other numbers by their places in p, other inputs (the place of each, and its rows of time, value, slope and
     jump), and other weights of stop conditions, up to the last of some rows. The table is written over by the next. */
  run(numbers = [], inputs = [], thresholds = [], n_rows = this.grid.length) {
    this.drive(inputs, n_rows);
    this.weights.set(this.given.weights);
    for (const [k, v] of thresholds) this.weights[k] = v;
    for (const share of TIGHTER) {
      this.p.set(this.given.p);
      for (const [k, v] of numbers) this.p[k] = v;
      this.limits[3] = this.given.tolerance * share;
      this.exports.start(this.at.p, this.at.x, this.at.p + 8 * this.lengths.n_numbers);
      this.watch.fill(0);
      this.counts.fill(0n);
      const status = ENDINGS[Number(this.exports.integrate(this.job))];
      const [accepted, attempts, rows] = Array.from(this.counts, Number);
      for (let k = 0; k < this.lengths.n_outputs; k++) this.table.fill(NaN, k * n_rows + rows, (k + 1) * n_rows);
      this.n_rows = n_rows;
      this.ended = { status, accepted, attempts, rows, reached: this.watch[0], share };
      if (status !== "stalled") break;
    }
    return this.ended;
  }

  /* An output of the last run. */
  series(k) { return this.table.subarray(k * this.n_rows, (k + 1) * this.n_rows); }
}
export { Kernel, LIBRARY };
