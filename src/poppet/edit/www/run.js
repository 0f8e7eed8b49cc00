/* Title, run options, ambient, gas and stop conditions. */
export class Run {
  constructor(element, store) { Object.assign(this, { element, store }); }
}
