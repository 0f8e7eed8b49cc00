/* Model of a circuit: a payload of `poppet.edit.build`, simulated in a worker or in node. */
import { Kernel, LIBRARY } from "./kernel.js";

const MARK = "POPPETM1";

/* Header and arrays of a payload. */
function unpack(payload) {
  const bytes = ArrayBuffer.isView(payload) ? new Uint8Array(payload.buffer, payload.byteOffset, payload.byteLength) : new Uint8Array(payload);
  const begin = MARK.length + 4, text = new TextDecoder();
  if (text.decode(bytes.subarray(0, MARK.length)) !== MARK) throw new Error("not a payload");
  const end = begin + new DataView(bytes.buffer, bytes.byteOffset).getUint32(MARK.length, true);
  const header = JSON.parse(text.decode(bytes.subarray(begin, end)));
  const blobs = {};
  for (const [name, [offset, length]] of Object.entries(header.blobs)) blobs[name] = bytes.subarray(end + offset, end + offset + length);
  return { header, blobs };
}

/* Functions of a model and an integrator, which share memory, table and stack. */
async function link(module, integrator, { shared: { stack, pages, functions } }) {
  const shared = {
    memory: new WebAssembly.Memory({ initial: pages }),
    table: new WebAssembly.Table({ initial: 1 + functions, element: "anyfunc" }),
    stack: new WebAssembly.Global({ value: "i32", mutable: true }, stack),
  };
  const imports = { env: LIBRARY, shared };
  const [first, second] = await Promise.all([WebAssembly.instantiate(integrator, imports), WebAssembly.instantiate(await module, imports)]);
  return { memory: shared.memory, integrate: first.exports.integrate, start: second.exports.start };
}

export class PageModel {
  /* Model of a payload. `integrator` is a compiled module or its bytes. A payload without a module has that of the
     former model, which must not run any more. */
  static async load(payload, integrator, former) {
    const { header, blobs } = unpack(payload);
    if (!(integrator instanceof WebAssembly.Module)) integrator = await WebAssembly.compile(integrator);
    if (!blobs.module && former?.header.key !== header.key) throw new Error("the payload has no module");
    const exports = blobs.module ? await link(WebAssembly.compile(blobs.module), integrator, header) : former.exports;
    return new PageModel(exports, header, blobs);
  }

  constructor(exports, header, blobs) {
    this.exports = exports;
    this.header = header;
    this.kernel = new Kernel(exports, header, blobs);
    this.places = new Map(header.columns.map(({ name }, place) => [name, place]));
  }

  /* One run. `numbers` are pairs of an address of `header.numbers` and a value; the run ends at the last row before
     the time `until`. The results are valid until the next run. */
  run({ numbers = [], until = Infinity } = {}) {
    const { kernel, header } = this, { grid } = kernel;
    const changed = numbers.map(([address, value]) => {
      if (!(address in header.numbers)) throw new Error(`${address} cannot change here`);
      return { ...header.numbers[address], value };
    });
    const inputs = changed.flatMap(({ inputs, value }) => inputs.map(input => [input, [[0, value, 0, false]]]));
    let n_rows = grid.length;
    while (n_rows > 2 && grid[n_rows - 1] > until) n_rows--;
    const begin = performance.now();
    const { status, rows, reached } = kernel.run(changed.map(({ place, value }) => [place, value]), inputs, [], n_rows);
    const seconds = 1e-3 * (performance.now() - begin);
    const time = grid.slice(0, rows);
    if (status === "stopped") time[rows - 1] = reached;
    const n = kernel.lengths.n_states;
    const extremes = new Float64Array(this.exports.memory.buffer, kernel.at.books, 2 * n).slice();
    return { status, rows, time, seconds, stop: Number(kernel.counts[3]), extremes, series: name => kernel.series(this.places.get(name)).slice(0, rows) };
  }
}
