/* Worker of the page: holds the model, and runs it. A message contains a payload with another model, numbers, or both. */

import { PageModel } from "./model.js";

const integrator = WebAssembly.compileStreaming(fetch("/www/integrator.wasm"));
let model = null;

/* Load a model if the message has one, run it, and answer with all columns. Messages are handled one after another. */
async function perform({ payload, numbers, until }) {
  if (payload) model = await PageModel.load(payload, await integrator, model);
  const { status, time, series, seconds, stop, extremes } = model.run({ numbers, until: until ?? Infinity });
  const columns = new Map(model.header.columns.map(({ name }) => [name, series(name)]));
  const run = { status, time, series: columns, seconds, stop, extremes };
  const buffers = [time, ...columns.values()].map(({ buffer }) => buffer);
  postMessage({ run, seconds, ...(payload ? { header: pageHeader(model.header) } : {}) }, buffers);
}

/* Fields of the header that the page needs. */
function pageHeader({ key, columns, numbers, duration, output_step, notes }) {
  return { key, columns, numbers, duration, output_step, notes };
}

onmessage = ({ data }) => {
  perform(data).catch(problem => postMessage({ error: String(problem?.message ?? problem) }));
};
