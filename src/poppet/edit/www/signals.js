/* Editor of signals and characteristics. */
export class Signals {
  constructor(element, store) { Object.assign(this, { element, store }); }
}
