/* Text of the circuit file. */
export class TextPanel {
  constructor(element, store) { Object.assign(this, { element, store }); }
}
