/* Symbols of parts: the SVG text of the palette is parsed once and cloned. */

const SVG = "http://www.w3.org/2000/svg";
const parsed = new Map();

/* New SVG element with attributes. */
export function svgElement(tag, attributes = {}, parent = null) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return parent ? parent.appendChild(element) : element;
}

/* New HTML element with properties. */
export function htmlElement(tag, properties = {}, parent = null) {
  const element = Object.assign(document.createElement(tag), properties);
  return parent ? parent.appendChild(element) : element;
}

/* Strokes of a symbol as new elements. */
export function strokesOf(svg) {
  if (!parsed.has(svg)) {
    const file = new DOMParser().parseFromString(`<svg xmlns="${SVG}">${svg}</svg>`, "image/svg+xml");
    parsed.set(svg, [...file.documentElement.children]);
  }
  return parsed.get(svg).map(stroke => document.importNode(stroke, true));
}

/* Set the tooltip of an SVG element; an empty text removes it. */
export function setTitle(element, words) {
  let title = [...element.children].find(child => child.tagName === "title");
  if (!words) { title?.remove(); return; }
  title ??= element.insertBefore(svgElement("title"), element.firstChild);
  if (title.textContent !== words) title.textContent = words;
}
