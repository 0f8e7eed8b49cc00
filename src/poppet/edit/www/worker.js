/* Worker of the page: holds the model, and runs it. A message contains a payload with another model, numbers, or both. */

import { PageModel } from "./model.js";

const integrator = WebAssembly.compileStreaming(fetch("/www/integrator.wasm"));
let model = null;

/* Load a model if the message has one, run it, and answer with all columns. Messages are handled one after another. */
async function perform({ payload, numbers, until }) {
  if (payload) model = await PageModel.load(payload, await integrator, model);
  const { status, rows, time, series, seconds } = model.run({ numbers, ...(until === null ? {} : { until }) });
  const columns = new Map(model.header.columns.map(({ name }) => [name, series(name).slice(0, rows)]));
  const run = { status, time: time.slice(0, rows), series: columns, seconds };
  const buffers = [run.time.buffer, ...[...columns.values()].map(values => values.buffer)];
  const { header } = model;
  postMessage({ run, seconds, ...(payload ? { header: pageHeader(header) } : {}) }, buffers);
}

/* Fields of the header that the page needs. */
function pageHeader({ key, columns, numbers, duration, output_step, notes }) {
  return { key, columns, numbers, duration, output_step, notes };
}

onmessage = ({ data }) => {
  perform(data).catch(problem => postMessage({ error: String(problem?.message ?? problem) }));
};
