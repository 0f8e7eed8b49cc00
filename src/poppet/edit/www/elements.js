/* Elements of the form. */

let count = 0;

/* Return an id that no other element has. */
export function newId() { return `f${++count}`; }

/* Return a new element. Keys of `properties` that begin with "on" are listeners, `class` and names with a hyphen are
   attributes, others are properties; children are elements or texts, null is omitted. */
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === null || value === undefined) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "class" || name === "for" || name === "list" || name.includes("-")) element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children.filter(child => child !== null && child !== undefined));
  return element;
}

/* Set the text of an element, which is hidden if the text is empty. */
export function show(element, content) {
  if (element.textContent !== content) element.textContent = content;
  element.hidden = !content;
}

/* Fill the options of a select element or of the list of an input; the content is unchanged if they are the same. */
export function fillOptions(list, choices, nameOf = choice => choice) {
  const present = [...list.children].map(option => option.value);
  if (present.length === choices.length && choices.every((choice, k) => choice === present[k])) return;
  list.replaceChildren(...choices.map(value => make("option", { value }, list.tagName === "SELECT" ? nameOf(value) : null)));
}
