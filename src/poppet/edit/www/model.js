/* Model of a circuit in the page or in Node.js. */
export class PageModel {
  static async load() { throw new Error("no model"); }
}
