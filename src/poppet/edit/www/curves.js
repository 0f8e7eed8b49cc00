/* Curves of the last run. */
export class Curves {
  constructor(element, store) { Object.assign(this, { element, store }); }
  toggle() {}
}
