/* Wires of the drawing. */
export class Wires {
  constructor(group, store) { Object.assign(this, { group, store }); }
  update() {}
}
