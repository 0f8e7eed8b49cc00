/* Row of one field in the form: input, unit, slider, source, help and error. */

import { fillOptions, make, newId, show } from "./elements.js";
import { positionOf, rangeOf, STEPS, textAt } from "./sliders.js";
import { SourceEditor } from "./source_editor.js";
import { text } from "./strings.js";
import { converted, fromSi, siOf, withUnit } from "./units.js";
import { ambientOf, defaultOf, inWords, isEqual, isSourced, isUnitOf, limitsOf, plainValue, textOf, unitOf, valueOf } from "./field_values.js";

const MOST_CHOICES = 40;  // of a selection; more choices are searched in the input
const QUIET = 400;  // ms after the last key on a slider, then its value is written

/* Input with a value that is applied by Enter or when the focus leaves it; Escape restores it. In a long text with
   several lines, Ctrl+Enter applies it. Subclasses define
   `present()`, the value in the circuit as a text, and `operations(typed)`, or null if the typed text is not valid. */
export class InputRow {
  constructor(store, { address, label, help = "", isLong = false }) {
    Object.assign(this, { store, address, label, isLong });
    this.id = newId();
    this.shown = "";  // text of the value in the circuit
    this.refused = "";  // reason why the typed text was refused
    this.refusedText = null;
    this.list = make("datalist", { id: `${this.id}-list` });
    this.choice = make("select", {
      class: "choice", hidden: true, "aria-label": text("form.choices_of", { name: label }), onchange: () => this.#choose(),
    });
    this.input = make(isLong ? "textarea" : "input", {
      ...(isLong ? { rows: 3 } : { type: "text", list: this.list.id }), id: this.id, name: address, autocomplete: "off", spellcheck: false,
      "aria-describedby": `${this.id}-help ${this.id}-bad`,
      onkeydown: event => this.#onKey(event), onchange: () => this.commit(), oninput: () => this.#onInput(),
    });
    this.name = make("label", { for: this.id }, label);
    this.help = make("p", { class: "help", id: `${this.id}-help` }, help);
    this.bad = make("p", { class: "bad", id: `${this.id}-bad`, hidden: true });
    this.value = make("div", { class: "value" }, this.input, this.list, this.choice);
    this.head = make("div", { class: "head" }, this.name);
    this.element = make("div", { class: "field" }, this.head, this.value, this.bad, this.help);
  }

  get isDirty() { return this.input.value !== this.shown; }

  #onKey(event) {
    if (event.key === "Enter" && (!this.isLong || event.ctrlKey)) {
      event.preventDefault();
      this.refusedText = null;
      this.commit();
    } else if (event.key === "Escape" && this.isDirty) {
      this.restore();
    }
  }

  #onInput() {
    if (!this.refused) return;
    this.refused = "";
    this.showErrors();
  }

  /* Offer choices: few ones in a selection beside the input, many ones in a list that the typed text filters. */
  offer(choices, first = "") {
    const isFew = choices.length <= MOST_CHOICES;
    this.choice.hidden = !choices.length || !isFew;
    fillOptions(this.list, isFew ? [] : choices);
    fillOptions(this.choice, isFew ? ["", ...choices] : [], value => value || first);
    if (isFew) this.choice.value = choices.includes(this.input.value) ? this.input.value : "";
  }

  #choose() {
    this.input.value = this.choice.value;
    this.commit();
  }

  restore() {
    this.refused = "";
    this.refusedText = null;
    this.input.value = this.shown;
    this.showErrors();
  }

  /* Show the value of the circuit; a text that is being typed stays. */
  update() {
    const present = this.present();
    const isTyped = this.isDirty;
    this.shown = present;
    if (!isTyped) this.input.value = present;
    this.showErrors();
  }

  /* True if the address of an error is that of the row, or an address within its value. */
  concerns(address) { return address === this.address || (this.isTable && address.startsWith(`${this.address}.`)); }

  showErrors() {
    const errors = this.store.errors.filter(error => this.concerns(bare(error.address)));
    const message = this.refused || errors.map(({ message, hint }) => [message, hint].filter(Boolean).join(" ")).join(" ");
    show(this.bad, message);
    this.input.setAttribute("aria-invalid", message ? "true" : "false");
    if (errors.length) this.bad.dataset.address = errors[0].address;
    else delete this.bad.dataset.address;
  }

  /* Apply the typed text if it differs from the value of the circuit; a refused text is tried again only by Enter. */
  async commit() {
    const typed = this.input.value;
    if (!this.isDirty || typed === this.refusedText) return;
    const problem = this.problem(typed), operations = problem ? null : this.operations(typed);
    if (!operations) {
      this.refuse(problem || text("form.not_valid"));
      return;
    }
    this.shown = typed;
    if (!operations.length) {
      this.update();
      this.input.value = this.shown;
      return;
    }
    this.refused = "";
    const state = await this.store.apply(operations, this.options?.() ?? {});
    if (!state) this.refuse(this.store.message);
    else if (this.input.value === typed) this.input.value = this.shown = this.present();
  }

  /* Reason why a typed text cannot be applied, or an empty text. */
  problem() { return ""; }

  refuse(message) {
    this.refused = message;
    this.refusedText = this.input.value;
    this.shown = this.present();
    this.showErrors();
  }
}

