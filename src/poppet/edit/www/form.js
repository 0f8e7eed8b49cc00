/* Form of the selected part. */
export class Form {
  constructor(element, store) { Object.assign(this, { element, store }); }
}
