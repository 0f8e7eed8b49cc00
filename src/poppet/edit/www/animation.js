/* State of the last run in the drawing. */
export class Animation {
  constructor(drawing) { this.drawing = drawing; }
  changed() {}
  later() {}
  show() {}
}