/* Return an address without the name of its table. */
export function bare(address) { return (address ?? "").replace(/^parts\./, ""); }

/* Row of a field of a part, or of a table such as `run`. `read()` returns the value in the file. */
export class FieldRow extends InputRow {
  constructor(store, { owner, field, read, isRequired = false, choices = () => field.choices ?? [] }) {
    super(store, { address: `${owner}.${field.name}`, label: inWords(field.name) });
    // Fields of several groups have the same last name.
    this.fullName = field.name.split(".").map(inWords).join(": ");
    if (this.fullName !== this.label) this.input.setAttribute("aria-label", this.fullName);
    Object.assign(this, { field, read, isRequired, listed: choices });
    this.isTable = field.type === "reference";
    this.element.dataset.type = field.type;
    if (isRequired) this.name.append(make("span", { class: "required" }, ` ${text("form.required")}`));
    show(this.help, this.#help());
    this.#addOrigin(field);
    if (field.type === "number") this.#addUnit();
  }

  #timer = 0;

  get stated() { return this.read(); }

  /* Addresses that get the value. */
  get addresses() { return [this.address]; }

  get choices() { return this.listed(); }

  present() { return textOf(this.stated); }

  operations(typed) {
    const value = valueOf(this.field, typed, this.unit?.value ?? "", this.stated);
    if (value === undefined) return null;
    if (value !== null && isEqual(value, plainValue(this.stated))) return [];
    return this.#setting(value);
  }

  update() {
    super.update();
    const { stated } = this;
    this.element.classList.toggle("is-stated", stated !== undefined);
    this.origin.update(stated);
    this.input.placeholder = this.placeholder();
    if (this.field.type !== "number") {
      this.offer(this.choices, defaultOf(this.field) ? text("form.default", { value: defaultOf(this.field) }) : text("form.nothing"));
      return;
    }
    this.#updateUnit();
    // The range is that of the value before the drag, otherwise the value would run away below the pointer.
    if (!this.isSliding && (document.activeElement !== this.slider || !this.isDirty)) this.#updateSlider();
  }

  /* Value that is valid as long as none is stated. */
  placeholder() {
    const { address, field, store } = this;
    const preset = defaultOf(field);
    const si = store.header?.numbers?.[address]?.value;
    // The numbers of the last run are not those of a circuit with errors.
    if (preset || si === undefined || store.runErrors.length || field.type !== "number") {
      // Fields that a model can set are required only as long as the circuit says so.
      const isMissing = this.isRequired || store.errors.some(({ address: place }) => this.concerns(bare(place)));
      return preset || text(isMissing ? "form.required" : "form.optional");
    }
    const number = fromSi(si, field.unit, field.units[0], store.units, ambientOf(store.state.view, store.units));
    return text("form.effective", { value: withUnit(number, field.units[0]) });
  }

  #help() {
    const { field, store } = this;
    const preset = defaultOf(field);
    const isSpoken = field.note && field.note !== "default";
    const source = [text(`form.source_${field.source ?? "given"}`), isSpoken ? field.note : ""].filter(Boolean).join(": ");
    return [
      field.doc === this.label ? "" : field.doc.replaceAll("`", ""),
      field.type === "number" ? limitsOf(field, store.units).join(", ") : "",
      preset ? text("form.default", { value: field.type === "number" ? `${preset} (${source})` : preset }) : "",
    ].filter(Boolean).join(" · ");
  }

  /* Only numbers have a source. */
  #addOrigin({ type }) {
    this.origin = new SourceEditor(this.fullName, value => this.#write(value));
    if (type !== "number") return;
    this.head.append(this.origin.button);
    this.value.after(this.origin.element);
  }

  #setting(value) { return this.addresses.map(address => ({ op: "set", address, value })); }

  #write(value) { return this.store.apply(this.#setting(value)); }

  /* --- Unit --- */

