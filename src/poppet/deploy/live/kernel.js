/* The kernel in a browser: the module, and the row of fields that its integrator is handed, filled as Python fills it. */
"use strict";

const LIBRARY = {
  sin: Math.sin, cos: Math.cos, tan: Math.tan, tanh: Math.tanh, atan: Math.atan, atan2: Math.atan2, exp: Math.exp,
  log: Math.log, pow: Math.pow, exp2: x => Math.pow(2, x), exp10: x => Math.pow(10, x), log2: Math.log2,
};
const ENDINGS = ["done", "stopped", "stalled", "too many", "not finite", "interrupted"];
const TIGHTER = [1, 0.1, 0.01];  // as `poppet.engine.solve` repeats a run that stalled

/* Header and blobs from the text that a page carries. */
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
    const missing = end - exports.memory.buffer.byteLength;
    if (missing > 0) exports.memory.grow(Math.ceil(missing / 65536));
    const { buffer } = exports.memory;
    for (const name in blobs) if (at[name]) new Uint8Array(buffer, at[name]).set(blobs[name]);
    const doubles = name => new Float64Array(buffer, at[name], sizes[name] / 8);
    for (const name of ["p", "x", "coefficients", "table", "watch", "limits", "grid"]) this[name] = doubles(name);
    this.counts = new BigInt64Array(buffer, at.counts, 5);
    const fields = new BigInt64Array(buffer, job, header.fields.length);
    header.fields.forEach((name, k) => { fields[k] = BigInt(header.functions[name] ?? this.lengths[name] ?? at[name] ?? 0); });
    Object.assign(this, { at, job, given: { p: this.p.slice(), coefficients: this.coefficients.slice(), tolerance: this.limits[3] } });
  }

  /* One run, with other numbers by their places in p, and other coefficients by theirs. The table is written over by the next. */
  run(numbers = [], coefficients = []) {
    for (const share of TIGHTER) {
      this.p.set(this.given.p);
      this.coefficients.set(this.given.coefficients);
      for (const [k, v] of numbers) this.p[k] = v;
      for (const [k, v] of coefficients) this.coefficients[k] = v;
      this.limits[3] = this.given.tolerance * share;
      this.exports.start(this.at.p, this.at.x, this.at.p + 8 * this.lengths.n_numbers);
      this.watch.fill(0);
      this.counts.fill(0n);
      const status = ENDINGS[Number(this.exports.integrate(this.job))];
      const [accepted, attempts, rows] = Array.from(this.counts, Number);
      const n = this.grid.length;
      for (let k = 0; k < this.lengths.n_outputs; k++) this.table.fill(NaN, k * n + rows, (k + 1) * n);
      this.ended = { status, accepted, attempts, rows, reached: this.watch[0], share };
      if (status !== "stalled") break;
    }
    return this.ended;
  }

  /* A series of the last run. */
  series(k) { return this.table.subarray(k * this.grid.length, (k + 1) * this.grid.length); }
}
