/* Tasks of the server: report, tune, identify, ensemble, sizing and exports. */
export class Tasks {
  constructor(element, store) { Object.assign(this, { element, store }); }
}