  #addUnit() {
    this.unit = make("select", {
      class: "unit", "aria-label": text("form.unit_of", { name: this.fullName }), onchange: () => this.#convert(),
    });
    this.value.append(this.unit);
    this.slider = make("input", {
      type: "range", class: "slider", "data-slider": this.address, min: 0, max: STEPS, step: 1, "aria-label": text("form.slider_of", { name: this.fullName }),
      oninput: () => this.#slide(), onchange: () => this.#finishSlide(), onblur: () => this.#finishSlide(true),
    });
    this.value.after(this.slider);
  }

  #updateUnit() {
    const { field, stated } = this;
    // A chosen unit stays as long as no value is stated; the unit of a wrong value is not used for the next one.
    let present = (stated === undefined && field.units.includes(this.unit.value)) ? this.unit.value : unitOf(field, stated);
    const isWrong = this.store.errors.some(({ address }) => this.concerns(bare(address)));
    if (isWrong && !isUnitOf(field, present, this.store.units)) present = unitOf(field, undefined);
    const names = [...new Set([...field.units, present])];
    if ([...this.unit.options].map(option => option.value).join("|") !== names.join("|")) {
      this.unit.replaceChildren(...names.map(value => make("option", { value }, value || text("form.no_unit"))));
    }
    this.unit.value = present;
    this.unit.hidden = names.length === 1 && !names[0];
  }

  async #convert() {
    const { field, stated, store } = this;
    if (stated === undefined) return;
    const unit = this.unit.value, ambient = ambientOf(store.state.view, store.units);
    const si = store.header?.numbers?.[this.address]?.value;
    const other = si === undefined ? null : fromSi(si, field.unit, unit, store.units, ambient);
    const typed = converted(plainValue(stated), field.unit, unit, store.units, ambient)
      ?? (other === null ? null : withUnit(other, unit));
    if (typed === null) {
      this.refuse(text("form.no_conversion", { unit: unitOf(field, stated) }));
      this.#updateUnit();
      return;
    }
    const value = unit ? typed : Number(typed);
    await this.#write(isSourced(stated) ? { ...stated, value } : value);
  }

  /* --- Slider --- */

  #updateSlider() {
    const { field, stated, store } = this;
    const plain = plainValue(stated);
    this.range = stated === undefined ? null : rangeOf(field, plain, store.units, ambientOf(store.state.view, store.units));
    this.slider.hidden = !this.range;
    if (!this.range) return;
    this.slider.value = positionOf(parseFloat(plain), this.range);
    this.slider.setAttribute("aria-valuetext", textOf(plain));
  }

  #slide() {
    const { field, store } = this;
    this.isSliding = true;
    const typed = textAt(Number(this.slider.value), this.range);
    this.input.value = typed;
    this.slider.setAttribute("aria-valuetext", typed);
    const si = siOf(typed, field.unit, store.units, ambientOf(store.state.view, store.units));
    this.isLive = si !== null && this.addresses.map(address => store.number(address, si)).every(Boolean);
    if (!this.isLive) store.apply(this.operations(typed), { continues: true });
    clearTimeout(this.#timer);
  }

  /* Write the number of the slider: at once after the mouse, later after a key, since more keys may follow. */
  #finishSlide(isLast = false) {
    clearTimeout(this.#timer);
    this.isSliding = false;
    if (!this.isDirty) {
      this.#updateSlider();
      return;
    }
    if (isLast || !this.slider.matches(":focus-visible")) this.commit();
    else this.#timer = setTimeout(() => this.commit(), QUIET);
  }

  options() { return this.isLive === false ? { continues: true } : {}; }

  restore() {
    if (this.isLive) for (const address of this.addresses) this.store.number(address, null);
    clearTimeout(this.#timer);
    super.restore();
    if (this.slider) this.#updateSlider();
  }

  /* A typed number reaches the model at once; the text follows. */
  async commit() {
    if (this.isDirty && this.isLive === undefined && this.input.value !== this.refusedText) this.#showAtOnce();
    await super.commit();
    this.isLive = undefined;
  }

  #showAtOnce() {
    const { field, store, unit } = this;
    const value = field.type === "number" ? valueOf(field, this.input.value, unit.value, this.stated) : null;
    const si = value === null ? null : siOf(value, field.unit, store.units, ambientOf(store.state.view, store.units));
    if (si !== null && isWithin(field, si)) for (const address of this.addresses) store.number(address, si);
  }
}

/* True if an SI value is within the limits of a field. */
function isWithin({ low = -Infinity, high = Infinity, above = -Infinity, below = Infinity }, si) {
  return Number.isFinite(si) && low <= si && si <= high && above < si && si < below;
}
