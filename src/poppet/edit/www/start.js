/* Start page: templates, files of the folder, and an empty circuit. */
export class StartPage {
  constructor(element, store) { Object.assign(this, { element, store }); }
  open() {}
}
