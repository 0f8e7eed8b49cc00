/* Palette of all kinds of parts. */
export class Palette {
  constructor(element, store, drawing) { Object.assign(this, { element, store, drawing }); }
  search() {}
}
