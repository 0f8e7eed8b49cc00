/* Drawing of the circuit. */
export class Drawing {
  constructor(svg, store) { Object.assign(this, { svg, store }); }
  onKey() { return false; }
  rotate() {}
  mirror() {}
  remove() {}
  copy() {}
  paste() {}
  zoom() {}
}
